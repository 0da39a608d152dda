/* SPDX-License-Identifier: MIT */
/*
 * Displays of a desktop: a picture goes to a file or a pipe as a screen would show it. RGB565 is widened to 8 bits by
 * repeating its upper bits, 4-bit grey by repeating its nibble.
 *
 *     struct host_display out = {.display.ops = &png_display, .path = "cube.png", .frames = 1};
 *     out.display.ops->open(&out.display, 320, 240, HAL_RGB565);
 *
 * A file appears under its name when close(keep = 1) has succeeded, and not at all otherwise.
 */
#ifndef HOST_DISPLAYS_H
#define HOST_DISPLAYS_H

#include "display.h"
#include "host/sink.h"

/* As many pictures as come, at least one: an animated PNG in a file, not in a pipe, since the number stands in front.
 */
#define HOST_FRAMES_ANY UINT32_MAX

struct host_display {
    struct hal_display display;
    const char *path; /* "-": standard output (not for folder_display). Stays the caller's */
    uint32_t frames;  /* png_display: how many pictures will come; above 1 the file is an animated PNG */
    uint32_t rate;    /* y4m_display: pictures a second */
    /* animated PNG: what the next picture replaces of the one before, set before frame_begin(); flush() is then given
     * that alone. The first is whole; 0 wide is whole too. */
    struct host_part {
        uint16_t x, y, width, height;
    } part;

    /* the display's own */
    struct sink sink;
    uint16_t width, height;
    enum hal_pixel_format format;
    uint32_t count;  /* pictures done */
    uint8_t *pixels; /* a row, or for y4m_display a picture, of 8-bit samples */
    struct png_coder *coder;
    struct folder *folder; /* folder_display */
};

extern const struct hal_display_ops
    null_display;                                /* takes a bare struct hal_display; shows nothing: the porting guide */
extern const struct hal_display_ops raw_display; /* the bands' bytes as they are, without padding between rows */
extern const struct hal_display_ops ppm_display; /* binary PPM, for grey PGM; pictures follow one another */
extern const struct hal_display_ops png_display; /* PNG, or animated PNG that repeats for ever */
extern const struct hal_display_ops y4m_display; /* YUV4MPEG2 4:4:4, or mono for grey; BT.601, limited range */
extern const struct hal_display_ops folder_display; /* path/frame-0000.png and so on; makes the folder */

/* What every open() of a desktop display does first: remembers the size and format and allocates `pixels` bytes.
 * HAL_E_ARGUMENT or HAL_E_FULL. */
int host_display_prepare(struct host_display *host, uint16_t width, uint16_t height, enum hal_pixel_format format,
                         uint32_t pixels);

/* And what every close() does last: frees, closes the sink, keeping the file or not. */
int host_display_finish(struct host_display *host, int keep);

/* Samples a pixel as shown: 1 (grey) or 3. */
unsigned host_display_samples(enum hal_pixel_format format);

/* Writes a row of `width` pixels as shown, host_display_samples() bytes a pixel. */
void host_display_widen(enum hal_pixel_format format, const void *row, uint16_t width, uint8_t *out);

#endif

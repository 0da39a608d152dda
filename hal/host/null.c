/* SPDX-License-Identifier: MIT */
/*
 * The display that shows nothing, and how to write one that does.
 *
 * Copy this file, rename it, and give your display a struct of its own whose first member is struct hal_display:
 *
 *     struct my_panel { struct hal_display display; struct hal_bus *bus; };
 *
 * Every function receives that first member; cast it back. Keep all state there, so that a board can have two displays,
 * and use nothing but the interfaces of hal/: a panel that talks through hal/bus.h runs on every machine that has one.
 */
#include "host/displays.h"

/* Wake the panel and set its pixel format. Refuse with HAL_E_ARGUMENT what it cannot show: better no picture than a
 * wrong one. A failure leaves nothing behind, since close() is then not called. */
static int null_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    (void)display, (void)format;
    return width && height ? 0 : HAL_E_ARGUMENT;
}

/* Optional (may be a null pointer). Set the window to the whole picture and, if the panel has a tearing signal, wait
 * for it. Once here is cheaper than once a band. */
static int null_frame_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    (void)display, (void)index, (void)delay_ms;
    return 0;
}

/* Send `rows` rows, each `stride` bytes after the one before. The bands of a picture come in order and without gaps, so
 * a panel whose window is set needs only the bytes; RGB565 is in the CPU's byte order, and most panels want the high
 * byte first: let the SPI controller send 16-bit words.
 *
 * To draw one band while another is sent, wait here for the transfer before, start this one and return. The renderer
 * has two bands and comes back with the other, so there is never more than one under way. */
static int null_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    (void)display, (void)pixels, (void)y, (void)rows, (void)stride;
    return 0;
}

/* Optional. Wait for the last transfer. */
static int null_frame_end(struct hal_display *display)
{
    (void)display;
    return 0;
}

/* Blank the panel, let the bus go. Called exactly once after open() succeeded, also after an error, and then with keep
 * 0: a file would be removed; a panel has nothing to do differently. */
static int null_close(struct hal_display *display, int keep)
{
    (void)display, (void)keep;
    return 0;
}

const struct hal_display_ops null_display = {null_open, null_frame_begin, null_flush, null_frame_end, null_close};

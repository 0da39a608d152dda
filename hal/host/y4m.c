/* SPDX-License-Identifier: MIT */
/* YUV4MPEG2, as mjpegtools' yuv4mpeg(5) describes it: players and encoders read it from a pipe. */
#include "host/displays.h"

#include <stdio.h>

static int y4m_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    struct host_display *host = (struct host_display *)display;
    unsigned samples = host_display_samples(format);
    char head[96];
    if (host->rate == 0)
        return HAL_E_ARGUMENT;
    /* a row as shown, then the planes of the picture */
    int result = host_display_prepare(host, width, height, format, samples * width * (height + 1u));
    if (result)
        return result;
    int size = snprintf(head, sizeof head, "YUV4MPEG2 W%u H%u F%u:1 Ip A1:1 C%s XCOLORRANGE=LIMITED\n", width, height,
                        (unsigned)host->rate, samples == 3 ? "444" : "mono");
    if (!(result = sink_open(&host->sink, host->path)))
        result = sink_write(&host->sink, head, (size_t)size);
    if (result)
        host_display_finish(host, 0);
    return result;
}

/* BT.601 with luma in 16..235 and chroma in 16..240: the matrix times 2^16 / 255 * 219 (or 224), rounded so that the
 * rows still add up to white and to neutral grey. */
static void y4m_convert(const uint8_t *rgb, uint8_t *luma, uint8_t *cb, uint8_t *cr)
{
    int32_t r = rgb[0], g = rgb[1], b = rgb[2];
    *luma = (uint8_t)((16829 * r + 33039 * g + 6416 * b + (16 << 16) + 32768) >> 16);
    *cb = (uint8_t)((-9714 * r - 19070 * g + 28784 * b + (128 << 16) + 32768) >> 16);
    *cr = (uint8_t)((28784 * r - 24103 * g - 4681 * b + (128 << 16) + 32768) >> 16);
}

static int y4m_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct host_display *host = (struct host_display *)display;
    unsigned samples = host_display_samples(host->format);
    size_t plane = (size_t)host->width * host->height;
    uint8_t *planes = host->pixels + samples * host->width;
    for (uint16_t row = 0; row < rows; row++) {
        uint8_t *luma = planes + (size_t)(y + row) * host->width;
        const uint8_t *shown = host->pixels;
        host_display_widen(host->format, (const uint8_t *)pixels + (size_t)row * stride, host->width, host->pixels);
        for (uint16_t x = 0; x < host->width; x++, luma++, shown += samples) {
            if (samples == 3)
                y4m_convert(shown, luma, luma + plane, luma + 2 * plane);
            else
                *luma = (uint8_t)(16 + (219 * *shown + 127) / 255);
        }
    }
    return 0;
}

static int y4m_frame_end(struct hal_display *display)
{
    struct host_display *host = (struct host_display *)display;
    unsigned samples = host_display_samples(host->format);
    int result = sink_write(&host->sink, "FRAME\n", 6);
    if (!result)
        result =
            sink_write(&host->sink, host->pixels + samples * host->width, (size_t)samples * host->width * host->height);
    return result;
}

static int y4m_close(struct hal_display *display, int keep)
{
    return host_display_finish((struct host_display *)display, keep);
}

const struct hal_display_ops y4m_display = {
    .open = y4m_open, .flush = y4m_flush, .frame_end = y4m_frame_end, .close = y4m_close};

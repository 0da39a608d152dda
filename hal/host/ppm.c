/* SPDX-License-Identifier: MIT */
#include "host/displays.h"

#include <stdio.h>

static int ppm_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    struct host_display *host = (struct host_display *)display;
    int result = host_display_prepare(host, width, height, format, 3u * width);
    if (!result && (result = sink_open(&host->sink, host->path)))
        host_display_finish(host, 0);
    return result;
}

static int ppm_frame_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    struct host_display *host = (struct host_display *)display;
    char head[32];
    (void)index, (void)delay_ms;
    int size = snprintf(head, sizeof head, "P%c\n%u %u\n255\n", host_display_samples(host->format) == 3 ? '6' : '5',
                        host->width, host->height);
    return sink_write(&host->sink, head, (size_t)size);
}

static int ppm_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct host_display *host = (struct host_display *)display;
    size_t bytes = (size_t)host_display_samples(host->format) * host->width;
    int result = 0;
    (void)y;
    for (uint16_t row = 0; row < rows && !result; row++) {
        host_display_widen(host->format, (const uint8_t *)pixels + (size_t)row * stride, host->width, host->pixels);
        result = sink_write(&host->sink, host->pixels, bytes);
    }
    return result;
}

static int ppm_close(struct hal_display *display, int keep)
{
    return host_display_finish((struct host_display *)display, keep);
}

const struct hal_display_ops ppm_display = {
    .open = ppm_open, .frame_begin = ppm_frame_begin, .flush = ppm_flush, .close = ppm_close};

/* SPDX-License-Identifier: MIT */
#include "host/displays.h"

static size_t raw_row_bytes(const struct host_display *host)
{
    switch (host->format) {
    case HAL_RGB565:
        return 2u * host->width;
    case HAL_RGB888:
        return 3u * host->width;
    case HAL_GREY8:
        return host->width;
    case HAL_GREY4:
        break;
    }
    return (host->width + 1u) / 2;
}

static int raw_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    struct host_display *host = (struct host_display *)display;
    int result = host_display_prepare(host, width, height, format, 0);
    if (!result && (result = sink_open(&host->sink, host->path)))
        host_display_finish(host, 0);
    return result;
}

static int raw_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct host_display *host = (struct host_display *)display;
    int result = 0;
    (void)y;
    for (uint16_t row = 0; row < rows && !result; row++)
        result = sink_write(&host->sink, (const uint8_t *)pixels + (size_t)row * stride, raw_row_bytes(host));
    return result;
}

static int raw_close(struct hal_display *display, int keep)
{
    return host_display_finish((struct host_display *)display, keep);
}

const struct hal_display_ops raw_display = {.open = raw_open, .flush = raw_flush, .close = raw_close};

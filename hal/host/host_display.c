/* SPDX-License-Identifier: MIT */
#include "host/displays.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

int host_display_prepare(struct host_display *host, uint16_t width, uint16_t height, enum hal_pixel_format format,
                         uint32_t pixels)
{
    if (width == 0 || height == 0 || format > HAL_GREY4)
        return HAL_E_ARGUMENT;
    host->sink = (struct sink){0};
    host->coder = NULL;
    host->folder = NULL;
    host->width = width;
    host->height = height;
    host->format = format;
    host->count = 0;
    host->pixels = malloc(pixels ? pixels : 1);
    return host->pixels ? 0 : HAL_E_FULL;
}

int host_display_finish(struct host_display *host, int keep)
{
    free(host->pixels);
    host->pixels = NULL;
    return sink_close(&host->sink, keep);
}

unsigned host_display_samples(enum hal_pixel_format format)
{
    return format == HAL_RGB565 || format == HAL_RGB888 ? 3 : 1;
}

void host_display_widen(enum hal_pixel_format format, const void *row, uint16_t width, uint8_t *out)
{
    const uint8_t *bytes = row;
    switch (format) {
    case HAL_RGB565:
        for (uint16_t x = 0; x < width; x++) {
            uint16_t pixel;
            memcpy(&pixel, bytes + 2 * x, sizeof pixel);
            unsigned r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;
            *out++ = (uint8_t)(r << 3 | r >> 2);
            *out++ = (uint8_t)(g << 2 | g >> 4);
            *out++ = (uint8_t)(b << 3 | b >> 2);
        }
        break;
    case HAL_RGB888:
        memcpy(out, bytes, 3u * width);
        break;
    case HAL_GREY8:
        memcpy(out, bytes, width);
        break;
    case HAL_GREY4:
        for (uint16_t x = 0; x < width; x++)
            out[x] = (uint8_t)((x & 1 ? bytes[x / 2] & 15 : bytes[x / 2] >> 4) * 17);
        break;
    }
}

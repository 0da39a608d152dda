/* SPDX-License-Identifier: MIT */
#include "view/pixels.h"

#include "glint.h"
#include "host/displays.h"
#include "view/unpack.h"

uint32_t pixels_width(const struct frames_picture *p, unsigned rotation)
{
    return rotation & 1 ? p->height : p->width;
}

uint32_t pixels_height(const struct frames_picture *p, unsigned rotation)
{
    return rotation & 1 ? p->width : p->height;
}

void pixels_turn(const struct frames_picture *p, unsigned rotation, uint32_t *out, size_t stride)
{
    uint8_t row[GLINT_MAX_SIZE * 3];
    const enum hal_pixel_format format = (enum hal_pixel_format)p->format;
    const unsigned samples = host_display_samples(format), second = samples / 3, third = 2 * second;
    const size_t bytes = unpack_row_bytes(p->format, p->width), right = p->width - 1u, below = p->height - 1u;
    for (size_t y = 0; y < p->height; y++) {
        /* where the row's first pixel goes, and how far apart they are; forwards modulo 2^n */
        const size_t starts[4] = {y * stride, below - y, (below - y) * stride + right, right * stride + y};
        const size_t steps[4] = {1, stride, (size_t)-1, (size_t)0 - stride};
        size_t at = starts[rotation & 3];
        host_display_widen(format, p->pixels + y * bytes, p->width, row);
        for (const uint8_t *in = row, *end = row + (size_t)p->width * samples; in != end; in += samples) {
            out[at] = 0xFF000000u | (uint32_t)in[0] << 16 | (uint32_t)in[second] << 8 | in[third];
            at += steps[rotation & 3];
        }
    }
}

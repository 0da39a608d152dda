/* SPDX-License-Identifier: MIT */
/* A picture's chunk with its duration stands before its pixels, and how long it lasts is known when the next one comes:
 * so each is held until then, next to the one before it, from which its changed part is found. */
#include "view/record_kinds.h"
#include "view/unpack.h"

#include <stdlib.h>
#include <string.h>

/* Bytes that can be told apart, and the pixels in them. */
struct apng_unit {
    unsigned bytes, pixels;
};

static const struct apng_unit apng_units[STREAM_FORMATS] = {{2, 1}, {3, 1}, {1, 1}, {1, 2}};

/* The smallest rectangle that holds every change; where there is none, one pixel or two, since none is not allowed. */
static struct host_part apng_changed(const struct record *r)
{
    const struct apng_unit unit = apng_units[r->host.format];
    size_t stride = unpack_row_bytes((enum stream_format)r->host.format, r->host.width);
    size_t top = 0, bottom = r->host.height, left = stride, right = 0;
    const uint8_t *a = r->before, *b = r->held;
    while (top < bottom && memcmp(a + top * stride, b + top * stride, stride) == 0)
        top++;
    while (bottom > top && memcmp(a + (bottom - 1) * stride, b + (bottom - 1) * stride, stride) == 0)
        bottom--;
    for (size_t y = top; y < bottom; y++) {
        const uint8_t *old = a + y * stride, *now = b + y * stride;
        for (size_t x = 0; x < left; x++)
            left = old[x] == now[x] ? left : x;
        for (size_t x = stride; x > right; x--)
            right = old[x - 1] == now[x - 1] ? right : x;
    }
    if (top == bottom)
        top = left = 0, bottom = right = 1;
    size_t first = left / unit.bytes * unit.pixels, last = (right + unit.bytes - 1) / unit.bytes * unit.pixels;
    last = last < r->host.width ? last : r->host.width;
    return (struct host_part){(uint16_t)first, (uint16_t)top, (uint16_t)(last - first), (uint16_t)(bottom - top)};
}

/* The held picture, which ends at `end_us`. Both moments are rounded, not the time between: errors do not add up. */
static int apng_write(struct record *r, uint64_t end_us)
{
    const struct hal_display_ops *ops = r->host.display.ops;
    const struct apng_unit unit = apng_units[r->host.format];
    size_t stride = unpack_row_bytes((enum stream_format)r->host.format, r->host.width);
    uint32_t delay_ms = (uint32_t)((end_us + 500) / 1000 - (r->held_us + 500) / 1000);
    struct host_part part = {0, 0, r->host.width, r->host.height};
    if (r->written)
        part = apng_changed(r);
    const uint8_t *pixels = r->held + part.y * stride + part.x / unit.pixels * unit.bytes;
    r->host.part = part;
    int result = ops->frame_begin(&r->host.display, r->written++, delay_ms);
    if (!result)
        result = ops->flush(&r->host.display, pixels, 0, part.height, (uint32_t)stride);
    return result ? result : ops->frame_end(&r->host.display);
}

static int apng_picture(struct record *r, const struct frames_picture *p)
{
    size_t bytes = unpack_row_bytes(p->format, p->width) * p->height;
    int result = r->held ? apng_write(r, r->at_us) : 0;
    uint8_t *free_one = r->before;
    if (!result && !free_one)
        free_one = malloc(bytes);
    if (result || !free_one)
        return result ? result : HAL_E_FULL;
    r->before = r->held;
    r->held = memcpy(free_one, p->pixels, bytes);
    r->held_us = r->at_us;
    return 0;
}

const struct record_kind apng_kind = {{"png", "apng"}, &png_display, apng_picture, apng_write};

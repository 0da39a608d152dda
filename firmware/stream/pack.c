/* SPDX-License-Identifier: MIT */
#include "stream/pack.h"

#include "fixed/fixed.h"

#include <stddef.h>

#define PACK_INLINE static inline __attribute__((always_inline))
/* A round of the loop writes at most a copy, a pixel of 3 bytes with its head, and 1 byte more for each 512 pixels. */
#define PACK_MARGIN 6u
#define PACK_LONG   64u /* bytes: a copy for which no better one is looked for */

/* Adds the difference between a pixel and the one before: after a single byte in 0..PACK_STEPS - 1 the copy of one
 * pixel may be written into it. `single` says that this stands in front of `out`. */
typedef uint8_t *pack_difference(uint8_t *out, uint32_t before, uint32_t pixel, int single);

PACK_INLINE uint32_t pack_load(const uint8_t *at, unsigned size)
{
    if (size == 2)
        return *(const uint16_t *)(const void *)at;
    return size == 1 ? *at : (uint32_t)(at[0] | at[1] << 8 | at[2] << 16);
}

/* Where pixels end to be those at `other`. */
PACK_INLINE const uint8_t *pack_alike(const uint8_t *at, const uint8_t *end, const uint8_t *other, unsigned size)
{
    for (; at != end && pack_load(at, size) == pack_load(other, size); other += size)
        at += size;
    return at;
}

static uint8_t *pack_copy(uint8_t *out, unsigned kind, uint32_t count)
{
    uint32_t more = (count - 1) >> 3;
    *out++ = (uint8_t)(kind << 5 | PACK_COPY | ((count - 1) & 7));
    for (; more > 64; more -= 64)
        *out++ = PACK_MORE | 63;
    if (more)
        *out++ = (uint8_t)(PACK_MORE | (more - 1));
    return out;
}

/* The longest copy that begins at `at`: its end and, if it has a pixel, its kind. */
PACK_INLINE const uint8_t *pack_longest(const struct pack_rows *rows, const uint8_t *at, const uint8_t *end,
                                        uint32_t before, unsigned size, unsigned *kind)
{
    const uint8_t *longest = at, *stop;
    uint32_t pixel = pack_load(at, size), offset = (uint32_t)(at - rows->pixels);
    if (rows->last && pack_load(rows->last + offset, size) == pixel) {
        longest = pack_alike(at, end, rows->last + offset, size);
        *kind = PACK_LAST;
        if ((uint32_t)(longest - at) >= PACK_LONG)
            return longest;
    }
    if (offset >= rows->stride && pack_load(at - rows->stride, size) == pixel &&
        (stop = pack_alike(at, end, at - rows->stride, size)) > longest) {
        longest = stop;
        *kind = PACK_ABOVE;
    }
    if (pixel != before) /* mostly: worth a test of its own */
        return longest;
    for (stop = at; stop != end && pack_load(stop, size) == before; stop += size)
        ;
    if (stop > longest) {
        longest = stop;
        *kind = PACK_LEFT;
    }
    return longest;
}

/* A band, a copy as long as there is one or else a difference at a time. */
PACK_INLINE uint32_t pack_band(const struct pack_rows *rows, unsigned size, pack_difference *difference)
{
    const uint8_t *at = rows->pixels, *end = at + rows->bytes;
    uint8_t *out = rows->out, *single = 0; /* a step without a copy, just written */
    const uint8_t *brim;                   /* up to it there is room for a round */
    uint32_t before = 0;
    if (rows->room < PACK_MARGIN)
        return 0;
    brim = out + rows->room - PACK_MARGIN;
    while (at != end) {
        unsigned kind = 0;
        const uint8_t *stop = pack_longest(rows, at, end, before, size, &kind);
        uint32_t count = (uint32_t)(stop - at) / size;
        if (brim - out < (ptrdiff_t)(count >> 9))
            return 0;
        if (count) {
            at = stop;
            before = pack_load(at - size, size);
            if (single)
                *single = (uint8_t)(*single | kind << 5);
            if (count -= single != 0)
                out = pack_copy(out, kind, count);
            single = 0;
        } else {
            uint32_t pixel = pack_load(at, size);
            uint8_t *next = difference(out, before, pixel, single != 0);
            single = next == out + 1 && *out < PACK_STEPS ? out : 0;
            out = next;
            before = pixel;
            at += size;
        }
    }
    return (uint32_t)(out - rows->out);
}

/* Pixels that differ: a pixel like the one before is copied. Differences of red, green and blue; red and blue are
 * expected to go along with green >> lag. Each is a signed number modulo its channel's range, so that the sum comes
 * back. */
PACK_INLINE uint8_t *pack_colour(uint8_t *out, int red, int green, int blue, unsigned lag, uint32_t pixel,
                                 unsigned size)
{
    int sign = green < 0, r = sign ? -red : red, g = sign ? -green : green, b = sign ? -blue : blue;
    if (g != 0 && g <= 2 && (unsigned)(r | b) <= 1) {
        *out++ = (uint8_t)(sign << 3 | (g - 1) << 2 | (int)((unsigned)r << 1) | b);
        return out;
    }
    if (g == 0 && (unsigned)(red + 1) <= 2 && (unsigned)(blue + 1) <= 2) {
        int step = (red + 1) * 3 + blue + 1; /* not 4 */
        *out++ = (uint8_t)(16 + step - (step > 4));
        return out;
    }
    red += 8 - (green >> lag);
    blue += 8 - (green >> lag);
    if ((unsigned)(green + 32) < 64 && (unsigned)(red | blue) < 16) {
        *out++ = (uint8_t)(PACK_WIDE | (green & 63));
        *out++ = (uint8_t)((unsigned)red << 4 | (unsigned)blue);
    } else {
        *out++ = PACK_LITERAL;
        for (; size; size--, pixel >>= 8)
            *out++ = (uint8_t)(pixel & 255);
    }
    return out;
}

/* The low `bits` of a difference as a signed number. */
FX_WRAPS PACK_INLINE int pack_signed(uint32_t to, uint32_t from, unsigned bits)
{
    return (int32_t)((to - from) << (32 - bits)) >> (32 - bits);
}

PACK_INLINE uint8_t *pack_difference_rgb565(uint8_t *out, uint32_t before, uint32_t pixel, int single)
{
    (void)single;
    return pack_colour(out, pack_signed(pixel >> 11, before >> 11, 5), pack_signed(pixel >> 5, before >> 5, 6),
                       pack_signed(pixel, before, 5), 1, pixel, 2);
}

PACK_INLINE uint8_t *pack_difference_rgb888(uint8_t *out, uint32_t before, uint32_t pixel, int single)
{
    (void)single;
    return pack_colour(out, pack_signed(pixel, before, 8), pack_signed(pixel >> 8, before >> 8, 8),
                       pack_signed(pixel >> 16, before >> 16, 8), 0, pixel, 3);
}

/* Two small differences after one another share a byte. */
PACK_INLINE uint8_t *pack_difference_grey8(uint8_t *out, uint32_t before, uint32_t pixel, int single)
{
    int difference = pack_signed(pixel, before, 8);
    if (single && (unsigned)(difference + 4) < 8 && (unsigned)(out[-1] - 8) < 7) {
        int first = out[-1] - (out[-1] < 12 ? 12 : 11);
        out[-1] = (uint8_t)(PACK_WIDE | (first & 7) << 3 | (difference & 7));
    } else if ((unsigned)(difference + 12) <= 24) {
        *out++ = (uint8_t)(difference + (difference < 0 ? 12 : 11));
    } else {
        *out++ = PACK_LITERAL;
        *out++ = (uint8_t)pixel;
    }
    return out;
}

PACK_INLINE uint8_t *pack_difference_grey4(uint8_t *out, uint32_t before, uint32_t pixel, int single)
{
    int left = pack_signed(pixel >> 4, before >> 4, 4), right = pack_signed(pixel, before, 4);
    int step = (left + 2) * 5 + right + 2;
    (void)single;
    if ((unsigned)(left + 2) <= 4 && (unsigned)(right + 2) <= 4) {
        *out++ = (uint8_t)(step - (step > 12));
    } else if ((unsigned)(left + 4) < 8 && (unsigned)(right + 4) < 8) {
        *out++ = (uint8_t)(PACK_WIDE | (left & 7) << 3 | (right & 7));
    } else {
        *out++ = PACK_LITERAL;
        *out++ = (uint8_t)pixel;
    }
    return out;
}

static uint32_t pack_band_rgb565(const struct pack_rows *rows)
{
    return pack_band(rows, 2, pack_difference_rgb565);
}

static uint32_t pack_band_rgb888(const struct pack_rows *rows)
{
    return pack_band(rows, 3, pack_difference_rgb888);
}

static uint32_t pack_band_grey8(const struct pack_rows *rows)
{
    return pack_band(rows, 1, pack_difference_grey8);
}

static uint32_t pack_band_grey4(const struct pack_rows *rows)
{
    return pack_band(rows, 1, pack_difference_grey4);
}

const struct pack_format pack_rgb565 = {pack_band_rgb565, STREAM_RGB565, 16};
const struct pack_format pack_rgb888 = {pack_band_rgb888, STREAM_RGB888, 24};
const struct pack_format pack_grey8 = {pack_band_grey8, STREAM_GREY8, 8};
const struct pack_format pack_grey4 = {pack_band_grey4, STREAM_GREY4, 4};

/* SPDX-License-Identifier: MIT */
/*
 * Small bands, all of them: what is packed comes back, with and without a last picture; in any room it is the same or
 * refused, and no byte beside the room changes. Then every pair of neighbours, and as packed bytes all of up to three,
 * of which none writes beside the band.
 */
#include "stream/pack.h"
#include "view/unpack.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define GUARD  0xA5
#define MARGIN 8u /* guarded bytes behind whatever is written */
#define PIXELS 5u

static const struct pack_format *const formats[STREAM_FORMATS] = {&pack_rgb565, &pack_rgb888, &pack_grey8, &pack_grey4};
static const char *const names[STREAM_FORMATS] = {"rgb565", "rgb888", "grey8", "grey4"};
static unsigned failed;

static unsigned size_of(enum stream_format format)
{
    return formats[format]->bits > 8 ? formats[format]->bits / 8 : 1;
}

static void check(int good, const char *what, enum stream_format format)
{
    if (!good && failed++ < 10)
        printf("FAIL %s of %s\n", what, names[format]);
}

static int guarded(const uint8_t *at)
{
    for (unsigned i = 0; i < MARGIN; i++)
        if (at[i] != GUARD)
            return 0;
    return 1;
}

/* Packed with room for all, and back. How many bytes. */
static uint32_t round_trip(enum stream_format format, const uint8_t *pixels, const uint8_t *last, uint32_t bytes,
                           uint32_t stride, uint8_t *out)
{
    _Alignas(4) uint8_t back[3 * PIXELS + MARGIN];
    const uint32_t room = 2 * bytes + 6;
    memset(out, GUARD, room + MARGIN);
    memset(back, GUARD, bytes + MARGIN);
    const struct pack_rows rows = {pixels, last, bytes, stride, out, room};
    const uint32_t count = formats[format]->pack(&rows);
    check(count > 0 && count <= room && guarded(out + room), "room for all", format);
    const struct unpack_rows packed = {out, count, back, last, bytes, stride, format};
    check(unpack_rows(&packed) && memcmp(back, pixels, bytes) == 0 && guarded(back + bytes), "there and back", format);
    return count;
}

/* The same into every smaller room, of which the last 6 bytes may stay empty. */
static void rooms(enum stream_format format, const uint8_t *pixels, uint32_t bytes, uint32_t stride,
                  const uint8_t *whole, uint32_t count)
{
    uint8_t out[2 * 3 * PIXELS + 16 + MARGIN];
    for (uint32_t room = 0; room <= count + 6; room++) {
        memset(out, GUARD, room + MARGIN);
        const struct pack_rows rows = {pixels, NULL, bytes, stride, out, room};
        const uint32_t got = formats[format]->pack(&rows);
        check(guarded(out + room), "nothing beside the room", format);
        check((got == 0 && room < count + 6) || (got == count && memcmp(out, whole, count) == 0), "a room", format);
    }
}

/* Pixel `digit` of a band: 0, a small, a wide and a far difference from it. */
static void draw(uint8_t *pixels, unsigned size, unsigned code)
{
    static const uint8_t values[3][4][3] = {{{0}, {0x01}, {0x33}, {0xF7}},
                                            {{0}, {0x21, 0x08}, {0x04, 0x21}, {0x5A, 0xC3}},
                                            {{0}, {1, 2, 1}, {9, 12, 7}, {200, 90, 17}}};
    for (unsigned i = 0; i < PIXELS; i++, code >>= 2)
        memcpy(pixels + i * size, values[size - 1][code & 3], size);
}

static void bands(enum stream_format format)
{
    const unsigned size = size_of(format), all = 1u << 2 * PIXELS;
    _Alignas(4) uint8_t pixels[3 * PIXELS], last[3 * PIXELS];
    uint8_t out[2 * 3 * PIXELS + 6 + MARGIN];
    for (unsigned code = 0; code < all; code++) {
        draw(pixels, size, code);
        for (uint32_t width = 1; width <= PIXELS; width++) {
            uint32_t count = round_trip(format, pixels, NULL, PIXELS * size, width * size, out);
            rooms(format, pixels, PIXELS * size, width * size, out, count);
        }
        for (unsigned before = 0; before < all; before++) {
            draw(last, size, before);
            round_trip(format, pixels, last, PIXELS * size, 2 * size, out);
        }
    }
    printf("ok %s: %u bands of %u pixels, %u with a last picture\n", names[format], all * PIXELS, PIXELS, all * all);
}

/* A pixel and the next: all pairs of greys; of colours, all differences from a few. */
static void pairs(enum stream_format format)
{
    static const uint32_t firsts[] = {0, 0x5A, 0x8410, 0xFFFF, 0x123456, 0x808080, 0xFFFFFF};
    const unsigned size = size_of(format);
    const uint32_t all = 1u << 8 * size, begins = size == 1 ? all : sizeof firsts / sizeof *firsts;
    _Alignas(4) uint8_t pixels[6], out[2 * 6 + 6 + MARGIN];
    for (uint32_t i = 0; i < begins; i++)
        for (uint32_t next = 0; next < all; next++) {
            const uint32_t first = size == 1 ? i : firsts[i];
            for (unsigned k = 0; k < size; k++) {
                pixels[k] = (uint8_t)(first >> 8 * k);
                pixels[size + k] = (uint8_t)(next >> 8 * k);
            }
            round_trip(format, pixels, NULL, 2 * size, 2 * size, out);
        }
    printf("ok %s: %u pairs of neighbours\n", names[format], begins * all);
}

/* Packed bytes that nobody packed: what they draw stays in the band. */
static void any_bytes(enum stream_format format, int chained)
{
    const unsigned size = size_of(format), bytes = 4 * size;
    uint8_t pixels[12 + MARGIN], last[12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    unsigned good = 0;
    for (uint32_t count = 0; count <= 3; count++)
        for (uint32_t code = 0; code < 1u << 8 * count; code++) {
            const uint8_t packed[3] = {(uint8_t)code, (uint8_t)(code >> 8), (uint8_t)(code >> 16)};
            uint8_t *exact = malloc(count + !count); /* whose end the sanitizers know */
            memcpy(exact, packed, count);
            memset(pixels + bytes, GUARD, MARGIN);
            const struct unpack_rows rows = {exact, count, pixels, chained ? last : NULL, bytes, 2 * size, format};
            good += unpack_rows(&rows);
            check(guarded(pixels + bytes), "nothing beside the band", format);
            free(exact);
        }
    printf("ok %s%s: 16843009 packed bands of up to 3 bytes, of which %u are one\n", names[format],
           chained ? " with a last picture" : "", good);
}

int main(void)
{
    for (unsigned format = 0; format < STREAM_FORMATS; format++) {
        bands((enum stream_format)format);
        pairs((enum stream_format)format);
        any_bytes((enum stream_format)format, 0);
        any_bytes((enum stream_format)format, 1);
    }
    if (failed)
        printf("FAIL %u\n", failed);
    return failed != 0;
}

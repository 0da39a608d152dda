/* SPDX-License-Identifier: MIT */
/* Sums in steps of the output to pixels: clamp, round or dither, pack. */
#include "raster/raster.h"

/* Thresholds of the ordered dither (Bayer 4x4), in 1/16 step, about the middle. */
static const uint8_t bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

#define HALF_STEP (1u << 14)

/* Sums stay below (8 * 3 + 1) * 255 * 2^15 < 2^28 (eight lights and the ambient part): adding a step fits. */
static inline uint32_t level(uint32_t sum, uint32_t threshold, uint32_t top)
{
    uint32_t v = (sum + threshold) >> 15;
    return v > top ? top : v;
}

/* A format's pixel from its sums: a template, called with constants. */
static inline __attribute__((always_inline)) uint32_t pack(const uint32_t sum[3], uint32_t threshold, unsigned format)
{
    uint32_t first = level(sum[0], threshold, raster_top(format, 0));
    if (format == GLINT_GREY8 || format == GLINT_GREY4)
        return first;
    uint32_t second = level(sum[1], threshold, raster_top(format, 1)),
             third = level(sum[2], threshold, raster_top(format, 2));
    if (format == GLINT_RGB565)
        return first << 11 | second << 5 | third;
    return first << 16 | second << 8 | third;
}

static inline __attribute__((always_inline)) void put(uint8_t *row, int x, uint32_t colour, unsigned format)
{
    switch (format) {
    case GLINT_RGB565:
        ((uint16_t *)(void *)row)[x] = (uint16_t)colour;
        break;
    case GLINT_RGB888:
        row[3 * x] = (uint8_t)(colour >> 16);
        row[3 * x + 1] = (uint8_t)(colour >> 8);
        row[3 * x + 2] = (uint8_t)colour;
        break;
    case GLINT_GREY8:
        row[x] = (uint8_t)colour;
        break;
    default:
        row += x >> 1;
        *row = (uint8_t)(x & 1 ? (*row & 0xf0) | colour : (*row & 0x0f) | colour << 4);
    }
}

uint32_t raster_colour(const struct raster *r, const uint32_t sum[3])
{
    return pack(sum, HALF_STEP, r->format);
}

static inline __attribute__((always_inline)) void write_as(const struct raster *r, int x, int y, uint32_t mask,
                                                           unsigned format)
{
    uint8_t *row = r->pixels + (uint32_t)(y - r->y0) * r->stride;
    const uint8_t *dither = r->dither ? bayer[y & 3] : 0;
    if (!dither && (mask & (mask + 1)) == 0) { /* the run's first pixels, all: no bit to look at */
        for (const uint32_t *sum = r->sum[0]; mask; sum += 3, x++, mask >>= 1)
            put(row, x, pack(sum, HALF_STEP, format), format);
        return;
    }
    for (const uint32_t *sum = r->sum[0]; mask; sum += 3, x++, mask >>= 1)
        if (mask & 1)
            put(row, x, pack(sum, dither ? (uint32_t)(2 * dither[x & 3] + 1) << 10 : HALF_STEP, format), format);
}

void raster_write(struct raster *r, int x, int y, uint32_t mask)
{
    switch (r->format) {
    case GLINT_RGB565:
        write_as(r, x, y, mask, GLINT_RGB565);
        break;
    case GLINT_RGB888:
        write_as(r, x, y, mask, GLINT_RGB888);
        break;
    case GLINT_GREY8:
        write_as(r, x, y, mask, GLINT_GREY8);
        break;
    default:
        write_as(r, x, y, mask, GLINT_GREY4);
    }
}

/* Fills words, eight at a time. */
static void fill(uint32_t *to, uint32_t word, uint32_t bytes)
{
    uint32_t *end = to + bytes / 4, *last = to + bytes / 4 / 8 * 8;
#if defined(__thumb__)
    /* Store-multiple, which compilers do not make of a loop: half a store's cycles and an eighth of the instructions.
     */
    register uint32_t a __asm__("r4") = word, b __asm__("r5") = word, c __asm__("r6") = word, d __asm__("r3") = word;
    while (to != last)
        __asm__ volatile("stmia %0!, {r3, r4, r5, r6}\n\tstmia %0!, {r3, r4, r5, r6}"
                         : "+l"(to)
                         : "l"(a), "l"(b), "l"(c), "l"(d)
                         : "memory");
#else
    for (; to != last; to += 8)
        for (int i = 0; i < 8; i++)
            to[i] = word;
#endif
    while (to < end)
        *to++ = word;
}

void raster_clear(struct raster *r, const struct scene_header *scene)
{
    uint32_t sum[3], rows = (uint32_t)(r->y1 - r->y0);
    surface_colour(&r->palette, scene->background, sum);
    uint32_t colour = raster_colour(r, sum);
    /* The depth store is rounded up to whole words; what the last word holds beyond the band is not read. */
    fill((uint32_t *)(void *)r->depth, 0, (rows * r->width * 2 + 3) & ~3u);
    if (r->format == GLINT_RGB888 && colour % 0x10101u) {
        for (uint32_t y = 0; y < rows; y++)
            for (int x = 0; x < r->width; x++)
                put(r->pixels + y * r->stride, x, colour, GLINT_RGB888);
        return;
    }
    uint32_t word = r->format == GLINT_RGB565  ? colour | colour << 16
                    : r->format == GLINT_GREY4 ? colour * 0x11111111u
                                               : (colour & 0xff) * 0x01010101u;
    fill((uint32_t *)(void *)r->pixels, word, (rows * r->stride + 3) & ~3u);
}

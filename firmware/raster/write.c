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

static uint32_t pack(const struct raster *r, const uint32_t sum[3], uint32_t threshold)
{
    const uint8_t *top = r->palette.top;
    uint32_t first = level(sum[0], threshold, top[0]);
    if (raster_channels(r) == 1)
        return first;
    uint32_t second = level(sum[1], threshold, top[1]), third = level(sum[2], threshold, top[2]);
    return raster_is(r, GLINT_RGB565) ? first << 11 | second << 5 | third : first << 16 | second << 8 | third;
}

static inline __attribute__((always_inline)) void put(uint8_t *row, int x, uint32_t colour, unsigned format)
{
    if (uses_format(format, GLINT_RGB565)) {
        ((uint16_t *)(void *)row)[x] = fx_u16(colour);
    } else if (uses_format(format, GLINT_RGB888)) {
        row[3 * x] = fx_u8(colour >> 16);
        row[3 * x + 1] = fx_wrap_u8(colour >> 8);
        row[3 * x + 2] = fx_wrap_u8(colour);
    } else if (uses_format(format, GLINT_GREY8)) {
        row[x] = fx_u8(colour);
    } else if (USES(USES_GREY4)) {
        row += x >> 1;
        *row = fx_u8(x & 1 ? (*row & 0xf0) | colour : (*row & 0x0f) | colour << 4);
    }
}

uint32_t raster_colour(const struct raster *r, const uint32_t sum[3])
{
    return pack(r, sum, HALF_STEP);
}

/* Pixels that a mask chooses, and ordered dither, in any format. */
static void write_some(struct raster *r, uint8_t *row, int x, int y, uint32_t mask)
{
    for (const uint32_t *sum = r->sum[0]; mask; sum += 3, x++, mask >>= 1) {
        uint32_t threshold = raster_dithers(r) ? fx_u32(2 * bayer[y & 3][x & 3] + 1) << 10 : HALF_STEP;
        if (mask & 1)
            put(row, x, pack(r, sum, threshold), r->format);
    }
}

/* A run's first pixels, all, as most runs are: a loop a format, made with constants. */
static inline __attribute__((always_inline)) void write_all(const struct raster *r, uint8_t *row, int x, uint32_t mask,
                                                            unsigned format)
{
    for (const uint32_t *sum = r->sum[0]; mask; sum += 3, x++, mask >>= 1) {
        uint32_t colour = level(sum[0], HALF_STEP, raster_top(format, 0));
        if (format == GLINT_RGB565)
            colour = colour << 11 | level(sum[1], HALF_STEP, 63) << 5 | level(sum[2], HALF_STEP, 31);
        if (format == GLINT_RGB888)
            colour = colour << 16 | level(sum[1], HALF_STEP, 255) << 8 | level(sum[2], HALF_STEP, 255);
        put(row, x, colour, format);
    }
}

void raster_write(struct raster *r, int x, int y, uint32_t mask)
{
    uint8_t *row = r->pixels + fx_u32(y - r->y0) * r->stride;
    if (raster_dithers(r) || (mask & (mask + 1)) != 0)
        write_some(r, row, x, y, mask);
    else if (raster_is(r, GLINT_RGB565))
        write_all(r, row, x, mask, GLINT_RGB565);
    else if (raster_is(r, GLINT_RGB888))
        write_all(r, row, x, mask, GLINT_RGB888);
    else if (raster_is(r, GLINT_GREY8))
        write_all(r, row, x, mask, GLINT_GREY8);
    else
        write_all(r, row, x, mask, GLINT_GREY4);
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
    uint32_t sum[3], rows = fx_u32(r->y1 - r->y0);
    surface_colour(&r->palette, scene->background, sum);
    uint32_t colour = raster_colour(r, sum);
    /* The depth store is rounded up to whole words; what the last word holds beyond the band is not read. */
    fill((uint32_t *)(void *)r->depth, 0, (rows * r->width * 2 + 3) & ~3u);
    if (raster_is(r, GLINT_RGB888) && colour % 0x10101u) {
        for (uint32_t y = 0; y < rows; y++)
            for (int x = 0; x < r->width; x++)
                put(r->pixels + y * r->stride, x, colour, GLINT_RGB888);
        return;
    }
    uint32_t word = raster_is(r, GLINT_RGB565)  ? colour | colour << 16
                    : raster_is(r, GLINT_GREY4) ? colour * 0x11111111u
                                                : (colour & 0xff) * 0x01010101u;
    fill((uint32_t *)(void *)r->pixels, word, (rows * r->stride + 3) & ~3u);
}

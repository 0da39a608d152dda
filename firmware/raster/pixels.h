/* SPDX-License-Identifier: MIT */
/*
 * A span's pixels from a colour table: RGB565 under one light. A template: always called with a constant `kind`.
 *
 * Depth, N.L and N.H are stepped by differences; where a pixel is the nearest, its depth is kept and its colour is the
 * table's entry for (N.H, N.L), both clamped, as the first and last entries stand for all beyond.
 */
#ifndef GLINT_PIXELS_H
#define GLINT_PIXELS_H

#include "raster/raster.h"

enum pixels_kind { PIXELS_DIFFUSE = 1, PIXELS_HIGHLIGHT = 2, PIXELS_QUADRATIC = 4 };

/* Values at the first pixel, first differences, and second ones (0 where linear). */
struct pixels_values {
    uint32_t z, l, h, dz, dl, dh, al, ah;
};

/* The shape compilers know as a saturation. */
static inline int32_t pixels_clamped(int32_t x, int32_t top)
{
    int32_t y = x < 0 ? 0 : x;
    return y > top ? top : y;
}

/*
 * From `depth` to before `end`; `to_pixels` bytes lie between a pixel's depth and its colour: one pointer for both
 * stores, which have the same shape. N.L counts in Q30 from half a step before 0, N.H from the foot of the power in Q30
 * / 2^octave, where down = 23 - octave. *hidden counts those that are not the nearest.
 */
FX_WRAPS static inline __attribute__((always_inline)) void pixels_plain(struct pixels_values v, uint16_t *depth,
                                                                        const uint16_t *end, uintptr_t to_pixels,
                                                                        const uint16_t *colours, int down,
                                                                        volatile uint32_t *hidden, unsigned kind)
{
    do {
        uint32_t nearer = v.z >> 16;
        if (nearer > *depth) {
            const uint16_t *entry = colours;
            *depth = (uint16_t)nearer;
            if (kind & PIXELS_HIGHLIGHT)
                entry += pixels_clamped((int32_t)v.h >> down, TABLE_HIGHLIGHT - 1) * TABLE_DIFFUSE;
            if (kind & PIXELS_DIFFUSE)
                entry += pixels_clamped((int32_t)v.l >> 24, TABLE_DIFFUSE - 1);
            *(uint16_t *)((uintptr_t)depth + to_pixels) = *entry;
        } else {
            *hidden = *hidden + 1;
        }
        fx_step(&v.z, v.dz);
        if (kind & PIXELS_DIFFUSE) {
            v.l += v.dl;
            if (kind & PIXELS_QUADRATIC)
                fx_step(&v.dl, v.al);
        }
        if (kind & PIXELS_HIGHLIGHT) {
            v.h += v.dh;
            if (kind & PIXELS_QUADRATIC)
                fx_step(&v.dh, v.ah);
        }
    } while (++depth != end);
}

#if FX_NARROW && defined(__thumb__)
#define PIXELS_BY_HAND 1
#else
#define PIXELS_BY_HAND 0
#endif

/*
 * The same for rows of spans by hand for ARMv6-M, whose compilers keep four of the loop's words in memory: with every
 * register in use and the clamps' rare cases apart, a pixel takes 29 cycles instead of 45 on a Cortex-M0+. N.H counts
 * in Q30 itself here (down = 23: an immediate), within [-2, 2) for the clamp to know what is above from what is below.
 * pixels_thumb.c knows these offsets.
 */
struct pixels_rows {
    const struct channel *channel; /* depth, N.L, N.H, one behind the other */
    const struct span *span, *last;
    uint8_t *row;          /* of the depth, its column 0 */
    uint32_t stride, j;    /* bytes a row; the row from the origin */
    uint32_t ox;           /* the origin's column */
    const uint16_t *table; /* colours */
    uintptr_t to_pixels;
    uint32_t covered, hidden; /* pixels, added to */
};
void pixels_rows_diffuse(struct pixels_rows *rows);
void pixels_rows_both(struct pixels_rows *rows);
void pixels_rows_diffuse_quadratic(struct pixels_rows *rows);
void pixels_rows_both_quadratic(struct pixels_rows *rows);

#endif

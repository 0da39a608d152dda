/* SPDX-License-Identifier: MIT */
/*
 * How far interpolated dot products can be from those with the normalised normal, from a triangle's corner values and
 * its edges' bends alone. README.md beside this file derives the bounds; letters in brackets are its sections.
 */
#ifndef GLINT_CURVE_H
#define GLINT_CURVE_H

#include "fixed/fixed.h"

#define CURVE_MOST_BEND 32768u /* 90 degrees between normals: beyond, nothing is promised */

/* One chord of the table F (f): the error of six is at most kB (alpha h1 kB + beta d); Q16. */
struct curve_line {
    int32_t alpha, beta;
};

/* A triangle of normals. */
struct curve {
    uint32_t bend;                  /* the largest, kB, Q16 */
    uint32_t sum;                   /* the largest S, Q16: 1 - |N|^2 is 4 S (a); with lines */
    uint32_t stretch;               /* 1/|N| - 1 where N is shortest, Q15, rounded up (a); with lines */
    const struct curve_line *lines; /* five, or null: nothing is promised */
};

/* By the largest bend: 29, 41.4, 60 and 90 degrees between normals. Four chords of F (f) and what lies beyond them, and
 * for (a) the largest (1/sqrt(1 - 4 S) - 1 - 2 S) / S^2 there, at S = kB / 3, Q8. */
#define CURVE_BANDS 4
struct curve_band {
    uint16_t most;
    uint16_t square;
    struct curve_line line[5];
};
extern const struct curve_band curve_bands[CURVE_BANDS];

/* A dot product at the three corners, in order, Q14; how far the truth is above the linear value at most, and the
 * largest true value. */
struct curve_values {
    int32_t high, middle, low;
    int32_t linear, top;
};

/* (a) S = sum kij li lj <= max(k1 / 4, (2 k1 + k2 + k3) / 12), k1 the largest: Q16, rounded up. */
static inline uint32_t curve_sum(uint32_t most, uint32_t a, uint32_t b, uint32_t c)
{
    /* the sum is at most 2^18, times 5462 below 2^30.5 */
    const uint32_t quarter = (most >> 2) + 1, twelfth = ((most + a + b + c) * 5462 >> 16) + 1;
    return quarter > twelfth ? quarter : twelfth;
}

/* (a) 1/sqrt(1 - 4 S) - 1 <= 2 S + square S^2, as its series has no negative term: .733 in Q15 at most, 24,012. */
static inline void curve_setup(struct curve *curve, const uint16_t bend[3])
{
    const uint32_t a = bend[0], b = bend[1], c = bend[2];
    uint32_t most = a > b ? a : b;
    most = c > most ? c : most;
    curve->bend = most;
    curve->lines = 0;
    curve->sum = curve->stretch = 0;
    if (most > CURVE_MOST_BEND)
        return;
    const uint32_t s = curve_sum(most, a, b, c); /* s <= 2^13.5, s^2 < 2^27, times the factor below 2^24 */
    curve->sum = s;
    const struct curve_band *band = curve_bands;
    while (most > band->most)
        band++;
    curve->lines = band->line;
    curve->stretch = s + (((s * s >> 16) + 1) * band->square >> 9) + 2; /* 2 S in Q15 is S in Q16 */
}

/* The values in order; the rest is curve_bound()'s. */
static inline struct curve_values curve_values(int32_t a, int32_t b, int32_t c)
{
    struct curve_values v;
    const int32_t most = a > b ? a : b, least = a > b ? b : a;
    v.high = c > most ? c : most;
    v.low = c < least ? c : least;
    v.middle = a + b + c - v.high - v.low;
    v.linear = v.top = 0;
    return v;
}

/*
 * (d), (c) Fills linear and top; high > 0. Truth exceeds the linear value by at most (.593 h1 + .407 h2) (1/|N| - 1),
 * and is never below it where it shows (without lines, by all there is); nothing exceeds h1 if h1 - h2 >= 2 h1 kB. mean
 * <= 2^14 (1 + 2^-9), stretch <= 2^17.
 */
static inline void curve_bound(const struct curve *curve, struct curve_values *v)
{
    const int32_t mean = ((v->high * 607 + (v->middle > 0 ? v->middle : 0) * 418) >> 10) + 1;
    v->linear = curve->lines ? fx_s32(fx_u32(mean) * curve->stretch >> 15) + 1 : 16384;
    v->top = v->high;
    if (v->high - v->middle <= fx_s32(fx_u32(v->high) * curve->bend >> 15) + 1) {
        v->top += v->linear;
        if (v->top > 16384)
            v->top = 16384;
    }
}

/* (f) The most that six is off, either way, Q14. high > 0, curve->lines not null. */
static inline int32_t curve_six(const struct curve *curve, const struct curve_values *v)
{
    const struct curve_line *line = curve->lines;
    const int32_t scaled = fx_s32(fx_u32(v->high) * curve->bend >> 16) + 1, range = v->high - v->low;
    if (range > 4 * scaled)
        line += range > 16 * scaled ? 4 : 3;
    else
        line += range > 2 * scaled ? 2 : range > scaled;
    /* |alpha| < 2^16, |beta| < 2^14.1, scaled <= 2^13, range <= 2^15: below 2^31; and never below 0 */
    const int32_t most = line->alpha * scaled + line->beta * range;
    return fx_s32(((fx_u32(most) >> 14) + 1) * curve->bend >> 18) + 2;
}

#endif

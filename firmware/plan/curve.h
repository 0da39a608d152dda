/* SPDX-License-Identifier: MIT */
/*
 * How far interpolated dot products can be from those with the normalised normal, from a triangle's corner values and
 * its edges' bends alone. README.md beside this file derives the bounds; letters in brackets are its sections.
 */
#ifndef GLINT_CURVE_H
#define GLINT_CURVE_H

#include "fixed/fixed.h"

#define CURVE_MOST_BEND 32768u /* 90 degrees between normals: beyond, nothing is promised */

/* The stretch of what exceeds that: linear values are off by all there is; times 2^14 below 2^32. */
#define CURVE_NEVER (1u << 17)

/* One chord of the table F (f): the error of six is at most kB (alpha h1 kB + beta d); Q16. */
struct curve_line {
    int32_t alpha, beta;
};

/* A triangle of normals. */
struct curve {
    uint32_t bend;                  /* the largest, kB, Q16 */
    uint32_t stretch;               /* 1/|N| - 1 where N is shortest, Q15, rounded up (a) */
    const struct curve_line *lines; /* five, or null: nothing is promised */
};

/* Corner values in order, Q14. */
struct curve_values {
    int32_t high, middle, low;
};

void curve_setup(struct curve *curve, const uint16_t bend[3]);

static inline struct curve_values curve_values(int32_t a, int32_t b, int32_t c)
{
    struct curve_values v;
    const int32_t most = a > b ? a : b, least = a > b ? b : a;
    v.high = c > most ? c : most;
    v.low = c < least ? c : least;
    v.middle = a + b + c - v.high - v.low;
    return v;
}

/* (d) The most that the truth is above the linear value, Q14; it is never below where it shows. high > 0: mean <= 2^14
 * (1 + 2^-9), stretch <= 2^17. */
static inline int32_t curve_linear(const struct curve *curve, const struct curve_values *v)
{
    const int32_t mean = ((v->high * 607 + (v->middle > 0 ? v->middle : 0) * 418) >> 10) + 1;
    return (int32_t)((uint32_t)mean * curve->stretch >> 15) + 1;
}

/* (c) The largest true value in the triangle, Q14. */
static inline int32_t curve_top(const struct curve *curve, const struct curve_values *v, int32_t linear)
{
    int32_t top = v->high;
    if (v->high - v->middle <= (int32_t)((uint32_t)v->high * curve->bend >> 15) + 1)
        top += linear;
    return top < 16384 ? top : 16384;
}

/* (f) The most that six is off, either way, Q14. high > 0, curve->lines not null. */
int32_t curve_six(const struct curve *curve, const struct curve_values *v);

#endif

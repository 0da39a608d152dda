/* SPDX-License-Identifier: MIT */
/*
 * Values over a triangle as rational numbers of 128 bits: edge functions are below 2^33 (exact.h), a linear value's
 * numerator below 2^17 2^33 3, a quadratic one's below 2^31 2^66 2^4.
 */
#ifndef EXACT_RATIONAL_H
#define EXACT_RATIONAL_H

#include "exact.h"

typedef __int128 exact_t;

/* Barycentric coordinates of the pixel's centre, times the area. */
static inline void exact_weights(const struct exact_triangle *t, int x, int y, exact_t l[3])
{
    const struct cover_point c = cover_centre(x, y, t->width, t->height);
    for (int k = 0; k < 3; k++)
        l[k] = exact_edge(t, (k + 1) % 3, c);
}

/* A quantity over a triangle: corner values, of which the channel holds `unit` times as much, and bulges of the edges
 * 0-1, 1-2, 2-0 in Q28, of which it holds 4 times as much (Q30). */
struct exact_quantity {
    int32_t value[3], bulge[3];
    int32_t unit; /* 2^16, or 1 where corner values are in Q30 themselves */
};

/* What the channel should hold at a pixel, times the area squared. */
static inline exact_t exact_value(const struct exact_triangle *t, const struct exact_quantity *q, int x, int y)
{
    exact_t l[3], linear = 0, bend = 0;
    exact_weights(t, x, y, l);
    for (int k = 0; k < 3; k++) {
        linear += q->value[k] * l[k];
        bend += q->bulge[k] * l[k] * l[(k + 1) % 3];
    }
    return linear * q->unit * exact_area(t) - 4 * bend;
}

/* The six rationals, all over `den`. */
struct exact_polynomial {
    exact_t f, d, e, a, b, c, den;
};

/* From values at six pixels about the origin (ox, oy): a quadratic has no more to it. */
static inline struct exact_polynomial exact_polynomial(const struct exact_triangle *t, const struct exact_quantity *q,
                                                       int ox, int oy)
{
    const exact_t here = exact_value(t, q, ox, oy), right = exact_value(t, q, ox + 1, oy),
                  left = exact_value(t, q, ox - 1, oy), below = exact_value(t, q, ox, oy + 1),
                  above = exact_value(t, q, ox, oy - 1), both = exact_value(t, q, ox + 1, oy + 1);
    /* over twice the area squared, as the halves may not be whole */
    return (struct exact_polynomial){.f = 2 * here,
                                     .d = right - left,
                                     .e = below - above,
                                     .a = right + left - 2 * here,
                                     .b = below + above - 2 * here,
                                     .c = 2 * (both - right - below + here),
                                     .den = 2 * (exact_t)exact_area(t) * exact_area(t)};
}

/* How far 32 bits are from a rational number, modulo 2^32: the rational taken exactly, the difference to a double. */
static inline double exact_off(uint32_t got, exact_t number, exact_t den)
{
    const exact_t turn = den << 32;
    exact_t off = (got * den - number) % turn;
    if (off > turn / 2)
        off -= turn;
    if (off < -(turn / 2))
        off += turn;
    return (double)off / (double)den;
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * What cannot show on a triangle, from its corner values alone.
 *
 * With bulges a_ij = (Ii + Ij) kij, X-shading's value satisfies
 *     Phi = sum Ii li - sum aij li lj <= max Ii + max|aij| * max(sum li lj) = max Ii + max|aij| / 3,
 * because sum li lj over a triangle is largest, 1/3, at its centre; and |Phi - linear| <= max|aij| / 3 likewise.
 */
#ifndef GLINT_BOUNDS_H
#define GLINT_BOUNDS_H

#include "fixed/fixed.h"

/* A third of the largest bulge in Q14, rounded up: bulges in Q28, |a| <= 2^28. */
static inline int32_t bounds_bend(const int32_t bulge[3])
{
    int32_t largest = 0;
    for (int i = 0; i < 3; i++) {
        int32_t size = bulge[i] < 0 ? -bulge[i] : bulge[i];
        largest = size > largest ? size : largest;
    }
    return ((largest >> 14) * 11 >> 5) + 2; /* 11/32 > 1/3; 2^14 * 11 fits; + 2 for the two roundings */
}

/* Nothing on the triangle exceeds this, Q14. */
static inline int32_t bounds_top(const int32_t value[3], int32_t bend)
{
    int32_t top = value[0] > value[1] ? value[0] : value[1];
    return (top > value[2] ? top : value[2]) + bend;
}

/* The highest N.H, in Q14, at which a highlight is still 0 in the power table. */
static inline int32_t bounds_power_floor(const struct fx_power *power)
{
    return (1 << 14) - ((1 << 14) >> power->octave);
}

#endif

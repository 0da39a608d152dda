/* SPDX-License-Identifier: MIT */
/*
 * What cannot show on a triangle, from its corner values alone.
 *
 * With bulges a_ij = (Ii + Ij) kij, X-shading's value satisfies
 *     Phi = sum Ii li - sum aij li lj <= max Ii + max|aij| * max(sum li lj) = max Ii + max|aij| / 3,
 * because sum li lj over a triangle is largest, 1/3, at its centre; and |Phi - linear| <= max|aij| / 3 likewise. As
 * |aij| <= 2 max|I| max|k|, two maxima bound it without computing a bulge.
 */
#ifndef GLINT_BOUNDS_H
#define GLINT_BOUNDS_H

#include "fixed/fixed.h"

/* The largest and smallest of a triangle's corner values, Q14. */
struct bounds {
    int32_t low, high;
};

static inline struct bounds bounds_of(const int32_t v[3])
{
    struct bounds b;
    b.low = v[0] < v[1] ? v[0] : v[1];
    b.high = v[0] < v[1] ? v[1] : v[0];
    b.low = v[2] < b.low ? v[2] : b.low;
    b.high = v[2] > b.high ? v[2] : b.high;
    return b;
}

/* Two thirds of the largest -k, rounded up: Q16 in, Q15 out. */
static inline int32_t bounds_curl(const uint16_t bend[3])
{
    int32_t k = bend[0] > bend[1] ? bend[0] : bend[1];
    k = bend[2] > k ? bend[2] : k;
    return (k * 11 >> 5) + 1; /* 11/32 > 2/3 / 2 */
}

/* The value leaves the linear one by less than this, Q14: |I| <= 2^14, curl < 2^15. 2 for the roundings of bulges and
 * corner values. */
static inline int32_t bounds_bend(struct bounds b, int32_t curl)
{
    int32_t size = -b.low > b.high ? -b.low : b.high;
    return (size * curl >> 15) + 2;
}

/* The highest N.H, in Q14, at which a highlight is still 0 in the power table. */
static inline int32_t bounds_power_floor(const struct fx_power *power)
{
    return (1 << 14) - ((1 << 14) >> power->octave);
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * How far the fixed-point functions may be from the truth, and how far they are at one argument. The bounds are those
 * that firmware/fixed/fixed.h documents; the unit tests sample the domains, exhaustive_fixed.c walks them whole.
 */
#ifndef FIXED_TRUTH_H
#define FIXED_TRUTH_H

#include "fixed/fixed.h"

#include <math.h>

#define TRUTH_RECIP_BOUND  0x1.84p-31 /* 2^-30.4, relative */
#define TRUTH_RSQRT_BOUND  0x1.52p-21 /* 2^-20.6, relative */
#define TRUTH_SIN_BOUND    1.3        /* units of 2^-30 */
#define TRUTH_POWER_BOUND  .5         /* of 1/255 */
#define TRUTH_POWER_INSIDE .29        /* of 1/255, within the range of the table */

/* Result minus truth, in the unit of the bound; infinite where the result leaves its documented range. */
static inline double truth_recip(uint32_t m)
{
    uint32_t r = fx_recip_norm(m);
    double exact = 0x1p63 / m;
    return r < 0x80000000u ? INFINITY : (r - exact) / exact;
}

static inline double truth_rsqrt(uint32_t m)
{
    uint32_t r = fx_rsqrt_norm(m);
    double exact = 0x1p46 / sqrt(m);
    return r <= 0x40000000u || r > 0x80000000u ? INFINITY : (r - exact) / exact;
}

FX_WRAPS static inline double truth_sin(uint32_t turn)
{
    const double pi = 3.14159265358979323846;
    q30_t r = fx_sin(turn), one = (q30_t)1 << 30;
    if (r < -one || r > one || r != -fx_sin(0u - turn) || r != fx_cos(turn - 0x40000000u))
        return INFINITY;
    return r - 0x1p30 * sin((int32_t)turn * (pi / 0x1p31));
}

static inline double truth_power(const struct fx_power *table, q30_t s)
{
    uint32_t r = fx_power(table, s);
    double x = s * 0x1p-30, exact = x <= 0 ? 0 : x >= 1 ? 1 : pow(x, table->exponent);
    return r > 32768u ? INFINITY : 255 * (r * 0x1p-15 - exact);
}

#endif

/* SPDX-License-Identifier: MIT */
/* What an error of a dot product costs in a colour: Q8 of 1/255. Letters in brackets are README.md's sections. */
#ifndef GLINT_PLAN_PARTS_H
#define GLINT_PLAN_PARTS_H

#include "plan/curve.h"
#include "plan/plan.h"

/* A coefficient (Q8) times a Q14 quantity of at most 1, rounded up: below 2^16 * 2^14. */
static inline uint32_t parts_scaled(uint32_t coefficient, int32_t q14)
{
    return (coefficient * fx_u32(q14 < 16384 ? q14 : 16384) >> 14) + 1;
}

/* (N.H)^n in Q15 of at most 1 in Q14, by the power's table: fx_power() for what it is asked here. */
static inline uint32_t parts_power(const struct plan_surface *s, int32_t h)
{
    const int32_t above = h - s->foot;
    if (above < 0)
        return 0;
    const uint32_t t = fx_u32(above) << s->power->octave; /* at most 2^14: 7 bits of step, 7 of position in it */
    const uint16_t *v = &s->power->value[t >> 7];
    return v[0] + (fx_u32(v[1] - v[0]) * (t & 127) >> 7);
}

/* A highlight's part of the colour at N.H: below 2^16 * 2^15. */
static inline uint32_t parts_shine(const struct plan_surface *s, uint32_t specular, int32_t h)
{
    return parts_power(s, h) * specular >> 15;
}

/* (g) How much it can change while N.H moves by `by` where it is at most `top`: the power is convex, so most there. */
static inline uint32_t parts_slack(const struct plan_surface *s, uint32_t specular, int32_t top, int32_t by,
                                   uint32_t at_top)
{
    return at_top - parts_shine(s, specular, top - by) + 1;
}

/* The same through six samples, which can also pass the largest true value. */
static inline uint32_t parts_slack_above(const struct plan_surface *s, uint32_t specular, int32_t top, int32_t by)
{
    top = top + by < 16384 ? top + by : 16384;
    return parts_slack(s, specular, top, by, parts_shine(s, specular, top) + 1);
}

/* (i) The gap between the corners' chord and max(0, .): ab / (a + b) <= min(a, b, (a + b) / 4). */
static inline int32_t parts_lit_gap(const struct curve_values *v)
{
    if (v->low >= 0 || v->high <= 0)
        return 0;
    int32_t gap = (v->high - v->low + 3) >> 2;
    gap = v->high < gap ? v->high : gap;
    return -v->low < gap ? -v->low : gap;
}

/* (i) The most that the highlight's chord is above it between low and high, 0 where N.H is below 0: by its middle and
 * its third quarter. That is for gaps that lie to the right of the middle, as all do whose second derivative rises: n
 * >= 2. n = 1 is as N.L. 3 is for roundings, the table's among them. */
static inline uint32_t parts_shine_gap(const struct plan_surface *s, uint32_t specular, const struct curve_values *v)
{
    if (s->power->exponent == 1)
        return parts_scaled(specular, parts_lit_gap(v));
    const int32_t sum = v->low + v->high, upper = sum + 2 * v->high;
    const uint32_t a = parts_shine(s, specular, v->low > 0 ? v->low : 0), b = parts_shine(s, specular, v->high);
    const uint32_t half = (a + b) / 2 + 3 - (sum > 0 ? parts_shine(s, specular, sum >> 1) : 0),
                   quarter = (a + 3 * b) / 4 + 3 - (upper > 0 ? parts_shine(s, specular, upper >> 2) : 0);
    const uint32_t crossing = ((8 * half + 4 * quarter) * 7282 >> 16) + 1, /* a ninth */
        beyond = 2 * quarter > half ? 2 * quarter - half : 0;
    return crossing > beyond ? crossing : beyond;
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * N.L in steps of the output: with 8-bit grey, where no light but the first reaches the triangle, N.L's corner values
 * and bulges are multiplied by the material's diffuse light before they go on the plane. A channel then counts in Q22
 * steps (Q30 of 256), and a pixel's diffuse light is a clamp and a shift.
 */
#ifndef GLINT_STEPS_H
#define GLINT_STEPS_H

#include "plan/bounds.h"
#include "shade/shade.h"

/* Whether N.L of a triangle's first light counts in steps: it is the only one that shows. */
static inline int steps_apply(const struct shade_setup *setup, const struct surface *surface)
{
    return surface_fold(surface) && shade_alone(setup);
}

/* Corner values, Q14: |value| <= 2^14.2, fold < 2^16. They round to 2^-14 of 256 steps, so the channel errs by 1/128.
 */
static inline void steps_fold(const struct surface *surface, int32_t value[3])
{
    for (int k = 0; k < 3; k++)
        value[k] = (value[k] * surface->fold + (1 << 15)) >> 16;
}

/* Bulges, any. */
static inline void steps_fold_bulges(const struct surface *surface, int32_t bulge[3])
{
    for (int k = 0; k < 3; k++)
        bulge[k] = fx_mulhi_s32(bulge[k], surface->fold << 15) * 2;
}

/*
 * Whether N.L within `range` at the corners and at most `bend` off linear needs no clamp with the ambient part: N.L is
 * lit everywhere, and the sum stays a step inside the format, which is more than a channel errs (see plane.c). In Q7
 * steps; |range +- bend| < 2^16 is asked for first, as a product in 32 bits must hold it.
 */
static inline int steps_plain(const struct surface *surface, struct bounds range, int32_t bend)
{
    const int32_t low = range.low - bend, high = range.high + bend, fold = surface->fold;
    return low > 0 && high < 1 << 15 && (low * fold >> 15) + surface->ambient >= 1 << 7 &&
           (high * fold >> 15) + surface->ambient < 255 << 7;
}

/* Turns N.L's corner values and bulges (null: linear) into steps; `range` and `bend` are theirs. */
static inline void steps_take(struct shade_setup *setup, const struct surface *surface, struct bounds range,
                              int32_t bend, int32_t value[3], int32_t *bulge)
{
    steps_fold(surface, value);
    if (bulge)
        steps_fold_bulges(surface, bulge);
    setup->in_steps = 1;
    setup->plain = fx_u8(steps_plain(surface, range, bend));
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * A run's colours from channels of N.L and N.H: clamp, power and sum over the lights, per pixel. A template: each
 * method includes it and calls it with a constant kind.
 */
#ifndef GLINT_RASTER_DOTS_H
#define GLINT_RASTER_DOTS_H

#include "raster/raster.h"
#include "shade/perspective.h"

enum dots_kind {
    DOTS_PLAIN,       /* the channels are the dot products */
    DOTS_PERSPECTIVE, /* times W^2 */
    DOTS_UNIT,        /* times the length of the interpolated normal, whose square is channel SHADE_SQUARE */
    DOTS_UNIT_NEAR    /* the same as quadratics through samples, which can pass that length */
};

/* Adds `amount` (Q15) of a light's colour (Q8 steps at full) to a pixel: at most 1.0887 * 2^15 * 255 * 2^8 < 2^32. */
static inline __attribute__((always_inline)) void dots_add(uint32_t *sum, uint32_t amount, const uint16_t *steps,
                                                           unsigned channels)
{
    for (unsigned c = 0; c < channels; c++)
        sum[c] += surface_diffuse(amount, steps[c]);
}

/* What each pixel's dot products are to be divided by, into r->divisor. */
static inline __attribute__((always_inline)) void dots_divisors(struct raster *r, int x, int y, int n,
                                                                enum dots_kind kind)
{
    if (kind == DOTS_PERSPECTIVE)
        raster_divisors(r, x, y, n);
    if (kind == DOTS_UNIT || kind == DOTS_UNIT_NEAR)
        raster_lengths(r, x, y, n);
}

/* The quotient of what passes `reach`, up to +-2 in Q30. */
static __attribute__((noinline, unused)) int32_t dots_overshoot(int32_t p, struct perspective_divisor by)
{
    int64_t quotient = ((int64_t)p * by.half >> 30) * (INT64_C(1) << by.up); /* |p| < 2^31, half <= 2^30, up <= 9 */
    return quotient > INT32_MAX ? INT32_MAX : quotient < -INT32_MAX ? -INT32_MAX : (int32_t)quotient;
}

/* A dot product over the normal's length. Of linear numerators it is at most 1 and roundings, but a quadratic through
 * the samples of a near light can pass the length by far. */
FX_WRAPS static inline __attribute__((always_inline)) int32_t dots_over_length(int32_t p, struct perspective_divisor by)
{
    const uint32_t reach = (uint32_t)INT32_MAX >> by.up;
    if ((uint32_t)p + reach > 2 * reach)
        return dots_overshoot(p, by);
    return perspective_divide(p, by);
}

static inline __attribute__((always_inline)) int32_t dots_value(const struct raster *r, int i, enum dots_kind kind)
{
    if (kind == DOTS_PERSPECTIVE)
        return perspective_divide_twice(r->value[0][i], r->divisor[i]);
    if (kind == DOTS_UNIT)
        return perspective_divide(r->value[0][i], r->divisor[i]);
    if (kind == DOTS_UNIT_NEAR)
        return dots_over_length(r->value[0][i], r->divisor[i]);
    return r->value[0][i];
}

/* The run's N.H to powers by another form than the table. */
static inline __attribute__((always_inline)) void dots_powers(struct raster *r, int n, enum dots_kind kind)
{
    const struct surface *s = &r->surface;
    if (r->setup.folded) {
        s->form->run_folded(s->power->exponent, r->setup.folded, r->value[0], n);
        return;
    }
    for (int i = 0; i < n; i++)
        r->value[0][i] = dots_value(r, i, kind);
    s->form->run(s->power->exponent, r->value[0], n);
}

static inline __attribute__((always_inline)) void dots_shade_channels(struct raster *r, int x, int y, int n,
                                                                      unsigned channels, enum dots_kind kind)
{
    const struct surface *s = &r->surface;
    struct shade_setup *setup = &r->setup;
    uint32_t *sum = r->sum[0];
    for (int i = 0; i < n; i++, sum += 3)
        for (unsigned c = 0; c < channels; c++)
            sum[c] = s->base[c];
    dots_divisors(r, x, y, n, kind);
    for (unsigned l = 0; l < s->lights; l++) {
        if (setup->diffuse_lights >> l & 1) {
            plane_values(&setup->plane, &setup->channel[2 * l], x, y, n, r->value[0]);
            sum = r->sum[0];
            for (int i = 0; i < n; i++, sum += 3) {
                int32_t value = dots_value(r, i, kind);
                if (value > 0)
                    dots_add(sum, (uint32_t)value >> 15, s->light[l].diffuse, channels);
            }
        }
        if (setup->specular_lights >> l & 1) {
            plane_values(&setup->plane, &setup->channel[2 * l + 1], x, y, n, r->value[0]);
            sum = r->sum[0];
            if (s->form) {
                dots_powers(r, n, kind);
                for (int i = 0; i < n; i++, sum += 3)
                    dots_add(sum, (uint32_t)r->value[0][i], s->light[l].specular, channels);
                continue;
            }
            for (int i = 0; i < n; i++, sum += 3) {
                uint32_t power = fx_power(s->power, dots_value(r, i, kind));
                if (power)
                    dots_add(sum, power, s->light[l].specular, channels);
            }
        }
    }
}

static inline __attribute__((always_inline)) void dots_shade(struct raster *r, int x, int y, int n, enum dots_kind kind)
{
    if (r->surface.channels == 1)
        dots_shade_channels(r, x, y, n, 1, kind);
    else
        dots_shade_channels(r, x, y, n, 3, kind);
}

#endif

/* SPDX-License-Identifier: MIT */
/* Set-ups that a plan has decided: one colour; and N.L, N.H of each light left out, linear, quadratic through six
 * samples, or over the normal's length. Lights and eye are far. */
#include "shade/dots.h"
#include "shade/piece.h"

void shade_constant(struct shade_setup *setup, const struct shade_input *in)
{
    const struct surface *s = in->surface;
    const unsigned channels = surface_channels(s), lights = surface_lights(s);
    for (unsigned c = 0; c < channels; c++)
        setup->flat[c] = s->base[c];
    if (in->plan.rung == PLAN_DARK)
        return;
    for (unsigned i = 0; i < lights; i++)
        for (unsigned c = 0; c < channels; c++)
            setup->flat[c] += surface_diffuse(in->plan.level[2 * i], s->light[i].diffuse[c]) +
                              surface_diffuse(in->plan.level[2 * i + 1], s->light[i].specular[c]);
    for (unsigned c = 0; c < channels; c++)
        setup->flat[c] = setup->flat[c] < s->top[c] ? setup->flat[c] : s->top[c];
}

/*
 * One dot product: linear, or where `factors` is not null quadratic, factors[k] being the length factor of edge k less
 * 1, Q16: its bulge is -2 (Ii + Ij) times that. |Ii + Ij| <= 2^15, factors at most 2^14.8 at 90 degrees: below 2^30, in
 * Q14 + 16 + 1 - 3 = Q28. Of a clipped piece the linear value at its corners is the source's.
 */
static inline __attribute__((always_inline)) void interpolate(struct shade_setup *setup, const struct shade_input *in,
                                                              unsigned index, const int32_t *factors, int folds)
{
    const struct surface *s = in->surface;
    struct channel *channel = &setup->channel[index];
    int32_t value[3] = {in->lights[0][index], in->lights[1][index], in->lights[2][index]}, bulge[3] = {0, 0, 0};
    const struct bounds range = bounds_of(value); /* of a piece too: it lies in its source */
    int32_t bend = 2;
    if (factors) {
        bulge[0] = -((value[0] + value[1]) * factors[0]) >> 1;
        bulge[1] = -((value[1] + value[2]) * factors[1]) >> 1;
        bulge[2] = -((value[2] + value[0]) * factors[2]) >> 1;
        bend = dots_bulge_bend(bulge);
    }
    if (shade_weight(in))
        piece_quadratic(shade_weight(in), value, bulge);
    if (index & 1) {
        setup->runs_only |= (uint8_t)dots_deep(s->power, range, bend);
        if (USES(USES_FORMATS & ~USES_GREY4))
            setup->wide |= (uint8_t)dots_wide(s->power, range, bend);
    } else if (folds) {
        steps_take(setup, s, range, bend, value, factors ? bulge : 0);
    }
    if (factors)
        dots_quadratic(setup, value, bulge, channel);
    else
        plane_linear(&setup->plane, value, channel);
    setup->runs_only |= (uint8_t)(channel->exact != 0);
}

static __attribute__((noinline)) void linear(struct shade_setup *setup, const struct shade_input *in, unsigned index,
                                             int folds)
{
    interpolate(setup, in, index, 0, folds);
}

static __attribute__((noinline)) void quadratic(struct shade_setup *setup, const struct shade_input *in, unsigned index,
                                                const int32_t factors[3], int folds)
{
    interpolate(setup, in, index, factors, folds);
}

void shade_planned(struct shade_setup *setup, const struct shade_input *in)
{
    const struct shade_plan *plan = &in->plan;
    const unsigned lights = surface_lights(in->surface);
    int32_t factors[3] = {0, 0, 0};
    setup->runs_only = setup->depth.exact != 0;
    setup->diffuse_lights = plan->diffuse;
    setup->specular_lights = plan->specular;
    const int folds = steps_apply(setup, in->surface);
    setup->quadratic = plan->rung == PLAN_SIX;
    if (setup->quadratic) {
        plane_setup_quadratic(&setup->plane);
        for (int k = 0; k < 3; k++)
            factors[k] = (int32_t)(dots_length_factor(dots_bend(in, k)) - (1u << 16));
    }
    for (unsigned i = 0; i < lights; i++) {
        if (plan->diffuse_bent >> i & 1)
            quadratic(setup, in, 2 * i, factors, folds);
        else if (plan->diffuse >> i & 1)
            linear(setup, in, 2 * i, folds);
        if (plan->specular_bent >> i & 1)
            quadratic(setup, in, 2 * i + 1, factors, folds);
        else if (plan->specular >> i & 1)
            linear(setup, in, 2 * i + 1, folds);
    }
}

/* Duff's, whose numerators are linear under far lights. */
void shade_planned_duff(struct shade_setup *setup, const struct shade_input *in)
{
    const unsigned lights = surface_lights(in->surface);
    setup->runs_only = setup->depth.exact != 0;
    setup->diffuse_lights = in->plan.diffuse;
    setup->specular_lights = in->plan.specular;
    plane_setup_quadratic(&setup->plane);
    setup->length = (uint8_t)(duff_direct(setup, in) && shade_alone(setup));
    for (unsigned i = 0; i < lights; i++) {
        if (in->plan.diffuse >> i & 1)
            linear(setup, in, 2 * i, setup->length);
        if (in->plan.specular >> i & 1)
            linear(setup, in, 2 * i + 1, setup->length);
    }
    duff_square(setup, in);
}

/* SPDX-License-Identifier: MIT */
/* Set-ups that a plan has decided: one colour; and N.L, N.H of each light left out, linear, or quadratic through six
 * samples. Lights and eye are far. */
#include "shade/dots.h"
#include "shade/piece.h"

void shade_constant(struct shade_setup *setup, const struct shade_input *in)
{
    const struct surface *s = in->surface;
    for (unsigned c = 0; c < s->channels; c++)
        setup->flat[c] = s->base[c];
    if (in->plan.rung == PLAN_DARK)
        return;
    for (unsigned i = 0; i < s->lights; i++)
        for (unsigned c = 0; c < s->channels; c++)
            setup->flat[c] += surface_diffuse(in->plan.level[2 * i], s->light[i].diffuse[c]) +
                              surface_diffuse(in->plan.level[2 * i + 1], s->light[i].specular[c]);
    for (unsigned c = 0; c < s->channels; c++)
        setup->flat[c] = setup->flat[c] < s->top[c] ? setup->flat[c] : s->top[c];
}

/* One channel, linear where `bulge` is null. */
static void interpolate(struct shade_setup *setup, const struct shade_input *in, unsigned index, int32_t value[3],
                        int32_t *bulge)
{
    const struct bounds range = bounds_of(value); /* of a clipped piece too: it lies in its source */
    const int32_t bend = bulge ? dots_bulge_bend(bulge) : 2;
    const int in_steps = !(index & 1) && surface_fold(in->surface);
    int32_t none[3] = {0, 0, 0};
    struct channel *channel = &setup->channel[index];
    if (index & 1)
        setup->runs_only |= (uint8_t)dots_deep(in->surface->power, range, bend);
    if (index & 1 && USES(USES_FORMATS & ~USES_GREY4))
        setup->wide |= (uint8_t)dots_wide(in->surface->power, range, bend);
    if (in->weight)
        piece_quadratic(in->weight, value, bulge ? bulge : none);
    if (in_steps)
        steps_take(setup, in->surface, range, bend, value, bulge);
    if (bulge) {
        setup->quadratic = 1;
        dots_quadratic(setup, value, bulge, channel);
    } else {
        plane_linear(&setup->plane, value, channel);
    }
    setup->runs_only |= (uint8_t)(channel->exact != 0);
}

static void linear(struct shade_setup *setup, const struct shade_input *in, unsigned index)
{
    int32_t value[3] = {in->lights[0][index], in->lights[1][index], in->lights[2][index]};
    interpolate(setup, in, index, value, 0);
}

/* factors: of the edges 0-1, 1-2, 2-0. The bulge is 2 S - 2 S D = 2 S (1 - D) of S = Ii + Ij, D the length factor:
 * |S| <= 2^15, Q16 D - 1 at most 2^14.8 at 90 degrees: below 2^30, Q14 + 16 + 1 - 3 = Q28. */
static void six(struct shade_setup *setup, const struct shade_input *in, unsigned index, const int32_t factors[3])
{
    int32_t value[3] = {in->lights[0][index], in->lights[1][index], in->lights[2][index]};
    int32_t bulge[3] = {-((value[0] + value[1]) * factors[0]) >> 1, -((value[1] + value[2]) * factors[1]) >> 1,
                        -((value[2] + value[0]) * factors[2]) >> 1};
    interpolate(setup, in, index, value, bulge);
}

void shade_planned(struct shade_setup *setup, const struct shade_input *in)
{
    const struct shade_plan *plan = &in->plan;
    int32_t factors[3];
    setup->runs_only = setup->depth.exact != 0;
    if (plan->rung == PLAN_SIX) {
        plane_setup_quadratic(&setup->plane);
        for (int k = 0; k < 3; k++)
            factors[k] = (int32_t)(dots_length_factor(dots_bend(in, k)) - (1u << 16));
    }
    setup->diffuse_lights = plan->diffuse;
    setup->specular_lights = plan->specular;
    for (unsigned i = 0; i < in->surface->lights; i++) {
        if (plan->diffuse >> i & 1) {
            if (plan->diffuse_bent >> i & 1)
                six(setup, in, 2 * i, factors);
            else
                linear(setup, in, 2 * i);
        }
        if (plan->specular >> i & 1) {
            if (plan->specular_bent >> i & 1)
                six(setup, in, 2 * i + 1, factors);
            else
                linear(setup, in, 2 * i + 1);
        }
    }
}

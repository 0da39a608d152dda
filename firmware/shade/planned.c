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
        setup->runs_only |= fx_u8(dots_deep(s->power, range, bend));
        if (USES(USES_FORMATS & ~USES_GREY4))
            setup->wide |= fx_u8(dots_wide(s->power, range, bend));
    } else if (folds) {
        steps_take(setup, s, range, bend, value, factors ? bulge : 0);
    }
    if (factors)
        dots_quadratic(setup, value, bulge, channel);
    else
        plane_linear(&setup->plane, value, channel);
    setup->runs_only |= fx_u8(channel->exact != 0);
}

/* dots_length_factor() less 1, Q16: to 2^12 of bend its series k/2 + 3 k^2/8 + 5 k^3/16 + 35 k^4/128, within 1 of it,
 * the last product below 2^31.1. */
static int32_t longer(uint32_t bend)
{
    if (bend > 1u << 12)
        return fx_s32(dots_length_factor(bend) - (1u << 16));
    const uint32_t third = bend * (20480 + (bend * 70 >> 8)) >> 16, second = bend * (24576 + third) >> 12;
    return fx_s32((bend * (524288 + second) + (1u << 19)) >> 20);
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
            factors[k] = longer(dots_bend(in, k));
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

/*
 * Duff's in perspective. The normal in space is P / W (shade/perspective.h), and of N.V / |N| the W goes: corner
 * normals of length s_i, linear on the screen, are correct at no cost to a pixel. The largest s is 1, so that lengths
 * are at most 1, as those that the loops expect.
 */
static void weigh(struct perspective *p)
{
    uint32_t most = p->s[0] > p->s[1] ? p->s[0] : p->s[1];
    most = p->s[2] > most ? p->s[2] : most;
    for (int k = 0; k < 3; k++)
        p->s[k] = fx_u16(p->s[k] * 65535u / most);
}

/* Whether 1 - |N|^2 stays below 1/4, less 1/500 for the channel's error, where lengths are s |N|. */
static int is_long(const struct perspective *p, const struct shade_input *in)
{
    uint32_t least = p->s[0] < p->s[1] ? p->s[0] : p->s[1];
    least = p->s[2] < least ? p->s[2] : least;
    return (least * least >> 16) * (65535 - 4 * duff_sum(in)) >> 16 > 49284; /* duff_direct(): 4 S < 2^14 */
}

/* One dot product as a numerator. It rounds to Q14 where loops of lengths take it: half of 2^-14 over .86. */
static void numerator(struct shade_setup *setup, const struct shade_input *in, const struct perspective *p,
                      unsigned index)
{
    const struct surface *s = in->surface;
    struct channel *channel = &setup->channel[index];
    int32_t value[3] = {in->lights[0][index], in->lights[1][index], in->lights[2][index]};
    const struct bounds range = bounds_of(value); /* weights only bring it nearer to 0 */
    if (shade_weight(in))
        piece_linear(shade_weight(in), value);
    if (index & 1) {
        setup->runs_only |= fx_u8(dots_deep(s->power, range, 2));
        setup->wide |= fx_u8(dots_wide(s->power, range, 2));
    }
    if (setup->length) {
        for (int k = 0; k < 3; k++) /* |v| <= 2^14 (1 + 2^-9), s < 2^16 */
            value[k] = (value[k] * p->s[k] + (1 << 15)) >> 16;
        if (!(index & 1))
            steps_take(setup, s, range, 2, value, 0);
        plane_linear(&setup->plane, value, channel);
    } else {
        perspective_linear(p, &setup->plane, value, channel);
    }
    setup->runs_only |= fx_u8(channel->exact != 0);
}

static __attribute__((noinline)) void duff_in_perspective(struct shade_setup *setup, const struct shade_input *in,
                                                          struct perspective *p)
{
    int32_t value[3], bulge[3], squares[3], bulges[3];
    weigh(p);
    setup->length = setup->length && is_long(p, in);
    for (unsigned i = 0; i < surface_lights(in->surface); i++) {
        if (in->plan.diffuse >> i & 1)
            numerator(setup, in, p, 2 * i);
        if (in->plan.specular >> i & 1)
            numerator(setup, in, p, 2 * i + 1);
    }
    duff_lengths(in, value, bulge);
    perspective_numerator(p, value, bulge, squares, bulges);
    if (!setup->length) {
        plane_quadratic_wide(&setup->plane, squares, bulges, &setup->channel[SHADE_SQUARE]);
        return;
    }
    for (int k = 0; k < 3; k++) {
        squares[k] = Q14(1, 1) - ((squares[k] + (1 << 15)) >> 16);
        bulges[k] = -bulges[k];
    }
    plane_quadratic(&setup->plane, squares, bulges, &setup->channel[SHADE_SQUARE]);
}

/* Duff's, whose numerators are linear under far lights. */
void shade_planned_duff(struct shade_setup *setup, const struct shade_input *in)
{
    struct perspective perspective;
    const unsigned lights = surface_lights(in->surface);
    setup->runs_only = setup->depth.exact != 0;
    setup->diffuse_lights = in->plan.diffuse;
    setup->specular_lights = in->plan.specular;
    plane_setup_quadratic(&setup->plane);
    setup->length = duff_direct(setup, in) && shade_alone(setup);
    if (USES(USES_PERSPECTIVE) && !in->plan.undivided && perspective_setup(&perspective, in)) {
        duff_in_perspective(setup, in, &perspective);
        return;
    }
    for (unsigned i = 0; i < lights; i++) {
        if (in->plan.diffuse >> i & 1)
            linear(setup, in, 2 * i, setup->length);
        if (in->plan.specular >> i & 1)
            linear(setup, in, 2 * i + 1, setup->length);
    }
    duff_square(setup, in);
}

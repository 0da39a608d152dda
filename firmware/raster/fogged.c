/* SPDX-License-Identifier: MIT */
#include "raster/fogged.h"

#define ONE_Q14 (1 << 14)

FX_COLD void fogged_begin(struct raster *r, const struct scene_header *scene, int plans)
{
    uint32_t colour[3];
    fog_begin(&r->fog, scene);
    if (!r->fog.kind)
        return;
    /* In Q16 of full intensity a budget in Q8 of 1/255 is the same number, within .4 %. */
    r->fog_allowed = fx_u16(plans ? r->budget / 4 : FOGGED_ALLOWED);
    r->fog_planned = plans != 0;
    surface_colour(&r->palette, scene->fog.colour, colour);
    for (int c = 0; c < 3; c++)
        r->fog_colour[c] = fx_u16(colour[c] >> 7); /* at most 255 * 2^8 */
}

static void find_depths(const struct shade_input *in, int32_t depth[3])
{
    for (int k = 0; k < 3; k++)
        depth[k] = fx_wrap_u16(in->place[k][VERTEX_DEPTH]);
}

unsigned fogged_plan(struct raster *r)
{
    struct fog_plan *plan = &r->fog_plan;
    struct shade_input *in = &r->input;
    int32_t depth[3];
    find_depths(in, depth);
    /* What goes straight into the band is not what runs make of it to the last bit: without the plan it stays that. */
    fog_choose(&r->fog, depth, r->fog_allowed, in->no_plan && !r->surface_table && !r->fold && !r->fog_planned, plan);
    if (plan->kind == FOGGED_WHOLLY) {
        r->effects = 0;
        in->plan = (struct shade_plan){0};
    } else if (plan->kind != FOGGED_NOT) {
        r->effects |= USES_FOG;
    }
    r->surface.fold = r->effects ? 0 : r->fold; /* runs have N.L itself */
    return plan->kind;
}

/* Halvings by which the fog takes from what is off in a triangle's own colour. */
static unsigned faded(const struct fog_plan *plan)
{
    return plan->shown > 1 ? fx_clz(plan->shown - 1) - 16 : 16; /* shown <= 2^16: the next power of 2 above it */
}

uint16_t fogged_budget(const struct raster *r)
{
    const uint32_t whole = r->plan_budget, spent = r->fog_plan.error + fx_u32(r->fog_allowed);
    if (!r->fog.kind || r->fog_plan.kind == FOGGED_NOT)
        return r->plan_budget;
    const uint32_t budget = whole > spent ? (whole - spent) << faded(&r->fog_plan) : 0; /* below 2^32 */
    return fx_u16(budget < 65535 ? budget : 65535);
}

/* By pixel, unless runs do. */
static void set_runs(struct raster *r)
{
    struct fog_plan *plan = &r->fog_plan;
    const int32_t step = fx_wrap_s32(r->setup.depth.p.d);
    const uint32_t size = fx_u32(step < 0 ? -step : step);
    int32_t depth[3];
    if (r->setup.depth.exact || size >> 27)
        return;
    find_depths(&r->input, depth);
    const uint32_t error = fog_run_error(&r->fog, depth, (RUN - 1) * size);
    if (error > r->fog_allowed)
        return;
    plan->kind = FOGGED_BY_RUN;
    plan->error += error;
}

void fogged_setup(struct raster *r, const struct glint_method *method)
{
    struct fog_plan *plan = &r->fog_plan;
    if (plan->kind == FOGGED_LINEARLY)
        plane_linear(&r->setup.plane, plan->part, &r->setup.fog);
    else if (plan->kind == FOGGED_BY_PIXEL)
        set_runs(r);
    if (r->fog_planned) {
        const uint32_t error = fx_u32(r->input.plan.error >> faded(plan)) + plan->error;
        r->input.plan.error = fx_u16(error < 65535 ? error : 65535);
    }
    /* Parts of a triangle have loops of their own too. */
    if (!method->run && plan->kind == FOGGED_EVENLY && plan->part[0] == 0)
        r->effects = r->surface_effects;
}

/*
 * colour + (fog - colour) part, exact at both ends: the difference is taken of whole 2^-8 steps, below 2^16 in size, so
 * that its product is below 2^30, and at 1 it leaves of the colour what is less than that, which no rounding shows, as
 * thresholds and the fog's colour are whole 2^-8 steps.
 */
static inline __attribute__((always_inline)) uint32_t mixed(uint32_t sum, uint32_t top, int32_t fog_q8,
                                                            int32_t part_q14)
{
    const uint32_t own = sum < top ? sum : top;
    return fx_u32(fx_s32(own) + ((fog_q8 - fx_s32(own >> 7)) * part_q14 >> 7));
}

/* The part stepped, Q30: interpolated it may pass its ends by a rounding. A template: `channels` is constant. */
static inline __attribute__((always_inline)) void mix_steps(struct raster *r, uint32_t value, uint32_t step, int n,
                                                            unsigned channels)
{
    const uint32_t top[3] = {r->surface.top[0], r->surface.top[1], r->surface.top[2]};
    const int32_t fog[3] = {r->fog_colour[0], r->fog_colour[1], r->fog_colour[2]};
    for (uint32_t *sum = r->sum[0], *end = sum + 3 * n; sum != end; sum += 3, fx_wrap_inc(&value, step)) {
        int32_t part = fx_wrap_s32(value) >> 16;
        part = part < 0 ? 0 : part;
        part = part > ONE_Q14 ? ONE_Q14 : part;
        for (unsigned c = 0; c < channels; c++)
            sum[c] = mixed(sum[c], top[c], fog[c], part);
    }
}

static void mix_between(struct raster *r, uint32_t value, uint32_t step, int n)
{
    if (raster_channels(r) == 1)
        mix_steps(r, value, step, n, 1);
    else
        mix_steps(r, value, step, n, 3);
}

static uint32_t part_q14(const struct raster *r, uint32_t depth)
{
    return (fog_part(&r->fog, depth) + 2) >> 2;
}

static void mix_each(struct raster *r, int x, int y, int n)
{
    int32_t *part = r->value[0];
    if (r->fog_plan.kind == FOGGED_LINEARLY) { /* over a sliver: by weights, so between its corners' */
        plane_values(&r->setup.plane, &r->setup.fog, x, y, n, part);
        for (int i = 0; i < n; i++)
            part[i] >>= 16;
    } else {
        plane_values(&r->setup.plane, &r->setup.depth, x, y, n, part);
        for (int i = 0; i < n; i++)
            part[i] = fx_s32(part_q14(r, fx_wrap_u32(part[i])));
    }
    for (int i = 0; i < n; i++)
        for (unsigned c = 0; c < raster_channels(r); c++)
            r->sum[i][c] = mixed(r->sum[i][c], r->surface.top[c], r->fog_colour[c], part[i]);
}

/* A linear channel's value, with column and row from its origin. */
FX_WRAPS static uint32_t value_at(const struct raster *r, const struct polynomial *p, int x, int y)
{
    return p->f + p->e * fx_wrap_u32(y - r->setup.plane.oy) + p->d * fx_wrap_u32(x - r->setup.plane.ox);
}

static void mix_run(struct raster *r, int x, int y, int n)
{
    static const int32_t inverse[RUN] = {0,         INT32_MAX, 1 << 30,   715827883, 1 << 29,   429496730,
                                         357913941, 306783378, 1 << 28,   238609294, 214748365, 195225786,
                                         178956971, 165191050, 153391689, 143165577}; /* 2^31 / i */
    const struct polynomial *p = &r->setup.depth.p;
    const int32_t from = fx_s32(fog_part(&r->fog, value_at(r, p, x, y))),
                  to = n > 1 ? fx_s32(fog_part(&r->fog, value_at(r, p, x + n - 1, y))) : from;
    const int32_t step = fx_mulhi_s32((to - from) * (1 << 14), inverse[n - 1]) * 2; /* Q30: less than 1 */
    mix_between(r, fx_u32(from) << 14, fx_wrap_u32(step), n);
}

void fogged_run(struct raster *r, int x, int y, int n)
{
    const struct fog_plan *plan = &r->fog_plan;
    if (plan->kind == FOGGED_BY_RUN)
        mix_run(r, x, y, n);
    else if (plan->kind == FOGGED_EVENLY)
        mix_between(r, fx_u32(plan->part[0]) << 16, 0, n);
    else if (plan->kind == FOGGED_LINEARLY && !r->setup.fog.exact)
        mix_between(r, value_at(r, &r->setup.fog.p, x, y), r->setup.fog.p.d, n);
    else
        mix_each(r, x, y, n);
}

static void nothing(struct shade_setup *setup, const struct shade_input *in)
{
    (void)setup;
    (void)in;
}

static uint32_t draw_fog(struct raster *r, struct edges *e)
{
    for (int c = 0; c < 3; c++)
        r->setup.flat[c] = fx_u32(r->fog_colour[c]) << 7;
    return glint_flat.draw(r, e);
}

const struct glint_method fogged_wholly = {.id = GLINT_FLAT, .setup = nothing, .draw = draw_fog};

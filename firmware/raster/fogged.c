/* SPDX-License-Identifier: MIT */
#include "raster/fogged.h"

#define ONE_Q14 (1 << 14)

/* A quarter of the budget is the fog's, besides what the depths' rounding costs. In Q16 of full intensity a budget in
 * Q8 of 1/255 is the same number, within .4 %. */
static void divide_budget(struct raster *r)
{
    const uint32_t rest = r->budget - (uint32_t)r->budget / 4;
    r->fog_allowed = (uint16_t)(r->budget / 4);
    r->budget = (uint16_t)(rest > r->fog.error ? rest - r->fog.error : 1);
}

FX_COLD void fogged_begin(struct raster *r, const struct scene_header *scene, int plans)
{
    uint32_t colour[3];
    fog_begin(&r->fog, scene);
    if (!r->fog.kind)
        return;
    r->fog_allowed = FOGGED_ALLOWED;
    r->fog_planned = plans != 0;
    if (plans)
        divide_budget(r);
    surface_colour(&r->palette, scene->fog.colour, colour);
    for (int c = 0; c < 3; c++)
        r->fog_colour[c] = (uint16_t)(colour[c] >> 7); /* at most 255 * 2^8 */
}

unsigned fogged_choose(struct raster *r)
{
    struct fog_plan *plan = &r->fog_plan;
    struct shade_input *in = &r->input;
    const int32_t depth[3] = {(uint16_t)in->place[0][VERTEX_DEPTH], (uint16_t)in->place[1][VERTEX_DEPTH],
                              (uint16_t)in->place[2][VERTEX_DEPTH]};
    /* A colour table's pixels are not those of a run to the last bit: without the plan it keeps what it draws. */
    fog_choose(&r->fog, depth, r->fog_allowed, in->no_plan && !in->tabled, plan);
    r->effects = r->surface_effects;
    if (plan->kind == FOGGED_WHOLLY) {
        r->effects = 0;
        in->plan = (struct shade_plan){0};
    } else if (plan->kind != FOGGED_NOT) {
        r->effects |= USES_FOG;
    }
    return plan->kind;
}

void fogged_setup(struct raster *r, const struct glint_method *method)
{
    const struct fog_plan *plan = &r->fog_plan;
    if (plan->kind == FOGGED_LINEARLY)
        plane_linear(&r->setup.plane, plan->part, &r->setup.fog);
    if (r->fog_planned) {
        const uint32_t error = r->input.plan.error + plan->error;
        r->input.plan.fog = plan->kind;
        r->input.plan.error = (uint16_t)(error < 65535 ? error : 65535);
    }
    /* Parts of a triangle have loops of their own too. */
    if (!method->run && plan->kind == FOGGED_EVENLY && plan->part[0] == 0)
        r->effects = r->surface_effects;
}

/* The fog's part at each pixel into r->value[0], Q14. Interpolated it may pass its ends by a rounding. */
static void find_parts(struct raster *r, int x, int y, int n)
{
    int32_t *part = r->value[0];
    const struct fog_plan *plan = &r->fog_plan;
    if (plan->kind == FOGGED_LINEARLY) {
        plane_values(&r->setup.plane, &r->setup.fog, x, y, n, part);
        for (int i = 0; i < n; i++) {
            const int32_t q14 = part[i] >> 16;
            part[i] = q14 < 0 ? 0 : q14 > ONE_Q14 ? ONE_Q14 : q14;
        }
    } else if (plan->kind == FOGGED_BY_PIXEL) {
        plane_values(&r->setup.plane, &r->setup.depth, x, y, n, part);
        for (int i = 0; i < n; i++)
            part[i] = (int32_t)((fog_part(&r->fog, (uint32_t)part[i]) + 2) >> 2);
    } else {
        for (int i = 0; i < n; i++)
            part[i] = plan->part[0];
    }
}

/*
 * colour + (fog - colour) part, exact at both ends: the difference is taken of whole 2^-8 steps, below 2^16 in size, so
 * that its product is below 2^30, and at 1 it leaves of the colour what is less than that, which no rounding shows, as
 * thresholds and the fog's colour are whole 2^-8 steps. A template: `channels` is constant.
 */
static inline __attribute__((always_inline)) void mix(struct raster *r, int n, unsigned channels)
{
    const int32_t *part = r->value[0];
    for (uint32_t *sum = r->sum[0], *end = sum + 3 * n; sum != end; sum += 3, part++)
        for (unsigned c = 0; c < channels; c++) {
            const uint32_t top = r->surface.top[c], own = sum[c] < top ? sum[c] : top;
            const int32_t way = (int32_t)r->fog_colour[c] - (int32_t)(own >> 7);
            sum[c] = (uint32_t)((int32_t)own + (way * *part >> 7));
        }
}

void fogged_run(struct raster *r, int x, int y, int n)
{
    find_parts(r, x, y, n);
    if (raster_channels(r) == 1)
        mix(r, n, 1);
    else
        mix(r, n, 3);
}

static void nothing(struct shade_setup *setup, const struct shade_input *in)
{
    (void)setup;
    (void)in;
}

static uint32_t draw_fog(struct raster *r, struct edges *e)
{
    for (int c = 0; c < 3; c++)
        r->setup.flat[c] = (uint32_t)r->fog_colour[c] << 7;
    return glint_flat.draw(r, e);
}

const struct glint_method fogged_wholly = {.id = GLINT_FLAT, .setup = nothing, .draw = draw_fog};

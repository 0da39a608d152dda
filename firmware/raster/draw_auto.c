/* SPDX-License-Identifier: MIT */
/* The methods between which glint_auto chooses, a triangle each. */
#include "raster/bump.h"
#include "raster/dots.h"
#include "raster/fogged.h"
#include "shade/colour.h"

static void constant_run(struct raster *r, int x, int y, int n)
{
    glint_flat.run(r, x, y, n);
}

static const struct glint_method dark = {
    .id = GLINT_DARK, .setup = shade_constant, .draw = draw_flat, .run = constant_run};
static const struct glint_method constant = {
    .id = GLINT_CONSTANT, .setup = shade_constant, .draw = draw_flat, .run = constant_run};
static const struct glint_method linear = {.id = GLINT_LINEAR,
                                           .uses_tables = 1,
                                           .setup = shade_planned,
                                           .draw = raster_draw_dots,
                                           .run = dots_run,
                                           .colours = COLOURS_OF_DOTS};
static const struct glint_method six = {.id = GLINT_SIX,
                                        .uses_tables = 1,
                                        .setup = shade_planned,
                                        .draw = raster_draw_dots,
                                        .run = dots_run,
                                        .colours = COLOURS_OF_DOTS};

static void duff_run(struct raster *r, int x, int y, int n)
{
    glint_duff.run(r, x, y, n);
}

static const struct glint_method duff = {.id = GLINT_DUFF,
                                         .uses_tables = 1,
                                         .setup = shade_planned_duff,
                                         .draw = draw_duff,
                                         .run = duff_run,
                                         .colours = COLOURS_OF_DOTS};

static const struct glint_method *const rungs[PLAN_RUNGS] = {
    [PLAN_DARK] = &dark, [PLAN_CONSTANT] = &constant, [PLAN_GOURAUD] = &glint_gouraud,         [PLAN_LINEAR] = &linear,
    [PLAN_SIX] = &six,   [PLAN_DUFF] = &duff,         [PLAN_PHONG] = &glint_phong_perspective,
};

static void plan_surface(struct raster *r)
{
    const uint16_t fold = r->surface.fold;
    r->surface.fold = r->fold; /* whatever the fog of the triangle that comes first: the plan is all triangles' */
    surface_plan(&r->surface, &r->palette, r->budget);
    r->surface.fold = fold;
    r->plan_budget = r->surface.plan.budget;
    r->plan_table = r->surface_table;
    r->table_off = table_error(r);
}

/* What tables add to a plan's error: beyond the allowance for roundings it is the budget's. */
static inline uint32_t with(const struct raster *r, uint32_t error, uint32_t off)
{
    return error + (off > r->surface.plan.spare ? off - r->surface.plan.spare : 0);
}

/* Takes the colour or highlight table where the budget has room for what it is off by, and Duff's lengths. */
static void choose_tables(struct raster *r)
{
    struct shade_plan *plan = &r->input.plan;
    const uint32_t budget = r->surface.plan.budget, lengths = plan->rung == PLAN_DUFF ? r->surface.plan.lengths : 0;
    uint32_t error = with(r, plan->error, r->table_off + lengths);
    r->surface_table = r->plan_table;
    if (error > budget) {
        r->surface_table = 0;
        error = with(r, plan->error, lengths);
        if (error > budget && lengths) {
            plan->rung = PLAN_PHONG;
            error = 0;
        }
    }
    plan->error = fx_u16(error);
}

/* Bump maps use grey's table alone, and lengths of their own with it. */
static const struct glint_method *choose_bump(struct raster *r)
{
    struct shade_plan *plan = &r->input.plan;
    plan->none[0] = plan->none[1] = 0;
    const struct glint_method *method = bump_planned(r);
    const uint32_t lengths = plan->rung == PLAN_PHONG ? r->surface.plan.lengths : 0;
    const uint32_t error = with(r, plan->error, r->table_off + lengths);
    r->input.grey_table = r->plan_table && raster_is(r, GLINT_GREY8) && error <= r->surface.plan.budget;
    r->surface_table = r->plan_table;
    plan->error = r->input.grey_table ? fx_u16(error) : plan->error;
    return method;
}

static const struct glint_method *choose_planned(struct raster *r)
{
    struct shade_input *in = &r->input;
    if (!r->surface.plan.power)
        plan_surface(r);
    if (USES(USES_FOG))
        r->surface.plan.budget = fogged_budget(r);
    if (surface_bumps(&r->surface))
        return choose_bump(r);
    if (object_local(in->object)) { /* corner values say nothing of what lies between: each place has its vectors */
        in->plan = (struct shade_plan){.rung = PLAN_PHONG};
    } else {
        const struct plan_triangle triangle = {{in->lights[0], in->lights[1], in->lights[2]},
                                               in->triangle->bend,
                                               in->divides ? plan_shift(in->place) : 0,
                                               in->no_plan};
        plan_triangle(&in->plan, &r->surface.plan, &triangle);
        if (in->plan.rung >= PLAN_LINEAR && in->plan.rung < PLAN_PHONG && (r->plan_table || r->surface.plan.lengths))
            choose_tables(r);
    }
    return in->plan.rung == PLAN_PHONG && !in->divides ? &glint_phong : rungs[in->plan.rung];
}

const struct glint_method glint_auto = {.id = GLINT_FLAT,
                                        .uses_tables = 1,
                                        .vertex_words = COLOUR_WORDS,
                                        .setup = shade_constant,
                                        .draw = draw_flat,
                                        .choose = choose_planned};

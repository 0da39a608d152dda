/* SPDX-License-Identifier: MIT */
/* The methods between which glint_auto chooses, a triangle each. */
#include "raster/raster.h"
#include "shade/colour.h"

static uint32_t draw_constant(struct raster *r, struct edges *e)
{
    return glint_flat.draw(r, e);
}

static const struct glint_method dark = {GLINT_DARK, 0, 0, shade_constant, draw_constant, 0, 0};
static const struct glint_method constant = {GLINT_CONSTANT, 0, 0, shade_constant, draw_constant, 0, 0};
static const struct glint_method linear = {GLINT_LINEAR, 1, 0, shade_planned, raster_draw_dots, 0, 0};
static const struct glint_method six = {GLINT_SIX, 1, 0, shade_planned, raster_draw_dots, 0, 0};

static const struct glint_method *const rungs[PLAN_RUNGS] = {
    [PLAN_DARK] = &dark, [PLAN_CONSTANT] = &constant, [PLAN_GOURAUD] = &glint_gouraud,         [PLAN_LINEAR] = &linear,
    [PLAN_SIX] = &six,   [PLAN_DUFF] = &glint_duff,   [PLAN_PHONG] = &glint_phong_perspective,
};

static const struct glint_method *choose_planned(struct raster *r)
{
    struct shade_input *in = &r->input;
    const struct plan_triangle triangle = {.lights = in->lights,
                                           .bend = in->triangle->bend,
                                           .place = in->place,
                                           .divides = in->divides,
                                           .local = in->object->local != 0,
                                           .keep = in->no_plan};
    if (!r->surface.plan.power)
        surface_plan(&r->surface, &r->palette, r->budget);
    plan_triangle(&in->plan, &r->surface.plan, &triangle);
    return in->plan.rung == PLAN_PHONG && !in->divides ? &glint_phong : rungs[in->plan.rung];
}

const struct glint_method glint_auto = {GLINT_FLAT, 1, COLOUR_WORDS, shade_constant, draw_constant, 0, choose_planned};

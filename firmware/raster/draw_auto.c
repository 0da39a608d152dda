/* SPDX-License-Identifier: MIT */
/* The methods between which glint_auto chooses, a triangle each. */
#include "raster/raster.h"
#include "shade/colour.h"

static const struct glint_method dark = {GLINT_DARK, 0, 0, shade_constant, draw_flat, 0, 0};
static const struct glint_method constant = {GLINT_CONSTANT, 0, 0, shade_constant, draw_flat, 0, 0};
static const struct glint_method linear = {GLINT_LINEAR, 1, 0, shade_planned, raster_draw_dots, 0, 0};
static const struct glint_method six = {GLINT_SIX, 1, 0, shade_planned, raster_draw_dots, 0, 0};

static const struct glint_method *const rungs[PLAN_RUNGS] = {
    [PLAN_DARK] = &dark, [PLAN_CONSTANT] = &constant, [PLAN_GOURAUD] = &glint_gouraud,         [PLAN_LINEAR] = &linear,
    [PLAN_SIX] = &six,   [PLAN_DUFF] = &glint_duff,   [PLAN_PHONG] = &glint_phong_perspective,
};

static const struct glint_method *choose_planned(struct raster *r)
{
    struct shade_input *in = &r->input;
    if (!r->surface.plan.power)
        surface_plan(&r->surface, &r->palette, r->budget);
    if (object_local(in->object)) { /* corner values say nothing of what lies between: each place has its vectors */
        in->plan = (struct shade_plan){.rung = PLAN_PHONG};
    } else {
        const struct plan_triangle triangle = {{in->lights[0], in->lights[1], in->lights[2]},
                                               in->triangle->bend,
                                               in->divides ? plan_shift(in->place) : 0,
                                               in->no_plan};
        plan_triangle(&in->plan, &r->surface.plan, &triangle);
    }
    return in->plan.rung == PLAN_PHONG && !in->divides ? &glint_phong : rungs[in->plan.rung];
}

const struct glint_method glint_auto = {GLINT_FLAT, 1, COLOUR_WORDS, shade_constant, draw_flat, 0, choose_planned};

/* SPDX-License-Identifier: MIT */
#include "glint/show.h"

#include "raster/raster.h"
#include "raster/runs.h"

#include <stddef.h>

const struct show_way show_ways[PLAN_RUNGS] = {
    [PLAN_DARK] = {GLINT_DARK, {70, 70, 78}},         [PLAN_CONSTANT] = {GLINT_CONSTANT, {58, 110, 165}},
    [PLAN_GOURAUD] = {GLINT_GOURAUD, {72, 180, 200}}, [PLAN_LINEAR] = {GLINT_LINEAR, {90, 180, 90}},
    [PLAN_SIX] = {GLINT_SIX, {232, 200, 70}},         [PLAN_DUFF] = {GLINT_DUFF, {226, 128, 50}},
    [PLAN_PHONG] = {GLINT_PHONG, {205, 60, 70}},
};

/* Neighbours in a mesh follow each other. Greys take the green, which they are mostly made of. */
static void show_paint(struct shade_setup *setup, const struct shade_input *in)
{
    static const uint8_t lights[] = {255, 225, 240, 210};
    struct raster *r = (struct raster *)((char *)setup - offsetof(struct raster, setup));
    const uint8_t *rgb = show_ways[in->plan.rung].rgb;
    const uint32_t light = lights[(uintptr_t)in->triangle / sizeof *in->triangle % sizeof lights];
    for (unsigned c = 0; c < 3; c++)
        setup->flat[c] = (rgb[r->surface.channels == 1 ? 1 : c] * light / 255) << 15; /* Q15 */
    r->effects = 0;
}

static const struct glint_method *show_choose(struct raster *r)
{
    glint_auto.choose(r);
    return &show_plan;
}

static void show_run(struct raster *r, int x, int y, int n)
{
    glint_flat.run(r, x, y, n);
}

static uint32_t show_draw(struct raster *r, struct edges *e)
{
    return glint_flat.draw(r, e);
}

/* Its vertex records are auto's. */
const struct glint_method show_plan = {.id = GLINT_FLAT,
                                       .vertex_words = COLOUR_WORDS,
                                       .setup = show_paint,
                                       .draw = show_draw,
                                       .choose = show_choose,
                                       .run = show_run};

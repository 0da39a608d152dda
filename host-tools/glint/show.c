/* SPDX-License-Identifier: MIT */
#include "glint/show.h"

#include "raster/raster.h"
#include "raster/runs.h"

#include <stddef.h>

const struct show_way show_ways[SHOW_WAYS] = {
    {GLINT_DARK, {70, 70, 78}},
    {GLINT_CONSTANT, {58, 110, 165}},
    {GLINT_GOURAUD, {72, 180, 200}},
    {GLINT_LINEAR, {90, 180, 90}},
    {GLINT_SIX, {232, 200, 70}},
    {GLINT_DUFF, {226, 128, 50}},
    {GLINT_PHONG, {205, 60, 70}},
    {GLINT_BUMP_LINEAR, {150, 130, 215}},
    {GLINT_BUMP_QUADRATIC, {165, 95, 200}},
    {GLINT_BUMP_NORMALISED, {215, 95, 170}},
};

/* Neighbours differ in one corner. Greys take the green, which they are mostly made of. */
static void show_paint(struct shade_setup *setup, const struct shade_input *in)
{
    static const uint8_t lights[] = {255, 225, 240, 210};
    struct raster *r = (struct raster *)((char *)setup - offsetof(struct raster, setup));
    const uint16_t *corner = in->triangle->corner;
    const uint8_t *rgb = show_ways[in->plan.rung].rgb;
    const uint32_t light = lights[(corner[0] + corner[1] + corner[2]) % sizeof lights];
    for (unsigned c = 0; c < 3; c++)
        setup->flat[c] = (rgb[r->surface.channels == 1 ? 1 : c] * light / 255) << 15; /* Q15 */
    r->effects = 0;
}

/* Nothing reads the plan's rung behind this: it is the place in show_ways[] from here on. */
static const struct glint_method *show_choose(struct raster *r)
{
    const struct glint_method *method = glint_auto.choose(r);
    uint8_t way = 0;
    while (way < SHOW_WAYS - 1 && show_ways[way].id != method->id)
        way++;
    r->input.plan.rung = way;
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

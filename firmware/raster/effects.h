/* SPDX-License-Identifier: MIT */
/*
 * Effects at pixels: what a surface asks for besides its lights. A run of pixels goes through stages, each a loop of
 * its own: depth test -> the method's lighting -> texture -> fog -> pixels. Surfaces without such effects do not come
 * here.
 */
#ifndef GLINT_EFFECTS_H
#define GLINT_EFFECTS_H

#include "raster/runs.h"

/* Notes in r->surface_effects, and r->effects, what the surface in hand asks for. */
void effects_surface(struct raster *r);

/* Draws the triangle in hand, which `method` has set up. Where its `run` is null, its `draw` calls effects_draw(). */
uint32_t effects_triangle(struct raster *r, struct edges *e, const struct glint_method *method);

/* Draws spans whose colours `shade` makes; returns the pixels that passed the depth test. */
uint32_t effects_draw(struct raster *r, struct edges *e, runs_shade *shade);

/* The same for draws that look at them. */
static inline uint32_t effects_runs(struct raster *r, struct edges *e, runs_shade *shade)
{
    return raster_effects(r) ? effects_draw(r, e, shade) : runs_draw(r, e, shade);
}

#endif

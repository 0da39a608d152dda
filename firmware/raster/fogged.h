/* SPDX-License-Identifier: MIT */
/* Fog in pixels: the last stage of a run, after the clamp. What none of is in sight costs nothing, and what is all fog
 * is drawn as one colour, unlit. */
#ifndef GLINT_FOGGED_H
#define GLINT_FOGGED_H

#include "raster/raster.h"

/* Where fog is linear under methods other than auto: within 1/4 of 1/255 of full intensity, Q16. */
#define FOGGED_ALLOWED 64u

/* The fog of the picture that begins. `plans`: by auto, of whose budget a quarter may be its. */
void fogged_begin(struct raster *r, const struct scene_header *scene, int plans);

/* How the triangle in hand is fogged (enum fogged): into r->fog_plan and r->effects; where wholly, r->input.plan is
 * made empty. */
unsigned fogged_plan(struct raster *r);
static inline unsigned fogged_choose(struct raster *r)
{
    const struct shade_input *in = &r->input;
    const uint16_t clear = r->fog.clear;
    r->effects = r->surface_effects;
    if (!in->no_plan && fx_wrap_u16(in->place[0][VERTEX_DEPTH]) >= clear &&
        fx_wrap_u16(in->place[1][VERTEX_DEPTH]) >= clear && fx_wrap_u16(in->place[2][VERTEX_DEPTH]) >= clear) {
        r->surface.fold = r->effects ? 0 : r->fold;
        return r->fog_plan.kind = FOGGED_NOT;
    }
    return fogged_plan(r);
}

/* What auto's plan of the triangle may be off by: what its fog is off by is taken from the budget, and the rest is more
 * as the fog hides. */
uint16_t fogged_budget(const struct raster *r);

/* Sets up what fogged_run() reads, of a triangle whose plane and depth are set up. */
void fogged_setup(struct raster *r, const struct glint_method *method);

/* Mixes r->sum of n pixels from (x, y) with the fog; clamps it first. */
void fogged_run(struct raster *r, int x, int y, int n);

/* What draws a triangle that is all fog. */
extern const struct glint_method fogged_wholly;

#endif

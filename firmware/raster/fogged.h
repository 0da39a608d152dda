/* SPDX-License-Identifier: MIT */
/* Fog in pixels: the last stage of a run, after the clamp. What none of is in sight costs nothing, and what is all fog
 * is drawn as one colour, unlit. */
#ifndef GLINT_FOGGED_H
#define GLINT_FOGGED_H

#include "raster/raster.h"

/* Where fog is linear under methods other than auto: within 1/4 of 1/255 of full intensity, Q16. */
#define FOGGED_ALLOWED 64u

/* The fog of the picture that begins. */
void fogged_begin(struct raster *r, const struct scene_header *scene);

/* How the triangle in hand, whose plane and depth are set up, is fogged: enum fogged, and r->fog_plan. `allowed` is
 * what may be added to the error there is, Q16 of full intensity. */
unsigned fogged_setup(struct raster *r, uint32_t allowed);

/* Mixes r->sum of n pixels from (x, y) with the fog; clamps it first. */
void fogged_run(struct raster *r, int x, int y, int n);

/* What draws a triangle that is all fog. */
extern const struct glint_method fogged_wholly;

#endif

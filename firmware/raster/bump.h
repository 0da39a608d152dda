/* SPDX-License-Identifier: MIT */
/* The pixels of bump mapping. */
#ifndef GLINT_RASTER_BUMP_H
#define GLINT_RASTER_BUMP_H

#include "raster/raster.h"

/* The map's normals under a run, Q14 and unit, into r->value[3] to [5]. */
void bump_normals(struct raster *r, int x, int y, int n);

/* Draws the set-up triangle straight into 8-bit grey: setup.in_steps (shade/bump.c says when). */
uint32_t bump_grey(struct raster *r, struct edges *e);

/* A texel's z from its x and y. */
static inline int32_t bump_rise(const uint16_t *rise, int32_t x, int32_t y)
{
    return rise[fx_u32(x * x + y * y) >> 7];
}

/* glint_auto's choice for the triangle in hand, of a surface with a map whose plan is made; fills r->input.plan. */
const struct glint_method *bump_planned(struct raster *r);

#endif

/* SPDX-License-Identifier: MIT */
/* The pixels of bump mapping in runs: any format, any number of lights. */
#ifndef GLINT_RASTER_BUMP_H
#define GLINT_RASTER_BUMP_H

#include "raster/raster.h"

/* The map's normals under a run, Q14 and unit, into r->value[3] to [5]. */
void bump_normals(struct raster *r, int x, int y, int n);

/* A texel's z from its x and y. */
static inline int32_t bump_rise(const uint16_t *rise, int32_t x, int32_t y)
{
    return rise[(uint32_t)(x * x + y * y) >> 7];
}

#endif

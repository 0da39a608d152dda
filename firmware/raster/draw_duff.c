/* SPDX-License-Identifier: MIT */
/* Duff's pixels: one reciprocal square root each, for all lights. */
#include "raster/dots.h"

static void shade_run(struct raster *r, int x, int y, int n)
{
    dots_shade(r, x, y, n, DOTS_UNIT);
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    return raster_runs(r, e, shade_run);
}

const struct glint_method glint_duff = {GLINT_DUFF, 0, 0, shade_duff, draw, 0, 0};

/* SPDX-License-Identifier: MIT */
/* Duff's pixels: one reciprocal square root each, for all lights. */
#include "raster/dots.h"
#include "raster/runs.h"

RUNS_APART static void shade_run(struct raster *r, int x, int y, int n)
{
    dots_shade(r, x, y, n, DOTS_UNIT);
}

RUNS_APART static void shade_run_near(struct raster *r, int x, int y, int n)
{
    dots_shade_channels(r, x, y, n, 3, DOTS_UNIT_NEAR); /* in grey too: seldom, and flash is saved */
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    return r->input.object->local ? runs_draw(r, e, shade_run_near) : runs_draw(r, e, shade_run);
}

const struct glint_method glint_duff = {GLINT_DUFF, 0, 0, shade_duff, draw, 0, 0};

/* SPDX-License-Identifier: MIT */
/* Van Overveld and Wyvill's pixels, the normals quadratic over the triangle. */
#include "raster/normals.h"
#include "raster/runs.h"

static uint32_t draw(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, normals_run);
}

const struct glint_method glint_overveld = {GLINT_OVERVELD, 0, 0, shade_overveld, draw, 0, 0};

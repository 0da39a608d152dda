/* SPDX-License-Identifier: MIT */
/* Phong's pixels: the interpolated normal, normalised at each. */
#include "raster/normals.h"
#include "raster/runs.h"

static uint32_t draw(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, normals_run);
}

const struct glint_method glint_phong = {GLINT_PHONG, 0, 0, shade_phong, draw, 0, 0};

/* SPDX-License-Identifier: MIT */
/* Phong's pixels: the interpolated normal, normalised at each. */
#include "raster/normals.h"
#include "raster/runs.h"

static uint32_t draw(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, normals_run);
}

const struct glint_method glint_phong = {
    .id = GLINT_PHONG, .setup = shade_phong, .draw = draw, .run = normals_run, .colours = COLOURS_OF_NORMALS};

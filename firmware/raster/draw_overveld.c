/* SPDX-License-Identifier: MIT */
/* Van Overveld and Wyvill's pixels, the normals quadratic over the triangle. */
#include "raster/normals.h"
#include "raster/runs.h"

static uint32_t draw(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, normals_run);
}

const struct glint_method glint_overveld = {
    .id = GLINT_OVERVELD, .setup = shade_overveld, .draw = draw, .run = normals_run, .colours = COLOURS_OF_NORMALS};

/* SPDX-License-Identifier: MIT */
/* Lee and Jen's pixels. */
#include "raster/normals.h"
#include "raster/runs.h"

static uint32_t draw(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, normals_run);
}

const struct glint_method glint_biquadratic = {GLINT_BIQUADRATIC, 0, 0, shade_biquadratic, draw, 0, 0};

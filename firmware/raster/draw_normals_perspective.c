/* SPDX-License-Identifier: MIT */
/* Perspective-correct pixels of phong and of Lee and Jen's quadratic normals: no reciprocal, where lights are far. */
#include "raster/normals.h"
#include "raster/runs.h"

static uint32_t draw(struct raster *r, struct edges *e)
{
    return r->setup.perspective ? runs_draw(r, e, normals_run_perspective) : runs_draw(r, e, normals_run);
}

const struct glint_method glint_phong_perspective = {GLINT_PHONG, 0, 0, shade_phong_perspective, draw, 0, 0};
const struct glint_method glint_biquadratic_perspective = {
    GLINT_BIQUADRATIC, 0, 0, shade_biquadratic_perspective, draw, 0, 0};

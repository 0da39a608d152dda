/* SPDX-License-Identifier: MIT */
/* Perspective-correct pixels of phong and of Lee and Jen's quadratic normals: no reciprocal, where lights are far. */
#include "raster/normals.h"
#include "raster/runs.h"

static uint32_t draw(struct raster *r, struct edges *e)
{
    return r->setup.perspective ? runs_draw(r, e, normals_run_perspective) : runs_draw(r, e, normals_run);
}

static void run(struct raster *r, int x, int y, int n)
{
    (r->setup.perspective ? normals_run_perspective : normals_run)(r, x, y, n);
}

const struct glint_method glint_phong_perspective = {
    .id = GLINT_PHONG, .setup = shade_phong_perspective, .draw = draw, .run = run, .colours = COLOURS_OF_NORMALS};
const struct glint_method glint_biquadratic_perspective = {.id = GLINT_BIQUADRATIC,
                                                           .setup = shade_biquadratic_perspective,
                                                           .draw = draw,
                                                           .run = run,
                                                           .colours = COLOURS_OF_NORMALS};

/* SPDX-License-Identifier: MIT */
/* Lee and Jen's pixels. */
#include "raster/normals.h"
#include "raster/runs.h"

static uint32_t draw(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, normals_run);
}

const struct glint_method glint_biquadratic = {.id = GLINT_BIQUADRATIC,
                                               .setup = shade_biquadratic,
                                               .draw = draw,
                                               .run = normals_run,
                                               .colours = COLOURS_OF_NORMALS};

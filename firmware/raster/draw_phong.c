/* SPDX-License-Identifier: MIT */
/* Phong's pixels: the interpolated normal, normalised at each. */
#include "raster/normals.h"
#include "raster/runs.h"
#include "raster/spans.h"

#define SHORT_BEND 32768 /* 90 degrees: |N|^2 >= 1 - 4/3 of it = 1/3 */

/* Straight into the band: 8-bit grey under one far light, and no normal so short that its square loses bits. */
static int phong_direct(const struct raster *r)
{
    const uint16_t *bend = r->input.triangle->bend;
    return surface_fold(&r->surface) && surface_lights(&r->surface) == 1 && !object_local(r->input.object) &&
           !r->setup.depth.exact && bend[0] <= SHORT_BEND && bend[1] <= SHORT_BEND && bend[2] <= SHORT_BEND;
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    if (USES(USES_GREY8) && phong_direct(r))
        return spans_grey8_normals(r, e);
    return runs_draw(r, e, normals_run);
}

const struct glint_method glint_phong = {
    .id = GLINT_PHONG, .setup = shade_phong, .draw = draw, .run = normals_run, .colours = COLOURS_OF_NORMALS};

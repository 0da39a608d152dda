/* SPDX-License-Identifier: MIT */
#include "raster/runs.h"
#include "raster/spans.h"

static void shade_run(struct raster *r, int x, int y, int n)
{
    (void)x;
    (void)y;
    for (int i = 0; i < n; i++)
        for (unsigned c = 0; c < raster_channels(r); c++)
            r->sum[i][c] = r->setup.flat[c];
}

uint32_t draw_flat(struct raster *r, struct edges *e)
{
    if (!r->setup.plane.sliver && !raster_dithers(r)) {
        const uint32_t colour = raster_colour(r, r->setup.flat);
        if (raster_is(r, GLINT_RGB565))
            return spans_rgb565_constant(r, e, colour);
        if (raster_is(r, GLINT_GREY8))
            return spans_grey8_constant(r, e, colour);
        if (raster_is(r, GLINT_RGB888))
            return spans_rgb888_constant(r, e, colour);
    }
    return runs_draw(r, e, shade_run);
}

const struct glint_method glint_flat = {.id = GLINT_FLAT, .setup = shade_flat, .draw = draw_flat, .run = shade_run};

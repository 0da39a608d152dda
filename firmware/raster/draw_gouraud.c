/* SPDX-License-Identifier: MIT */
#include "raster/effects.h"
#include "raster/spans.h"
#include "shade/colour.h"

/* Channels are Q24 steps between 0 and 255, so unsigned 32 bits; a rounding below 0 is taken for 0. */
static void shade_run(struct raster *r, int x, int y, int n)
{
    for (unsigned c = 0; c < raster_channels(r); c++) {
        plane_values(&r->setup.plane, &r->setup.channel[c], x, y, n, r->value[0]);
        for (int i = 0; i < n; i++) {
            uint32_t value = fx_wrap_u32(r->value[0][i]);
            r->sum[i][c] = value >= 0xff800000u ? 0 : value >> 9;
        }
    }
}

uint32_t draw_gouraud(struct raster *r, struct edges *e)
{
    if (!r->setup.plane.sliver && !raster_effects(r) && !raster_dithers(r)) {
        if (raster_is(r, GLINT_RGB565))
            return spans_rgb565_colours(r, e);
        if (raster_is(r, GLINT_GREY8))
            return spans_grey8_colours(r, e);
        if (raster_is(r, GLINT_RGB888))
            return spans_rgb888_colours(r, e);
    }
    return effects_runs(r, e, shade_run);
}

const struct glint_method glint_gouraud = {
    .id = GLINT_GOURAUD, .vertex_words = COLOUR_WORDS, .setup = shade_gouraud, .draw = draw_gouraud, .run = shade_run};

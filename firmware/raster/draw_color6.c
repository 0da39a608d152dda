/* SPDX-License-Identifier: MIT */
#include "raster/effects.h"
#include "shade/colour.h"

/* A channel's 2^16 stand for one of its units, of which a step has 2^(22 - bits): see shade_color6(). */
static void shade_run(struct raster *r, int x, int y, int n)
{
    const unsigned down = 16 + 7 - colour_bits(&r->surface);
    for (unsigned c = 0; c < raster_channels(r); c++) {
        plane_values(&r->setup.plane, &r->setup.channel[c], x, y, n, r->value[0]);
        for (int i = 0; i < n; i++)
            r->sum[i][c] = r->value[0][i] > 0 ? fx_u32(r->value[0][i]) >> down : 0;
    }
}

uint32_t draw_color6(struct raster *r, struct edges *e)
{
    return effects_runs(r, e, shade_run);
}

const struct glint_method glint_color6 = {
    .id = GLINT_COLOR6, .vertex_words = COLOUR_WORDS, .setup = shade_color6, .draw = draw_color6, .run = shade_run};

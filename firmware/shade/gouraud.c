/* SPDX-License-Identifier: MIT */
/* Finished colour, clamp and power included, linear over the triangle (Gouraud). */
#include "shade/shade.h"

/* The finished colours of a source corner, Q8 steps, at most 255 * 2^8: made once a vertex and material, and kept
 * behind the vertex record's lights with the material's number and 1. */
static const uint16_t *corner_colour(const struct shade_input *in, int k)
{
    const struct surface *s = in->surface;
    uint16_t *kept = (uint16_t *)in->lights[k] + 2 * s->lights;
    const uint16_t tag = (uint16_t)(in->triangle->material + 1u);
    if (kept[3] != tag) {
        uint32_t colour[3];
        surface_shade(s, in->lights[k], colour);
        for (unsigned c = 0; c < s->channels; c++)
            kept[c] = (uint16_t)(colour[c] >> 7);
        kept[3] = tag;
    }
    return kept;
}

/* Channel values are Q24 steps. */
void shade_gouraud(struct shade_setup *setup, const struct shade_input *in)
{
    const uint16_t *const colour[3] = {corner_colour(in, 0), corner_colour(in, 1), corner_colour(in, 2)};
    for (unsigned c = 0; c < in->surface->channels; c++) {
        int32_t value[3] = {colour[0][c], colour[1][c], colour[2][c]};
        if (in->weight) {
            for (int k = 0; k < 3; k++) { /* weights sum to 2^15: at most 2^31 unsigned */
                uint32_t sum = 0;
                for (int i = 0; i < 3; i++)
                    sum += (uint32_t)colour[i][c] * in->weight[k][i];
                value[k] = (int32_t)(sum >> 15);
            }
        }
        plane_linear(&setup->plane, value, &setup->channel[c]);
    }
}

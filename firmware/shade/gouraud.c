/* SPDX-License-Identifier: MIT */
/* Finished colour, clamp and power included, linear over the triangle (Gouraud). */
#include "shade/shade.h"

/* Channel values are Q24 steps: corners go in as Q8, at most 255 * 2^8 < 2^16. */
void shade_gouraud(struct shade_setup *setup, const struct shade_input *in)
{
    uint32_t colour[3][3];
    for (int k = 0; k < 3; k++)
        surface_shade(in->surface, in->lights[k], colour[k]);
    for (unsigned c = 0; c < in->surface->channels; c++) {
        int32_t value[3];
        for (int k = 0; k < 3; k++)
            value[k] = (int32_t)(colour[k][c] >> 7);
        if (in->weight) {
            int32_t corner[3] = {value[0], value[1], value[2]};
            for (int k = 0; k < 3; k++) { /* weights sum to 2^15: at most 2^31 unsigned */
                uint32_t sum = 0;
                for (int i = 0; i < 3; i++)
                    sum += (uint32_t)corner[i] * in->weight[k][i];
                value[k] = (int32_t)(sum >> 15);
            }
        }
        plane_linear(&setup->plane, value, &setup->channel[c]);
    }
}

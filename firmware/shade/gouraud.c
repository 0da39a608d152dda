/* SPDX-License-Identifier: MIT */
/* Finished colour, clamp and power included, linear over the triangle (Gouraud). */
#include "shade/colour.h"

/* Channel values are Q24 steps. */
void shade_gouraud(struct shade_setup *setup, const struct shade_input *in)
{
    const uint16_t *const colour[3] = {colour_corner(in, 0), colour_corner(in, 1), colour_corner(in, 2)};
    for (unsigned c = 0; c < surface_channels(in->surface); c++) {
        int32_t value[3] = {colour[0][c], colour[1][c], colour[2][c]};
        if (in->weight) {
            for (int k = 0; k < 3; k++) { /* weights sum to 2^15: at most 2^31 unsigned */
                uint32_t sum = 0;
                for (int i = 0; i < 3; i++)
                    sum += fx_u32(colour[i][c]) * in->weight[k][i];
                value[k] = fx_s32(sum >> 15);
            }
        }
        plane_linear(&setup->plane, value, &setup->channel[c]);
    }
}

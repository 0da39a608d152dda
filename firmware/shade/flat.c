/* SPDX-License-Identifier: MIT */
/* One value a triangle: the colour of the mean of its corners' N.L and N.H. A clipped piece has its source's. */
#include "shade/shade.h"

void shade_flat(struct shade_setup *setup, const struct shade_input *in)
{
    int16_t mean[2 * SCENE_MAX_LIGHTS];
    unsigned count = 2u * surface_lights(in->surface);
    for (unsigned i = 0; i < count; i++) {
        int32_t sum = in->lights[0][i] + in->lights[1][i] + in->lights[2][i];
        mean[i] = fx_s16((sum * 21845 + (1 << 15)) >> 16); /* |sum| <= 3 * 2^14: below 2^30.1 */
    }
    surface_shade(in->surface, mean, setup->flat);
}

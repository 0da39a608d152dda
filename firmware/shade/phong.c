/* SPDX-License-Identifier: MIT */
/* The normal linear over the triangle (Phong 1975), to be normalised at each pixel. Channel values are Q30. */
#include "shade/shade.h"

void shade_phong(struct shade_setup *setup, const struct shade_input *in)
{
    for (int axis = 0; axis < 3; axis++) {
        int32_t value[3];
        for (int k = 0; k < 3; k++)
            value[k] = in->vertices[in->triangle->corner[SHADE_TURN(k)]].normal[axis];
        if (in->weight) {
            int32_t corner[3] = {value[0], value[1], value[2]};
            for (int k = 0; k < 3; k++) { /* |corner| <= 2^14 (1 + 2^-13), weights sum to 2^15 */
                int32_t sum = 0;
                for (int i = 0; i < 3; i++)
                    sum += corner[i] * in->weight[k][i];
                value[k] = sum >> 15;
            }
        }
        plane_linear(&setup->plane, value, &setup->channel[axis]);
    }
}

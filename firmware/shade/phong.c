/* SPDX-License-Identifier: MIT */
/* The normal linear over the triangle (Phong 1975), to be normalised at each pixel: channels 0 to 2, Q30. Where a light
 * or the eye is near, the place as well: channels 3 to 5, Q16 position units. */
#include "shade/shade.h"

/* Three components of the source's corners over the triangle: |v| <= 2^15. */
static void components(struct shade_setup *setup, const struct shade_input *in, const int16_t *const corner[3],
                       struct channel *out)
{
    for (int axis = 0; axis < 3; axis++) {
        int32_t value[3] = {corner[0][axis], corner[1][axis], corner[2][axis]};
        if (in->weight) {
            for (int k = 0; k < 3; k++) { /* weights sum to 2^15: |sum| <= 2^30 */
                int32_t sum = 0;
                for (int i = 0; i < 3; i++)
                    sum += corner[i][axis] * in->weight[k][i];
                value[k] = sum >> 15;
            }
        }
        plane_linear(&setup->plane, value, &out[axis]);
    }
}

void shade_phong(struct shade_setup *setup, const struct shade_input *in)
{
    const struct scene_vertex *vertex[3];
    const int16_t *corner[3];
    for (int k = 0; k < 3; k++) {
        vertex[k] = &in->vertices[in->triangle->corner[SHADE_TURN(k)]];
        corner[k] = vertex[k]->normal;
    }
    components(setup, in, corner, setup->channel);
    if (!in->object->local)
        return;
    for (int k = 0; k < 3; k++)
        corner[k] = vertex[k]->position;
    components(setup, in, corner, setup->channel + 3);
}

/* SPDX-License-Identifier: MIT */
/* The normal linear over the triangle (Phong 1975), to be normalised at each pixel: channels 0 to 2, Q30. */
#include "shade/piece.h"

static void find_normals(const struct shade_input *in, const q14_t *normal[3])
{
    for (int k = 0; k < 3; k++)
        normal[k] = in->vertices[in->triangle->corner[SHADE_TURN(k)]].normal;
}

void shade_phong(struct shade_setup *setup, const struct shade_input *in)
{
    const q14_t *normal[3];
    find_normals(in, normal);
    piece_vectors(setup, in, normal, setup->channel);
    piece_place(setup, in);
}

void shade_phong_perspective(struct shade_setup *setup, const struct shade_input *in)
{
    struct perspective perspective;
    const q14_t *normal[3];
    if (!perspective_setup(&perspective, in)) {
        shade_phong(setup, in);
        return;
    }
    setup->perspective = fx_u8(perspective.up + 1u);
    find_normals(in, normal);
    piece_vectors_perspective(setup, in, &perspective, normal, setup->channel);
    piece_place_perspective(setup, in, &perspective);
}

/* SPDX-License-Identifier: MIT */
/* Lee and Jen's quadratic normals; a triangle none of whose edges bends is drawn as phong draws it. */
#include "shade/normal_quadratic.h"
#include "shade/piece.h"

/* The edges on which the mesh has an inflection: those of its triangle, whose corners the input has as 0, 2, 1, so that
 * its edge e is the triangle's 2 - e. */
static unsigned edges_of(const struct shade_input *in)
{
    const unsigned flags = in->triangle->flags;
    if (in->every_zigzag)
        return 7;
    return (flags & 2u) | (flags & 1u) << 2 | (flags >> 2 & 1u);
}

/* 0 if the triangle is linear. */
static int quadratic_of(const struct shade_input *in, struct normal_quadratic *n)
{
    const struct scene_vertex *corner[3];
    normal_quadratic_corners(in, corner);
    if (!normal_quadratic_lee_jen(corner, edges_of(in), n))
        return 0;
    normal_quadratic_restrict(in, n);
    return 1;
}

void shade_biquadratic(struct shade_setup *setup, const struct shade_input *in)
{
    struct normal_quadratic n;
    if (!quadratic_of(in, &n)) {
        shade_phong(setup, in);
        return;
    }
    normal_quadratic_channels(setup, &n);
    piece_place(setup, in);
}

void shade_biquadratic_perspective(struct shade_setup *setup, const struct shade_input *in)
{
    struct perspective perspective;
    struct normal_quadratic n;
    if (!perspective_setup(&perspective, in)) {
        shade_biquadratic(setup, in);
    } else if (!quadratic_of(in, &n)) {
        shade_phong_perspective(setup, in);
    } else {
        setup->perspective = fx_u8(perspective.up + 1u);
        setup->quadratic = 1;
        plane_setup_quadratic(&setup->plane);
        for (int axis = 0; axis < 3; axis++)
            perspective_quadratic(&perspective, &setup->plane, n.value[axis], n.bulge[axis], &setup->channel[axis]);
        piece_place_perspective(setup, in, &perspective);
    }
}

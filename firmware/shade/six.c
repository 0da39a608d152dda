/* SPDX-License-Identifier: MIT */
/*
 * The six-sample quadratic of N.L and N.H with true unit normals at the middles of the edges (X-shading section 2). As
 * |Ni + Nj|^2 = 4 (1 + k), the mesh's k gives their length without a look at the normals.
 */
#include "shade/dots.h"

static void setup_of(struct shade_setup *setup, const struct shade_input *in, const struct perspective *perspective)
{
    struct dots_factors factors;
    for (int k = 0; k < 3; k++)
        factors.edge[k] = dots_length_factor(dots_bend(in, k));
    factors.stretch = 1u << 16;
    factors.are_dots = factors.folds = 1;
    dots_setup(setup, in, &factors, perspective);
}

void shade_six(struct shade_setup *setup, const struct shade_input *in)
{
    setup_of(setup, in, 0);
}

void shade_six_perspective(struct shade_setup *setup, const struct shade_input *in)
{
    struct perspective perspective;
    setup_of(setup, in, perspective_setup(&perspective, in) ? &perspective : 0);
}

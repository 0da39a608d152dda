/* SPDX-License-Identifier: MIT */
/*
 * Van Overveld and Wyvill's quadratic normals, as the baseline that Lee and Jen measure against: once as the quadratic
 * through the corners and the middles of the edges, and once in two levels, along the edges and then along each row.
 */
#include "shade/normal_quadratic.h"
#include "shade/piece.h"

static void over_input(const struct shade_input *in, struct normal_quadratic *n)
{
    const struct scene_vertex *corner[3];
    normal_quadratic_corners(in, corner);
    normal_quadratic_overveld(corner, n);
    normal_quadratic_restrict(in, n);
}

void shade_overveld(struct shade_setup *setup, const struct shade_input *in)
{
    struct normal_quadratic n;
    over_input(in, &n);
    normal_quadratic_channels(setup, &n);
    piece_place(setup, in);
}

/* The corners; the edges and rows are for the pixels. */
void shade_overveld_scan(struct shade_setup *setup, const struct shade_input *in)
{
    struct shade_rows *rows = &setup->rows;
    const struct scene_vertex *corner[3];
    over_input(in, &rows->normal);
    normal_quadratic_corners(in, corner);
    for (int axis = 0; axis < 3; axis++) {
        for (int k = 0; k < 3; k++)
            rows->place[axis][k] = corner[k]->position[axis];
        if (in->weight)
            piece_linear(in->weight, rows->place[axis]);
    }
    rows->y = -1;
    piece_place(setup, in);
}

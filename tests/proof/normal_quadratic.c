/* SPDX-License-Identifier: MIT */
/*
 * shade/normal_quadratic.c: any normals of unit length within 2^-13 and any places of the corners, whichever edges
 * bend. That vector_normalise() gives unit ones is not.
 *
 *   proves: size_of times_q30 dot cross edge_between bend_edge gather normal_quadratic_overveld part_across is_shorter
 *           widen face_normal direction normal_quadratic_lee_jen normal_quadratic_corners normal_quadratic_restrict
 *           normal_quadratic_channels
 *   assumes: plane_setup_quadratic plane_quadratic_large
 *   lemmas: normal_quadratic
 *   options: -eva-precision 0 -eva-slevel 300 -eva-min-loop-unroll 3 -eva-split-return-function direction:0
 */
#include "proof.h"

#include "planes.h"

#include "geometry/rotation.h"

/* In place of geometry/rotation.c: unit vectors within 2^-14. */
void vector_normalise(const int32_t v[3], q30_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = any_s32(-0x40010000, 0x40010000);
}

/*@ requires \valid(plane);
    assigns *plane \from *plane; */
void plane_setup_quadratic(struct plane *plane);

#include "firmware/shade/normal_quadratic.c"
#include "six_samples.h"

void prove(void)
{
    static struct scene_vertex vertex[3];
    static struct shade_setup setup;
    const struct scene_triangle triangle = {.corner = {any_u32(0, 2), any_u32(0, 2), any_u32(0, 2)}};
    uint16_t weight[3][3];
    struct shade_input in = {.triangle = &triangle, .vertices = vertex};
    const struct scene_vertex *corner[3];
    struct normal_quadratic normals;
    any_bytes(vertex, sizeof vertex);
    any_bytes(weight, sizeof weight);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            vertex[k].normal[i] = any_s32(-16386, 16386);
    normal_quadratic_corners(&in, corner);
    normal_quadratic_overveld(corner, &normals);
    normal_quadratic_channels(&setup, &normals);
    normal_quadratic_lee_jen(corner, any_u32(0, 7), &normals);
    normal_quadratic_restrict(&in, &normals);
    in.weight = weight;
    normal_quadratic_restrict(&in, &normals);
    normal_quadratic_channels(&setup, &normals);
}

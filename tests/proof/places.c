/* SPDX-License-Identifier: MIT */
/*
 * shade/piece.c: vectors and places of any triangle and any piece of one, flat and in perspective. Weights sum to 2^15
 * (shade/piece.h), which the lemma has.
 *
 *   proves: component piece_vectors piece_vectors_perspective find_places piece_place piece_place_perspective
 *   assumes: piece_linear plane_linear plane_linear_wide perspective_linear
 *   lemmas: places
 *   options: -eva-precision 0 -eva-min-loop-unroll 3
 */
#include "proof.h"

#include "pieces.h"

/* Of constants these would be branches that nothing reaches. */
static int turned(int k)
{
    return k ? 3 - k : 0;
}
#undef SHADE_TURN
#define SHADE_TURN(k) turned(k)
#undef Q14
#define Q14(num, den) ((num)*16384 / (den))

#include "firmware/shade/piece.c"

static struct shade_setup setup;
static struct scene_vertex vertex[3];

static void places(struct shade_input *in, const struct perspective *perspective, const int16_t *const corner[3])
{
    piece_vectors(&setup, in, corner, setup.channel);
    piece_vectors_perspective(&setup, in, perspective, corner, setup.channel);
    piece_place(&setup, in);
    piece_place_perspective(&setup, in, perspective);
}

void prove(void)
{
    static struct object_state object;
    uint16_t weight[3][3];
    int16_t vector[3][3];
    const int16_t *const corner[3] = {vector[0], vector[1], vector[2]};
    struct clipped_triangle piece;
    const struct scene_triangle triangle = {.corner = {any_u32(0, 2), any_u32(0, 2), any_u32(0, 2)}};
    struct shade_input in = {.triangle = &triangle, .vertices = vertex, .object = &object, .piece = &piece};
    struct perspective perspective;
    any_bytes(vertex, sizeof vertex);
    any_bytes(&object, sizeof object);
    any_bytes(&piece, sizeof piece);
    any_bytes(vector, sizeof vector);
    for (int k = 0; k < 3; k++) {
        perspective.s[k] = any_u32(0, 65535);
        for (int i = 0; i < 3; i++)
            weight[k][i] = any_u32(0, 1 << 15);
    }
    places(&in, &perspective, corner);
    in.weight = weight;
    places(&in, &perspective, corner);
}

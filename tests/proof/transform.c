/* SPDX-License-Identifier: MIT */
/*
 * geometry/transform.c: the camera of any checked scene in a picture of any size, products of 64 bits as they are asked
 * for (placed.c), and what an object's depth is made of.
 *
 *   proves: bits magnitude view_setup depth_setup
 *   assumes: fx_divide_u64
 *   options: -eva-precision 0 -eva-slevel 200 -eva-min-loop-unroll 65 -eva-split-return full
 */
#define PROOF_ANY_USES
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"

#include "firmware/geometry/rotation.c"
#include "firmware/geometry/transform.c"

#define UNIT ((1 << 30) + (1 << 10)) /* of a component, its vector within 2^-20 of 1 */
#define TURN ((1 << 30) + (1 << 14)) /* of a matrix */

volatile int64_t sink;

static int64_t any_within(int64_t most)
{
    return any_s64(-most, most);
}

/* Moved up, as far as that fits; moved down, with room for the half. */
static void shifts(void)
{
    for (int shift = 0; shift <= 62; shift++) {
        sink = scaled(any_within(INT64_MAX >> shift), -shift);
        if (shift)
            sink = scaled(any_within(INT64_MAX - ((int64_t)1 << (shift - 1))), shift);
    }
}

static void sizes(void)
{
    sink = bits(0);
    for (int n = 0; n < 64; n++) {
        const uint64_t least = (uint64_t)1 << n;
        const int size = bits(any_u64(least, least + (least - 1)));
        //@ assert size == n + 1;
        sink = size;
    }
    sink = magnitude(any_within(INT64_MAX));
}

static void cameras(void)
{
    struct scene_header scene;
    struct view view;
    struct scene_camera *c = &scene.camera;
    for (int i = 0; i < 4; i++)
        c->rotation[i] = any_s32(-UNIT, UNIT);
    for (int i = 0; i < 3; i++)
        c->position[i] = any_s32(1 - (1 << 30), (1 << 30) - 1);
    c->kind = any_u32(CAMERA_PERSPECTIVE, CAMERA_ORTHOGRAPHIC);
    c->focal = any_s32(1 << 12, (1 << 30) - 1);
    c->reference_width = any_u32(1, 2048);
    c->reference_height = any_u32(1, 2048);
    c->near_plane = any_s32(1 << 8, INT32_MAX - 1);
    c->far_plane = any_s32((1 << 8) + 1, INT32_MAX);
    view_setup(&view, &scene, any_u32(1, 2048), any_u32(1, 2048));
}

static void depths(int divides)
{
    struct transform t = {.divide = divides};
    struct view view;
    t.range = any_u32(0, (1 << 30) - 1);
    view.near_plane = any_s32(1 << 8, INT32_MAX - 1);
    depth_setup(&t, &view, any_s32(-100, 100));
}

void prove(void)
{
    shifts();
    sizes();
    /* a mesh's centre in the world, Q24, times a scale; that and a way to the eye, turned */
    sink = long_product(any_within((int64_t)1 << 40), any_s32(1 << 8, (1 << 24) - 1), 8, 16);
    sink = long_product(any_within(0x7000LL << 32), any_s32(-TURN, TURN), 16, 30);
    cameras();
    depths(0);
    depths(1);
}

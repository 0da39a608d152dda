/* SPDX-License-Identifier: MIT */
/*
 * geometry/transform.c: any mesh of a checked scene in any pose before any camera. What an object's exponents are
 * chosen by, and that its radius holds a position unit, is shown by the lemma; matrices are any that rotation_matrix()
 * makes of rotations a little too long.
 *
 *   proves: scaled long_product axis_setup transform_setup
 *   assumes: fx_divide_u64
 *   lemmas: placed
 *   options: -eva-precision 0 -eva-slevel 200 -eva-min-loop-unroll 65 -eva-split-return full
 */
#define PROOF_ANY_USES
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"

/*@ requires count: -62 <= down <= 62;
    requires up: down <= 0 ==> -0x7fffffffffffffff <= x * (1 << -down) <= 0x7fffffffffffffff;
    requires room: 1 <= down ==> x <= 0x7fffffffffffffff - (1 << (down - 1)); */
static int64_t scaled(int64_t x, int down);

/*@ requires size: -0x700000000000 <= x <= 0x700000000000; */
static int64_t long_product(int64_t x, int32_t m, int cut, int down);

#include "firmware/geometry/transform.c"

#define END  (1 << 30)               /* of positions */
#define TURN ((1 << 30) + (1 << 14)) /* of a matrix */

/* In place of geometry/rotation.c. */
struct rotation rotation_product(const struct rotation *a, const struct rotation *b)
{
    const struct rotation r = {{0}};
    return r;
}
struct matrix rotation_matrix(const struct rotation *r)
{
    struct matrix m;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m.m[i][j] = any_s32(-TURN, TURN);
    return m;
}

static void any_vector(int32_t v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = any_s32(1 - END, END - 1);
}

void prove(void)
{
    struct view view = {.matrix = rotation_matrix(0)};
    struct pose pose;
    struct scene_mesh mesh;
    struct transform out;
    struct matrix to_eye;
    any_vector(view.position);
    any_vector(mesh.centre);
    any_vector(pose.position);
    view.near_plane = any_s32(1 << 8, INT32_MAX - 1);
    view.far_plane = any_s32((1 << 8) + 1, INT32_MAX);
    view.focal = any_u32(1u << 30, (1u << 31) - 1);
    view.focal_exponent = any_s32(0, 63);
    view.kind = any_u32(CAMERA_PERSPECTIVE, CAMERA_ORTHOGRAPHIC);
    pose.scale = any_s32(1 << 8, (1 << 24) - 1);
    mesh.extent = any_s32(1 << 6, (1 << 30) - 1);
    mesh.radius = any_s32(1, INT32_MAX);
    transform_setup(&out, &view, &mesh, &pose, &to_eye);
}

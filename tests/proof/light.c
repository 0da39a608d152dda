/* SPDX-License-Identifier: MIT */
/*
 * geometry/light.c: any lights, near and far, and any eye in the axes of a mesh of any size in any pose. What is turned
 * is any vector here, and any direction a unit one within 2^-12.
 *
 *   proves: far_point near_point half_way object_light_setup object_near object_way object_local
 *   assumes: object_unit fx_divide_u64
 *   lemmas: light
 *   options: -eva-precision 0 -eva-slevel 200 -eva-min-loop-unroll 30
 */
#define PROOF_ANY_USES
#include "proof.h"

#include "contracts.h"
#include "objects.h"

#include "firmware/fixed/divide.c"

/*@ ensures first: -0x10004000 <= out->at[0] <= 0x10004000;
    ensures second: -0x10004000 <= out->at[1] <= 0x10004000;
    ensures third: -0x10004000 <= out->at[2] <= 0x10004000; */
static void near_point(const q16_t world[3], const struct scene_mesh *mesh, const struct pose *pose,
                       struct object_point *out);

#include "firmware/geometry/light.c"

volatile int sink;

#define END (1 << 30) /* of positions, 2^14 units */

static void any_vector(int32_t v[3], int32_t most)
{
    for (int i = 0; i < 3; i++)
        v[i] = any_s32(-most, most);
}

/* In place of geometry/rotation.c. */
struct matrix rotation_matrix(const struct rotation *r)
{
    struct matrix m = {0};
    return m;
}
void matrix_apply(const struct matrix *m, const int32_t v[3], int32_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = ANY_S32;
}
void matrix_apply_transposed(const struct matrix *m, const int32_t v[3], int32_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = ANY_S32;
}
void vector_normalise(const int32_t v[3], q30_t out[3])
{
    any_vector(out, (1 << 30) + (1 << 14));
}
void light_vector_at(const struct scene_header *scene, const struct scene_light *light, uint32_t time_ms,
                     int32_t out[3])
{
    any_vector(out, INT32_MAX);
}

static struct {
    struct scene_header header;
    struct scene_light light[SCENE_MAX_LIGHTS];
} scene;

static void near(void)
{
    struct scene_mesh mesh = {.extent = any_s32(1 << 6, (1 << 30) - 1)};
    struct pose pose = {.scale = any_s32(1 << 8, (1 << 24) - 1)};
    struct object_point out;
    int32_t world[3];
    any_vector(mesh.centre, END - 1);
    any_vector(pose.position, END - 1);
    any_vector(world, INT32_MAX);
    near_point(world, &mesh, &pose, &out);
}

static void far(void)
{
    struct object_point a, b;
    struct matrix m;
    q30_t v[3];
    q14_t out[3];
    any_vector(v, (1 << 30) + (1 << 14));
    far_point(&m, v, &a);
    far_point(&m, v, &b);
    half_way(&a, &b, out);
}

static void set_up(unsigned viewer, unsigned lights)
{
    static struct object_state object;
    struct scene_mesh mesh = {.extent = any_s32(1 << 6, (1 << 30) - 1)};
    struct pose pose = {.scale = any_s32(1 << 8, (1 << 24) - 1)};
    struct view view;
    struct matrix to_eye;
    any_vector(mesh.centre, END - 1);
    any_vector(pose.position, END - 1);
    any_vector(view.position, END - 1);
    object.mesh = &mesh;
    scene.header.camera.viewer = viewer;
    scene.header.light_count = lights;
    for (unsigned i = 0; i < lights; i++)
        scene.light[i].kind = any_flag() ? LIGHT_POINT : LIGHT_DIRECTIONAL;
    object_light_setup(&object, &scene.header, &view, &pose, &to_eye, ANY_U32);
    sink = object_local(&object);
}

void prove(void)
{
    scene.header.lights = (uint8_t *)scene.light - (uint8_t *)&scene;
    near();
    far();
    set_up(VIEWER_INFINITE, 0);
    set_up(VIEWER_LOCAL, 2);
}

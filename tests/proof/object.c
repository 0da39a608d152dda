/* SPDX-License-Identifier: MIT */
/*
 * geometry/object.c: directions to any light and eye from any place, far and near, and a mesh's vertices placed and lit
 * by no light, one and eight. Eye points and places on the screen are any (project.c proves how they are made).
 *
 *   proves: object_way object_dot towards_point object_towards half_way object_light_at
 *           light_vertex light_locally object_place_vertices
 *   assumes: object_unit fx_rsqrt_norm
 *   lemmas: object
 *   options: -eva-precision 0 -eva-slevel 100 -eva-min-loop-unroll 3 -eva-split-return full
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"
#include "objects.h"

#include "geometry/project.h"

/* In place of the transform's and the divide: any place on the screen. */
static struct eye_point any_point(const struct transform *t, const int16_t p[3])
{
    return (struct eye_point){p[0], p[1], p[2]};
}
static int any_place(const struct transform *t, struct eye_point e, struct screen_point *out)
{
    *out = (struct screen_point){any_s32(-GUARD, GUARD), any_s32(-GUARD, GUARD), any_u32(0, 65535)};
    return any_flag();
}
#define transform_point any_point
#define project         any_place

#include "firmware/geometry/object.c"

#define VERTICES 2

static struct {
    struct scene_header header;
    struct scene_vertex vertex[VERTICES];
} scene;

volatile int32_t sink;

/* Far, a unit vector in Q28, a little too long; near, a place. */
static void any_source(struct object_point *p, int near)
{
    const int32_t most = near ? 1 << 28 : (1 << 28) + (1 << 14);
    *p = (struct object_point){{any_s32(-most, most), any_s32(-most, most), any_s32(-most, most)}, near, 14};
    if (near)
        p->shift = any_s32(0, 8);
}

static void any_vector(q14_t v[3], int32_t most)
{
    for (int i = 0; i < 3; i++)
        v[i] = any_s32(-most, most);
}

static void towards(const struct object_point *p)
{
    const int32_t most = 1 << 23, place[3] = {any_s32(-most, most), any_s32(-most, most), any_s32(-most, most)};
    int32_t out[3];
    object_towards(p, place, out);
}

static void anywhere(const struct object_state *object)
{
    const int32_t most = 32768, place[3] = {any_s32(-most, most), any_s32(-most, most), any_s32(-most, most)};
    q14_t way[3], half[3];
    object_light_at(object, any_u32(0, SCENE_MAX_LIGHTS - 1), place, way, half);
    sink = object_dot(way, half);
}

static void vertices(struct object_state *object, unsigned lights)
{
    static int16_t records[VERTICES * (VERTEX_LIGHTS + 2 * SCENE_MAX_LIGHTS + 1)];
    const struct transform t = {.divide = 1};
    for (unsigned extra = 0; extra < 2; extra++)
        sink = object_place_vertices(object, &scene.header, &t, lights, records, VERTEX_LIGHTS + 2 * lights + extra);
}

void prove(void)
{
    static struct scene_mesh mesh = {.vertex_count = VERTICES};
    static struct object_state object = {.mesh = &mesh};
    mesh.vertices = (uint8_t *)scene.vertex - (uint8_t *)&scene;
    any_bytes(scene.vertex, sizeof scene.vertex);
    for (int i = 0; i < VERTICES; i++)
        any_vector(scene.vertex[i].normal, 16386);
    //@ loop unroll 4;
    for (int near = 0; near < 4; near++) {
        any_source(&object.eye, near & 1);
        towards(&object.eye);
        for (unsigned i = 0; i < SCENE_MAX_LIGHTS; i++) {
            any_source(&object.light[i].source, near >> 1);
            any_vector(object.light[i].towards, UNIT);
            any_vector(object.light[i].half, UNIT);
        }
        object.local = near != 0;
        anywhere(&object);
        vertices(&object, 0);
        vertices(&object, 1);
        vertices(&object, SCENE_MAX_LIGHTS);
    }
}

/* SPDX-License-Identifier: MIT */
/*
 * geometry/rotation.c: vectors and rotations made unit ones, turns by time and by hand, poses between keys, and lights
 * that move: everything that a checked scene may hold, at any time.
 *
 *   proves: inverse_length normalise vector_normalise rotation_spin rotation_turn pose_of_key mix pose_between
 *           pose_from_keys pose_at light_vector_at
 *   assumes: fx_divide_u64 fx_rsqrt_norm
 *   lemmas: motion
 *   options: -eva-precision 0 -eva-slevel 200 -eva-min-loop-unroll 4 -eva-split-return full
 */
#define PROOF_ANY_USES
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"

#include "firmware/fixed/divide.c"
#include "firmware/geometry/rotation.c"

#define UNIT ((1 << 30) + (1 << 10)) /* of a component, its vector within 2^-20 of 1 */
#define END  (1 << 30)               /* of positions */
#define KEYS 3

static struct {
    struct scene_header header;
    struct scene_key key[KEYS];
} scene;

/* In place of firmware/fixed/fixed.c. */
q30_t fx_sin(uint32_t turn)
{
    return any_s32(-(1 << 30), 1 << 30);
}

static void any_vector(int32_t *v, int count, int32_t most)
{
    for (int i = 0; i < count; i++)
        v[i] = any_s32(-most, most);
}

static void any_motion(struct scene_motion *m)
{
    m->kind = any_u32(MOTION_NONE, MOTION_KEYS);
    m->first_key = 0;
    m->key_count = any_u32(1, KEYS);
    any_vector(m->axis, 3, UNIT);
    m->rate = any_s32(1 - (1 << 24), (1 << 24) - 1);
}

static void vectors(void)
{
    int32_t v[3];
    q30_t out[3];
    any_vector(v, 3, END - 1);
    vector_normalise(v, out);
}

static void turns(void)
{
    struct matrix to_eye;
    any_vector(&to_eye.m[0][0], 3, (1 << 30) + (1 << 14));
    any_vector(&to_eye.m[1][0], 3, (1 << 30) + (1 << 14));
    any_vector(&to_eye.m[2][0], 3, (1 << 30) + (1 << 14));
    rotation_turn(&to_eye, any_u32(0, 65535), any_u32(0, 65535));
}

void prove(void)
{
    struct scene_object object;
    struct scene_light light;
    int32_t out[3];
    const uint32_t time = ANY_U32;
    scene.header.keys = (uint8_t *)scene.key - (uint8_t *)&scene;
    for (int i = 0; i < KEYS; i++) {
        scene.key[i].time_ms = ANY_U32;
        any_vector(scene.key[i].rotation, 4, UNIT);
        any_vector(scene.key[i].position, 3, END - 1);
        scene.key[i].scale = any_s32(1 << 8, (1 << 24) - 1);
    }
    vectors();
    turns();
    any_vector(object.rotation, 4, UNIT);
    any_vector(object.position, 3, END - 1);
    object.scale = any_s32(1 << 8, (1 << 24) - 1);
    any_motion(&object.motion);
    pose_at(&scene.header, &object, time);
    any_motion(&light.motion);
    light.kind = any_u32(LIGHT_DIRECTIONAL, LIGHT_POINT);
    any_vector(light.vector, 3, UNIT);
    light_vector_at(&scene.header, &light, time, out);
}

/* SPDX-License-Identifier: MIT */
/*
 * plan/fog.c: the fog of any scene, in perspective and not, its part at any depth, and the cheapest way over any
 * triangle and run.
 *
 *   proves: scaled_of product quotient fitted q16_of closeness_of argument part_of fog_part q14_of first_depth error_of
 *           density_of scale_of fog_begin bow_of exponential_error linear_error fog_run_error set_even fog_choose
 *   assumes: fx_divide_u64 fx_recip_norm fx_exp2_minus
 *   lemmas: fog
 *   options: -eva-precision 0 -eva-slevel 100 -eva-min-loop-unroll 3 -eva-split-return full
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"

#include "firmware/fixed/divide.c"
#include "plan/fog.h"

struct scaled;

/*@ requires offset: 0 <= fog->offset <= 1 << 30; */
static uint16_t error_of(const struct fog *fog, struct scaled a);

#include "firmware/plan/fog.c"

volatile uint32_t sink;

static void triangles(const struct fog *fog)
{
    struct fog_plan plan;
    int32_t depth[3];
    for (int k = 0; k < 3; k++)
        depth[k] = any_s32(0, 65535);
    fog_choose(fog, depth, any_u32(0, 65535), any_flag(), &plan);
    sink = fog_run_error(fog, depth, ANY_U32);
    sink = fog_part(fog, ANY_U32);
}

static void fogs(unsigned kind, unsigned camera)
{
    static struct scene_header scene;
    struct fog fog;
    scene.camera.kind = camera;
    scene.camera.near_plane = any_s32(1 << 8, INT32_MAX - 1);
    scene.camera.far_plane = any_s32((1 << 8) + 1, INT32_MAX);
    scene.fog.kind = kind;
    scene.fog.from = kind == FOG_LINEAR ? any_s32(0, INT32_MAX - 1) : 0;
    scene.fog.to = kind == FOG_LINEAR ? any_s32(1, INT32_MAX) : 0;
    scene.fog.density = kind == FOG_EXPONENTIAL ? any_u32(1, 1u << 28) : 0;
    fog_begin(&fog, &scene);
    if (fog.offset < 1 << 29)
        triangles(&fog);
    else
        triangles(&fog);
}

void prove(void)
{
    //@ loop unroll 2;
    for (int camera = CAMERA_PERSPECTIVE; camera <= CAMERA_ORTHOGRAPHIC; camera++) {
        fogs(FOG_NONE, camera);
        fogs(FOG_LINEAR, camera);
        fogs(FOG_EXPONENTIAL, camera);
    }
}

/* SPDX-License-Identifier: MIT */
/*
 * geometry/project: any eye point that transform_point() may give, by any transform.
 *
 *   proves: enlarged project_extreme project_orthographic into_guard project_clipped project_round project_perspective
 *           project_within project
 *   assumes: fx_recip_norm
 *   options: -eva-precision 2 -eva-slevel 200 -eva-split-return full
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"

#include "firmware/geometry/project.c"

#define FAR ((1 << 29) + (1 << 13)) /* by rotations that are a little too long */

/* Points before the eye and behind it, by shifts that are known or beyond any that moves a number. */
static void points(int divide, int least_shift, int most_shift)
{
    //@ loop unroll 2;
    for (int behind = 0; behind < 2; behind++) {
        struct transform t = {.divide = divide};
        struct screen_point out;
        const int32_t z = behind ? any_s32(-FAR, 0) : any_s32(1, FAR);
        struct eye_point e = {any_s32(-FAR, FAR), any_s32(-FAR, FAR), z};
        t.near_z = any_s32(1, (1 << 30) - 1);
        t.far_z = any_s32(1, (1 << 30) - 1);
        t.range = any_u32(0, (1 << 30) - 1);
        t.shift = any_s32(least_shift, most_shift);
        t.depth_scale = ANY_U32;
        t.depth_shift = divide ? any_s32(-32, 96) : any_s32(15, 47);
        project(&t, e, &out);
        project_clipped(&t, &e, &out);
    }
}

void prove(void)
{
    //@ loop unroll 2;
    for (int divide = 0; divide < 2; divide++) {
        points(divide, -1000, -1);
        //@ loop unroll 64;
        for (int shift = 0; shift < 64; shift++)
            points(divide, shift, shift);
        points(divide, 64, 1000);
    }
}

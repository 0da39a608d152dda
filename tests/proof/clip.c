/* SPDX-License-Identifier: MIT */
/*
 * geometry/clip: distances of any eye point to any plane, and points between any two.
 *
 *   proves: inside mix
 *   options: -eva-precision 2
 */
#include "proof.h"

#include "firmware/geometry/clip.c"

volatile int64_t sink;

#define FAR ((1 << 29) - 1)

void prove(void)
{
    //@ loop unroll 2;
    for (int divide = 0; divide < 2; divide++)
        for (int plane = 0; plane < PLANES; plane++) {
            struct transform t = {.divide = divide};
            const struct eye_point e = {any_s32(-FAR, FAR), any_s32(-FAR, FAR), any_s32(-FAR, FAR)};
            t.near_z = any_s32(1, (1 << 30) - 1);
            t.far_z = any_s32(0, (1 << 30) - 1);
            t.shift = any_s32(-1000, 1000);
            const int64_t distance = inside(&t, &e, plane);
            //@ assert -0x3000000000000000 <= distance <= 0x3000000000000000;
            sink = distance;
        }
    sink = mix(any_s32(-FAR, FAR), any_s32(-FAR, FAR), any_u32(0, 1u << 31));
    sink = mix(any_s32(-16, (1 << 30) + 16), any_s32(-16, (1 << 30) + 16), any_u32(0, 1u << 31));
}

/* SPDX-License-Identifier: MIT */
/*
 * geometry/clip: distances of any eye point to any plane, points between any two, and any polygon cut by any plane.
 *
 *   proves: inside mix cut clip_plane
 *   assumes: fx_divide_u64
 *   options: -eva-precision 2 -eva-slevel 100 -eva-min-loop-unroll 10
 */
#include "proof.h"

#include "fixed/fixed.h"

/*@ assigns \result \from n, d; */
uint64_t fx_divide_u64(uint64_t n, uint64_t d);

#include "firmware/geometry/clip.c"

volatile int64_t sink;

#define FAR ((1 << 29) - 1)

static struct clip_polygon to;

/* Each corner anywhere. */
static void polygon(struct transform *t, int plane, int count)
{
    struct clip_polygon from = {.count = count};
    for (int i = 0; i < CLIP_MAX_CORNERS; i++) {
        from.corner[i].eye = (struct eye_point){any_s32(-FAR, FAR), any_s32(-FAR, FAR), any_s32(-FAR, FAR)};
        for (int k = 0; k < 3; k++)
            from.corner[i].weight[k] = any_s32(-16, (1 << 30) + 16);
    }
    clip_plane(t, plane, &from, &to);
    //@ assert 0 <= to.count <= CLIP_MAX_CORNERS;
}

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
            //@ loop unroll 10;
            for (int count = 0; count <= CLIP_MAX_CORNERS; count++)
                polygon(&t, plane, count);
        }
    sink = mix(any_s32(-FAR, FAR), any_s32(-FAR, FAR), any_u32(0, 1u << 31));
    sink = mix(any_s32(-16, (1 << 30) + 16), any_s32(-16, (1 << 30) + 16), any_u32(0, 1u << 31));
}

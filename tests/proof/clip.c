/* SPDX-License-Identifier: MIT */
/*
 * geometry/clip: distances of any eye point to any plane, any polygon cut by any plane, any triangle by all of them;
 * near and far planes where an eye point reaches, or beyond. What is cut lies between its ends, as the lemma shows, so
 * that eye points and weights stay in their ranges through all planes, and no cut divides by 0.
 *
 *   proves: inside mix cut clip_plane clip_triangle
 *   assumes: fx_divide_u64
 *   lemmas: clip
 *   options: -eva-precision 0 -eva-slevel 100 -eva-min-loop-unroll 10
 */
#include "proof.h"

#include "contracts.h"
#include "geometry/clip.h"

/*@ requires share: t_q31 <= 0x80000000;
    ensures between: a <= \result <= b || b <= \result <= a; */
static int32_t mix(int32_t a, int32_t b, uint32_t t_q31);

#include "firmware/geometry/clip.c"

/* An eye point as transform_point() gives it, by rotations that are a little too long. */
#define FAR ((1 << 29) + (1 << 13))
#define ONE (1 << 30)

volatile int64_t sink;

static struct clip_polygon polygon, other;

static void any_corners(int count)
{
    polygon.count = count;
    for (int i = 0; i < CLIP_MAX_CORNERS; i++) {
        struct clip_corner *c = &polygon.corner[i];
        c->eye = (struct eye_point){any_s32(-FAR, FAR), any_s32(-FAR, FAR), any_s32(-FAR, FAR)};
        for (int k = 0; k < 3; k++)
            c->weight[k] = any_s32(0, ONE);
    }
}

/* near_z and far_z: what an eye point reaches, or more. */
static void planes(int divide, int near_out, int far_out)
{
    struct transform t = {.divide = divide};
    const struct eye_point e = {any_s32(-FAR, FAR), any_s32(-FAR, FAR), any_s32(-FAR, FAR)};
    t.near_z = near_out ? any_s32(FAR + 1, ONE - 1) : any_s32(1, FAR);
    t.far_z = far_out ? any_s32(FAR + 1, ONE - 1) : any_s32(1, FAR);
    t.shift = any_s32(-1000, 1000);
    for (int plane = 0; plane < PLANES; plane++) {
        const int64_t distance = inside(&t, &e, plane);
        //@ assert -0x3000000000000000 <= distance <= 0x3000000000000000;
        sink = distance;
        //@ loop unroll 10;
        for (int count = 0; !near_out && !far_out && count <= CLIP_MAX_CORNERS; count++) {
            any_corners(count);
            clip_plane(&t, plane, &polygon, &other);
            //@ assert 0 <= other.count <= CLIP_MAX_CORNERS;
        }
    }
    any_corners(3);
    other = polygon;
    clip_triangle(&t, &polygon, &other);
    //@ assert 0 <= polygon.count <= CLIP_MAX_CORNERS;
    for (int i = 0; i < polygon.count; i++) {
        const struct clip_corner c = polygon.corner[i];
        //@ assert -FAR <= c.eye.x <= FAR && -FAR <= c.eye.y <= FAR && -FAR <= c.eye.z <= FAR;
        //@ assert 0 <= c.weight[0] <= ONE && 0 <= c.weight[1] <= ONE && 0 <= c.weight[2] <= ONE;
        sink = c.eye.z;
    }
}

void prove(void)
{
    //@ loop unroll 2;
    for (int divide = 0; divide < 2; divide++) {
        planes(divide, 0, 0);
        planes(divide, 0, 1);
        planes(divide, 1, 0);
        planes(divide, 1, 1);
    }
}

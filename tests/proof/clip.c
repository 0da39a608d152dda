/* SPDX-License-Identifier: MIT */
/*
 * geometry/clip: any triangle of eye points, any transform.
 *
 *   proves: inside mix cut clip_plane clip_triangle
 *   assumes: fx_divide_u64
 *   options: -eva-precision 2 -eva-slevel 100
 */
#include "proof.h"

#include "contracts.h"

#include "firmware/geometry/clip.c"

#define FAR ((1 << 29) - 1)

static void any_corner(struct clip_corner *c)
{
    c->eye.x = any_s32(-FAR, FAR);
    c->eye.y = any_s32(-FAR, FAR);
    c->eye.z = any_s32(-FAR, FAR);
    for (int i = 0; i < 3; i++)
        c->weight[i] = any_s32(-(1 << 4), (1 << 30) + (1 << 4));
}

/* Any polygon of up to as many corners as there is room for: what each plane in turn leaves is one of these. */
static void polygons(int divide)
{
    struct transform t = {.divide = divide};
    struct clip_polygon polygon, other;
    t.near_z = any_s32(1, (1 << 30) - 1);
    t.far_z = any_s32(0, (1 << 30) - 1);
    t.shift = any_s32(-1000, 1000);
    //@ loop unroll 9;
    for (int i = 0; i < CLIP_MAX_CORNERS; i++)
        any_corner(&polygon.corner[i]);
    polygon.count = 3;
    clip_triangle(&t, &polygon, &other);
}

void prove(void)
{
    polygons(0);
    polygons(1);
}

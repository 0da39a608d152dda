/* SPDX-License-Identifier: MIT */
/*
 * plan/summit.c: the summit in any triangle of any normals, whichever way its conditions come out at any point.
 *
 *   proves: point_at is_below between solve cosine_at refine summit_find
 *   lemmas: summit part_corners
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 60
 */
#include "proof.h"

#include "firmware/plan/summit.c"

struct highlighted_conditions highlighted_at(const struct object_state *object, unsigned light,
                                             const struct highlighted_point *point)
{
    struct highlighted_conditions at;
    for (int i = 0; i < 3; i++) {
        //@ assert -0x8000 <= point->place[i] <= 0x8000;
        //@ assert -0x2000000 <= point->normal[i] <= 0x2000000;
    }
    any_bytes(&at, sizeof at);
    return at;
}

static void unit(q14_t out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = any_s32(-16388, 16388);
}

void object_unit(const int32_t v[3], q14_t out[3])
{
    for (int i = 0; i < 3; i++) {
        //@ assert -0x40000000 < v[i] < 0x40000000;
    }
    unit(out);
}

void object_light_at(const struct object_state *object, unsigned light, const int32_t place[3], q14_t towards[3],
                     q14_t half[3])
{
    unit(towards);
    unit(half);
}

void prove(void)
{
    static struct object_state object;
    struct highlighted_point corner[3];
    uint16_t weight[3];
    int opposite;
    object.local = any_flag();
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            corner[k].place[i] = any_s32(-(1 << 15), (1 << 15) - 1);
            corner[k].normal[i] = any_s32(-16386, 16386);
        }
    summit_find(&object, any_u32(0, SCENE_MAX_LIGHTS - 1), corner, weight, &opposite);
}

/* SPDX-License-Identifier: MIT */
/*
 * plan/highlighted.c: the conditions at any point of any mesh, with any normal up to 2^25, for lights and an eye near
 * or far; and the marks of a mesh of three vertices, whose triangles take any of them.
 * highlighted_mark() is without alarm as well: that this program has two-sided materials is a constant, one branch is
 * never taken.
 *
 *   proves: way_to inner triple_sign scaled_of times compare h2_sign highlighted_at highlighted_signs sides_of
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 60
 */
#include "proof.h"

#include "firmware/plan/highlighted.c"

#define STRIDE (VERTEX_LIGHTS + 2 * SCENE_MAX_LIGHTS + HIGHLIGHTED_WORDS + 1)

static struct {
    struct scene_header header;
    struct scene_mesh mesh;
    struct scene_vertex vertex[3];
    struct scene_triangle triangle[2];
} scene;

static void any_point(struct object_point *point)
{
    for (int i = 0; i < 3; i++)
        point->at[i] = any_s32(-(1 << 28), 1 << 28);
    point->near = any_flag();
    point->shift = point->near ? any_s32(0, 8) : 14;
}

void prove(void)
{
    static struct object_state object;
    static int16_t records[3 * STRIDE];
    struct glint_stats stats;
    struct highlighted_point point;
    any_bytes(&stats, sizeof stats);
    any_bytes(&scene, sizeof scene);
    any_bytes(records, sizeof records);
    for (unsigned l = 0; l < SCENE_MAX_LIGHTS; l++)
        any_point(&object.light[l].source);
    any_point(&object.eye);
    for (int i = 0; i < 3; i++) {
        point.place[i] = any_s32(-(1 << 15), 1 << 15);
        point.normal[i] = any_s32(-(1 << 25), 1 << 25);
    }
    highlighted_signs(&object, any_u32(0, SCENE_MAX_LIGHTS), &point);
    object.mesh = &scene.mesh;
    scene.mesh.vertices = (uint8_t *)scene.vertex - (uint8_t *)&scene;
    scene.mesh.triangles = (uint8_t *)scene.triangle - (uint8_t *)&scene;
    scene.mesh.vertex_count = 3;
    scene.mesh.triangle_count = 2;
    for (int t = 0; t < 2; t++)
        for (int k = 0; k < 3; k++)
            scene.triangle[t].corner[k] = any_u32(0, 2);
    //@ loop unroll 9;
    for (unsigned lights = 0; lights <= SCENE_MAX_LIGHTS; lights++) {
        scene.header.light_count = lights;
        highlighted_mark(&object, &scene.header, records, STRIDE, &stats);
    }
}

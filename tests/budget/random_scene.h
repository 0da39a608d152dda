/* SPDX-License-Identifier: MIT */
/* Scenes at random: a net that faces the eye, its normals near and far from its shape, any material, lights near and
 * far, both cameras and viewers. */
#ifndef BUDGET_RANDOM_SCENE_H
#define BUDGET_RANDOM_SCENE_H

#include "../unit/random.h"
#include "../unit/scene_case.h"

#define RANDOM_WIDTH  64
#define RANDOM_HEIGHT 48
#define RANDOM_SIDE   3 /* vertices a side of the mesh */

static struct scene_vertex random_vertices[RANDOM_SIDE * RANDOM_SIDE];
static struct scene_triangle random_triangles[2 * (RANDOM_SIDE - 1) * (RANDOM_SIDE - 1)];

/* Two units wide, its vertices and normals moved at random: `lean` 0 leaves the normals along the view, 3 forgets it.
 */
static inline void random_mesh(struct scene_case *c, double lean)
{
    unsigned count = 0;
    for (int i = 0; i < RANDOM_SIDE * RANDOM_SIDE; i++) {
        double off[3];
        random_direction(off, 3);
        const double at[3] = {(i % RANDOM_SIDE - 1) * .8 + random_real(-.19, .19),
                              (1 - i / RANDOM_SIDE) * .8 + random_real(-.19, .19), random_real(-.4, .4)};
        for (int k = 0; k < 3; k++)
            random_vertices[i].position[k] = (int16_t)lrint(at[k] * 32767);
        scene_case_normal(random_vertices[i].normal, off[0] * lean, off[1] * lean, off[2] * lean + 1.0001);
    }
    for (int row = 0; row < RANDOM_SIDE - 1; row++)
        for (int column = 0; column < RANDOM_SIDE - 1; column++) {
            const int a = row * RANDOM_SIDE + column,
                      corner[2][3] = {{a, a + RANDOM_SIDE, a + RANDOM_SIDE + 1}, {a, a + RANDOM_SIDE + 1, a + 1}};
            for (int t = 0; t < 2; t++, count++) {
                for (int k = 0; k < 3; k++)
                    random_triangles[count].corner[k] = (uint16_t)corner[t][(k + column) % 3];
                scene_case_bend(&random_triangles[count], random_vertices);
            }
        }
    c->mesh[0].vertices = random_vertices;
    c->mesh[0].triangles = random_triangles;
    c->mesh[0].vertex_count = RANDOM_SIDE * RANDOM_SIDE;
    c->mesh[0].triangle_count = count;
    c->object[0].position[2] = (q16_t)(-random_real(1.5, 3) * CASE_UNIT);
}

static inline void random_lights(struct scene_case *c)
{
    const int near = random_fraction() < .3;
    c->light_count = random_fraction() < .6 ? 1 : (unsigned)random_between(2, SCENE_MAX_LIGHTS);
    for (unsigned i = 0; i < c->light_count; i++) {
        struct scene_light *light = &c->light[i];
        double towards[3];
        random_direction(towards, 3);
        light->kind = near && random_fraction() < .7 ? LIGHT_POINT : LIGHT_DIRECTIONAL;
        const double distance = light->kind == LIGHT_POINT ? random_real(.1, 3) * CASE_UNIT : 1 << 30;
        for (int k = 0; k < 3; k++) {
            light->colour[k] = (uint16_t)random_between(0, 32768);
            light->vector[k] = (int32_t)lrint(towards[k] * distance);
        }
        if (light->kind == LIGHT_POINT)
            light->vector[2] += c->object[0].position[2];
    }
}

static inline void random_material(struct scene_material *m)
{
    static const uint16_t exponents[] = {1, 2, 3, 5, 8, 10, 15, 20, 30, 50, 100, 200, 500, 1023};
    for (int k = 0; k < 3; k++) {
        m->diffuse[k] = (uint16_t)random_between(0, 32768);
        m->specular[k] = (uint16_t)random_between(0, 32768);
    }
    m->ka = (uint16_t)random_between(0, 8192);
    m->kd = (uint16_t)random_between(0, 32768);
    m->ks = (uint16_t)random_between(0, 32768);
    m->shininess = exponents[random_between(0, (int)(sizeof exponents / sizeof *exponents) - 1)];
}

/* A checked scene, to be freed. */
static inline struct scene_header *random_scene(uint32_t seed)
{
    struct scene_case c;
    random_seed(seed * 2654435761u + 1);
    for (int i = 0; i < 8; i++)
        random_bits();
    scene_case_default(&c, RANDOM_WIDTH, RANDOM_HEIGHT);
    c.head.camera.kind = random_fraction() < .4 ? CAMERA_ORTHOGRAPHIC : CAMERA_PERSPECTIVE;
    c.head.camera.viewer = random_fraction() < .2 ? VIEWER_LOCAL : VIEWER_INFINITE;
    if (c.head.camera.kind == CAMERA_ORTHOGRAPHIC)
        c.head.camera.focal = 24 * CASE_UNIT;
    c.head.camera.near_plane = CASE_UNIT;
    random_material(&c.material[0]);
    static const double leans[] = {.1, .3, .8, 3};
    random_mesh(&c, leans[random_between(0, 3)] * random_fraction());
    random_lights(&c);
    return scene_case_blob(&c);
}

#endif

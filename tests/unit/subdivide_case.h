/* SPDX-License-Identifier: MIT */
/* What tests of the subdividing methods draw. Include after cmocka.h. */
#ifndef SUBDIVIDE_CASE_H
#define SUBDIVIDE_CASE_H

#include "pack/pack.h"
#include "random.h"

#include "frame_case.h"
#include "scene_case.h"

#define WIDTH  80
#define HEIGHT 60

static const struct glint_method *const methods[] = {&glint_subdivide_recursive, &glint_subdivide_centre,
                                                     &glint_subdivide_regular,   &glint_subdivide_highlight,
                                                     &glint_hybrid_phong,        &glint_hybrid_x};
#define METHODS (sizeof methods / sizeof *methods)

static struct scene_case scene;
static struct scene_vertex vertex[3];
static struct scene_triangle triangle;

/* One curved triangle about a picture's size, or a sliver, under two lights. */
static inline struct scene_header *subdivide_case_scene(int perspective, int shininess)
{
    scene_case_default(&scene, WIDTH, HEIGHT);
    const int thin = random_bits() % 3 == 0;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            vertex[k].position[i] = (int16_t)random_between(-30000, 30000);
        if (thin && k == 2)
            for (int i = 0; i < 3; i++)
                vertex[2].position[i] =
                    (int16_t)((vertex[0].position[i] + vertex[1].position[i]) / 2 + random_between(-900, 900));
        scene_case_normal(vertex[k].normal, random_real(-1, 1), random_real(-1, 1), random_real(.2, 1));
    }
    triangle = (struct scene_triangle){.corner = {0, 1, 2}};
    scene_case_bend(&triangle, vertex);
    scene.mesh[0] = (struct scene_case_mesh){scene.mesh[0].head, vertex, &triangle, 3, 1};
    scene.head.camera.kind = perspective ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC;
    scene.head.camera.viewer = random_bits() & 1 ? VIEWER_LOCAL : VIEWER_INFINITE;
    scene.head.camera.focal = perspective ? WIDTH * CASE_UNIT : 35 * CASE_UNIT;
    scene.head.camera.near_plane = CASE_UNIT;
    scene.object[0].position[2] = (perspective ? -2 : -3) * CASE_UNIT + CASE_UNIT / 2;
    scene.material[0].ka = 4096;
    scene.material[0].kd = scene.material[0].ks = 12000;
    scene.material[0].shininess = (uint16_t)shininess;
    scene.light_count = 2;
    for (int l = 0; l < 2; l++) {
        double v[3];
        random_direction(v, 3);
        for (int i = 0; i < 3; i++) {
            scene.light[l].vector[i] = (int32_t)lrint(v[i] * 0x1p30);
            scene.light[l].colour[i] = 20000;
        }
    }
    if (random_bits() & 1) {
        scene.light[1].kind = LIGHT_POINT;
        for (int i = 0; i < 3; i++)
            scene.light[1].vector[i] = random_between(-2 * CASE_UNIT, 2 * CASE_UNIT);
    }
    return scene_case_blob(&scene);
}

static inline uint8_t *subdivide_case_picture(const struct pack_result *torus, struct glint_config config,
                                              struct glint_stats *stats)
{
    struct frame_case f = frame_case_small(240, 240, GLINT_GREY8);
    f.config.method = config.method;
    f.config.subdivide_area = config.subdivide_area;
    f.config.subdivide_tolerance = config.subdivide_tolerance;
    f.config.subdivide_threshold = config.subdivide_threshold;
    return frame_case_picture(f, torus->scene, 0, stats);
}

#endif

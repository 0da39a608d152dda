/* SPDX-License-Identifier: MIT */
/* Scenes of a few triangles, their corners in sub-pixels, made at random and changed in place. Include after cmocka.h.
 */
#ifndef PICTURES_CASE_H
#define PICTURES_CASE_H

#include "tests/unit/frame_case.h"
#include "tests/unit/random.h"
#include "tests/unit/scene_case.h"

#define CROWD  6 /* triangles of a picture of several */
#define ORDERS 6

static const uint16_t pictures_order[ORDERS][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};

/* A picture under which a position unit is a sub-pixel, and its blob, whose parts are changed in place from here on. */
static inline struct scene_header *pictures_begin(unsigned width, unsigned height, unsigned lights)
{
    static struct scene_case scene;
    static struct scene_vertex vertex[3 * CROWD];
    static struct scene_triangle triangle[CROWD];
    scene_case_default(&scene, (uint16_t)width, (uint16_t)height);
    scene.head.camera.kind = CAMERA_ORTHOGRAPHIC;
    scene.head.camera.focal = CASE_UNIT;
    scene.mesh[0].head.extent = 2048 * CASE_UNIT;
    scene.mesh[0].head.radius = 8192 * CASE_UNIT;
    scene.head.camera.far_plane = 20000 * CASE_UNIT;
    scene.object[0].position[2] = -9000 * CASE_UNIT;
    scene.light_count = lights;
    for (unsigned i = 0; i < lights; i++) {
        double v[3];
        random_direction(v, 3);
        for (int c = 0; c < 3; c++) {
            scene.light[i].vector[c] = (int32_t)lrint((c == 2 ? fabs(v[c]) : v[c]) * (1 << 30));
            scene.light[i].colour[c] = (uint16_t)random_between(8192, 32768);
        }
    }
    struct scene_material *m = &scene.material[0];
    static const uint16_t exponents[] = {1, 2, 5, 20, 50, 200, 1023};
    m->shininess = exponents[random_bits() % 7];
    m->kd = (uint16_t)random_between(0, 32768);
    m->ks = (uint16_t)(random_bits() % 3 ? random_between(0, 32768) : 0);
    m->ka = (uint16_t)random_between(0, 8000);
    m->flags = MATERIAL_TWO_SIDED;
    scene.mesh[0].vertices = vertex;
    scene.mesh[0].triangles = triangle;
    scene.mesh[0].vertex_count = 3 * CROWD;
    scene.mesh[0].triangle_count = CROWD;
    for (unsigned i = 0; i < 3 * CROWD; i++) {
        triangle[i / 3].corner[i % 3] = (uint16_t)i;
        scene_case_normal(vertex[i].normal, 0, 0, 1);
    }
    return scene_case_blob(&scene);
}

static inline int32_t pictures_random_place(unsigned size)
{
    static const int32_t special[] = {GUARD - 1, 1 - GUARD, GUARD - 2, 2 - GUARD, 0, 1, -1};
    const int32_t reach = size < 2000 ? 8 * (int32_t)size + 100 : GUARD - 15; /* nothing is to be clipped */
    switch (random_bits() % 8) {
    case 0:
        return special[random_bits() % 7];
    case 1:
        return random_between(1 - GUARD, GUARD - 1);
    case 2:
    case 3:
        return random_between(-reach / 8, reach / 8) * 8;
    default:
        return random_between(-reach, reach);
    }
}

/* On a line through the picture, far away on either side of it, but for a few sub-pixels. */
static inline void pictures_make_sliver(struct scene_vertex v[3], unsigned width, unsigned height)
{
    const double angle = random_real(0, 2 * 3.14159265358979);
    const int about = 1 << random_bits() % 5, x = random_between(-4 * (int)width, 4 * (int)width),
              y = random_between(-4 * (int)height, 4 * (int)height),
              least = GUARD - 200 - (abs(x) > abs(y) ? abs(x) : abs(y));
    for (int k = 0; k < 3; k++) {
        const double far = k == 2 ? random_real(-99, 99) : (k ? 1 : -1) * random_magnitude(100, least);
        v[k].position[0] = (int16_t)(x + lrint(far * cos(angle)) + random_between(-about, about));
        v[k].position[1] = (int16_t)(y + lrint(far * sin(angle)) + random_between(-about, about));
    }
}

/* Corners anywhere that is not clipped, every fourth time a sliver, every fourth as near everywhere; normals as far
 * apart as they may be, or close. */
static inline void pictures_random_corners(struct scene_vertex v[3], unsigned width, unsigned height)
{
    double n[3], spread = random_magnitude(.01, 3);
    const int level = random_bits() % 4 == 0;
    random_direction(n, 3);
    for (int k = 0; k < 3; k++) {
        double d[3];
        random_direction(d, 3);
        v[k].position[0] = (int16_t)pictures_random_place(width);
        v[k].position[1] = (int16_t)pictures_random_place(height);
        v[k].position[2] = (int16_t)(level ? 100 : random_between(-32767, 32767));
        scene_case_normal(v[k].normal, n[0] + spread * d[0], n[1] + spread * d[1], fabs(n[2]) + spread * d[2]);
    }
    if (random_bits() % 4 == 0)
        pictures_make_sliver(v, width, height);
}

static inline void *pictures_part(struct scene_header *blob, uint32_t offset)
{
    return (uint8_t *)blob + offset;
}

static inline struct scene_mesh *pictures_mesh_of(struct scene_header *blob)
{
    return pictures_part(blob, blob->meshes);
}

/* The mesh is one triangle, its corners in this order. */
static inline void pictures_put_one(struct scene_header *blob, const struct scene_vertex from[3],
                                    const uint16_t order[3])
{
    struct scene_mesh *mesh = pictures_mesh_of(blob);
    struct scene_vertex *v = pictures_part(blob, mesh->vertices);
    struct scene_triangle *t = pictures_part(blob, mesh->triangles);
    memcpy(v, from, 3 * sizeof *v);
    memcpy(t[0].corner, order, sizeof t[0].corner);
    scene_case_bend(&t[0], v);
    mesh->triangle_count = 1;
}

static inline void pictures_level_of(const struct frame_case *f, int x, int y, uint32_t level[3])
{
    const uint8_t *row = f->picture + (size_t)y * glint_row_bytes(&f->config);
    uint16_t colour;
    level[0] = row[f->config.format == GLINT_RGB888 ? 3 * x : f->config.format == GLINT_GREY4 ? x / 2 : x];
    switch (f->config.format) {
    case GLINT_RGB565:
        memcpy(&colour, row + 2 * x, 2);
        level[0] = colour >> 11;
        level[1] = colour >> 5 & 63;
        level[2] = colour & 31;
        break;
    case GLINT_RGB888:
        level[1] = row[3 * x + 1];
        level[2] = row[3 * x + 2];
        break;
    case GLINT_GREY4:
        level[0] = x & 1 ? level[0] & 15 : level[0] >> 4;
        break;
    default:
        break;
    }
}

#endif

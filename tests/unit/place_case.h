/* SPDX-License-Identifier: MIT */
/* A vertex on its way from a mesh to the screen, in double precision. Include after cmocka.h. */
#ifndef PLACE_CASE_H
#define PLACE_CASE_H

#include "geometry/transform.h"
#include "random.h"

#include <string.h>

/* A case: camera, object and mesh, from which both ways start. */
static struct scene_header scene;
static struct scene_mesh mesh;
static struct pose pose;
static uint16_t width, height;

#define PLACE_UNIT 65536 /* a scene unit in Q16 */

struct place {
    double x, y, z; /* eye's axes, scene units, z ahead */
    double sx, sy;  /* sub-pixels from the picture's centre, y down */
    double depth;
};

/* The matrix of a quaternion as stored, rows first. */
static inline void real_matrix(const q30_t q[4], double m[3][3])
{
    const double w = q[0] * 0x1p-30, x = q[1] * 0x1p-30, y = q[2] * 0x1p-30, z = q[3] * 0x1p-30;
    const double rows[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                               {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                               {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
    memcpy(m, rows, sizeof rows);
}

static inline void apply(double m[3][3], const double v[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
}

static inline void world_place(const int16_t p[3], double out[3])
{
    double m[3][3], local[3];
    for (int i = 0; i < 3; i++)
        local[i] = (mesh.centre[i] + mesh.extent * (p[i] / 32768.)) / 65536 * (pose.scale / 65536.);
    real_matrix(pose.rotation.q, m);
    apply(m, local, out);
    for (int i = 0; i < 3; i++)
        out[i] += pose.position[i] / 65536.;
}

static inline double real_focal(void)
{
    const struct scene_camera *c = &scene.camera;
    return c->focal / 65536. * fmin(width / (double)c->reference_width, height / (double)c->reference_height);
}

static inline struct place truth(const int16_t p[3])
{
    const struct scene_camera *c = &scene.camera;
    double m[3][3], world[3], eye[3], f = 16 * real_focal();
    double near_z = c->near_plane / 65536., far_z = c->far_plane / 65536.;
    world_place(p, world);
    for (int i = 0; i < 3; i++)
        world[i] -= c->position[i] / 65536.;
    real_matrix(c->rotation, m);
    apply(m, world, eye);
    struct place at = {eye[0], eye[1], -eye[2], f * eye[0], -f * eye[1], (far_z + eye[2]) / (far_z - near_z)};
    if (c->kind == CAMERA_PERSPECTIVE) {
        at.sx /= at.z;
        at.sy /= at.z;
        at.depth = near_z / at.z;
    }
    at.depth = DEPTH_FAR + at.depth * (DEPTH_NEAR - DEPTH_FAR);
    return at;
}

static inline void random_rotation(q30_t q[4])
{
    double v[4];
    random_direction(v, 4);
    for (int i = 0; i < 4; i++)
        q[i] = (q30_t)lrint(v[i] * 0x1p30);
}

/* Something that is likely to be seen: in front of the camera, some pixels large, at any scale of the numbers. */
static inline void random_case(enum scene_camera_kind kind)
{
    struct scene_camera *c = &scene.camera;
    width = (uint16_t)random_between(1, 1024);
    height = (uint16_t)random_between(1, 1024);
    c->kind = (uint16_t)kind;
    random_rotation(c->rotation);
    random_rotation(pose.rotation.q);
    c->reference_width = (uint16_t)random_between(1, 2048);
    c->reference_height = (uint16_t)random_between(1, 2048);
    pose.scale = (q16_t)random_magnitude(1 << 8, (1 << 24) - 1);
    mesh.extent = (q16_t)random_magnitude(1 << 6, (1 << 30) - 1);
    mesh.radius = (q16_t)fmin(mesh.extent * 1.7320818 + 1, 0x1p31 - 1);
    double size = mesh.extent * (double)pose.scale / 65536, m[3][3], offset[3], ahead[3];
    double distance = fmin(size * random_magnitude(.5, 4000), 0x1p29);
    double most = 65536 * random_magnitude(1, 16384), aside = distance * random_real(0, .7);
    if (distance < 256)
        distance = 256;
    /* the object's centre, from the eye, turned back into the world */
    for (int i = 0; i < 3; i++)
        ahead[i] = i == 2 ? -distance : random_real(-aside, aside);
    real_matrix(c->rotation, m);
    for (int i = 0; i < 3; i++)
        offset[i] = m[0][i] * ahead[0] + m[1][i] * ahead[1] + m[2][i] * ahead[2];
    for (int i = 0; i < 3; i++) {
        mesh.centre[i] = random_bits() & 1 ? (q16_t)random_real(-mesh.extent, mesh.extent) : 0;
        c->position[i] = (q16_t)fmax(fmin(random_real(-most, most), 0x1p30 - 1), 1 - 0x1p30);
        pose.position[i] = (q16_t)fmax(fmin(c->position[i] + offset[i], 0x1p30 - 1), 1 - 0x1p30);
    }
    double pixels = random_magnitude(2, 600), f = pixels * 65536 / size;
    f = kind == CAMERA_PERSPECTIVE ? f * distance / 65536 : f;
    f *= 65536 / fmin(width / (double)c->reference_width, height / (double)c->reference_height);
    c->focal = (q16_t)fmax(fmin(f, 0x1p30 - 1), 4096);
    c->near_plane = (q16_t)fmax(fmin(distance * random_real(.001, 1), 0x1p30), 256);
    c->far_plane = (q16_t)fmin(c->near_plane + 2 * size + distance * random_real(1, 3), 0x1p31 - 1);
}

static inline void random_position(int16_t p[3])
{
    for (int i = 0; i < 3; i++)
        p[i] = (int16_t)(random_bits() % 4 ? random_between(-32768, 32767) : random_between(0, 1) * 65535 - 32768);
}

#endif

/* SPDX-License-Identifier: MIT */
/* Rotations as unit quaternions (w, x, y, z) and 3x3 matrices, Q30; where a thing is at a moment of its motion. */
#ifndef GLINT_ROTATION_H
#define GLINT_ROTATION_H

#include "scene/scene.h"

struct rotation {
    q30_t q[4];
};

struct matrix {
    q30_t m[3][3]; /* rows */
};

/* Where an object (or light) is: p' = rotation(scale * p) + position. */
struct pose {
    struct rotation rotation;
    q16_t position[3];
    q16_t scale;
};

/* First b, then a. Lengths multiply; the error is below 2^-28 a product. */
struct rotation rotation_product(const struct rotation *a, const struct rotation *b);

/* The matrix of a rotation whose length is within 2^-17 of 1; elements err by less than 2^-27 of those of the
 * quaternion as stored. */
struct matrix rotation_matrix(const struct rotation *r);

/* m * v and its transpose * v, for |v| components below 2^31 in any Q; rounded to nearest. The result must fit. */
void matrix_apply(const struct matrix *m, const int32_t v[3], int32_t out[3]);
void matrix_apply_transposed(const struct matrix *m, const int32_t v[3], int32_t out[3]);

/* v / |v| in Q30 for any v but 0, components below 2^30; of 0: (0, 0, 1). Error below 2^-26. */
void vector_normalise(const int32_t v[3], q30_t out[3]);

/* Turned by `rate` turns a second for `time_ms` about a unit axis. */
struct rotation rotation_spin(const q30_t axis[3], q16_t rate, uint32_t time_ms);

/* A turn in the eye's axes as one in the world's: first the front goes right by `yaw` about the eye's y, then up by
 * `pitch` about its x, both in 1/65536 turns. `to_eye` is the camera's matrix. Error below 2^-28 beyond that of the
 * camera's length; quarter turns about one axis have the exact matrix where the camera is not turned. */
struct rotation rotation_turn(const struct matrix *to_eye, uint16_t yaw, uint16_t pitch);

/* The pose of an object at a time. Between keys, rotation is interpolated linearly along the shorter way and
 * normalised, position and scale linearly. */
struct pose pose_at(const struct scene_header *scene, const struct scene_object *object, uint32_t time_ms);

/* A light's vector at a time (scene_light: Q30 direction or Q16 position). */
void light_vector_at(const struct scene_header *scene, const struct scene_light *light, uint32_t time_ms,
                     int32_t out[3]);

#endif

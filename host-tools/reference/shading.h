/* SPDX-License-Identifier: MIT */
/*
 * The colour of a pixel in double precision: the formula of struct scene_material, and what each method makes of the
 * normals between a triangle's corners.
 */
#ifndef SHADING_H
#define SHADING_H

#include "reference/decode.h"
#include "reference/reference.h"

/* One triangle, ready to be shaded at any point. */
struct shading {
    const struct decode_view *view;
    unsigned channels;
    /* The material under each light. With one channel, the Rec. 601 luma of these products. */
    double ambient[3], diffuse[SCENE_MAX_LIGHTS][3], specular[SCENE_MAX_LIGHTS][3], shininess;
    enum reference_method method;
    struct decode_vertex corner[3];
    double colour[3][3]; /* of the corners, for gouraud */
    /* The dot products N.L [0] and N.H [1] of each light, for x and six: at the corners, and by how much the middle of
     * edge e lies above the mean of its ends, times 4. */
    double dot[SCENE_MAX_LIGHTS][2][3], bulge[SCENE_MAX_LIGHTS][2][3];
};

/* Red, green and blue as they are, or with one channel their Rec. 601 luma. */
void shading_channels(const double rgb[3], unsigned channels, double *out);

/* `bend` as decode_bend() gives it for the three edges. Corners that clipping made have shorter normals than 1. */
void shading_setup(struct shading *shading, const struct decode_view *view, const struct decode_material *material,
                   unsigned channels, enum reference_method method, const struct decode_vertex corner[3],
                   const double bend[3]);

/* The colour, 0..1 a channel, where the barycentric coordinates are `screen` in the picture and `space` in the scene
 * (the same without perspective). */
void shading_pixel(const struct shading *shading, const double screen[3], const double space[3], double colour[3]);

#endif

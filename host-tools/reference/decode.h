/* SPDX-License-Identifier: MIT */
/*
 * A scene blob in double precision, at one moment: the only place where the truth reads the blob. What it decodes is
 * the packed scene, rounding and all, so that the reference draws the very mesh that the integer renderer draws and a
 * difference between the two pictures is the renderer's, not the packer's.
 *
 * Positions and vectors come out in eye space (right-handed, y up, the eye at the origin looking down -z), colours
 * as red, green and blue in 0..1.
 */
#ifndef DECODE_H
#define DECODE_H

#include "scene/scene.h"

#include <stdbool.h>

struct decode_vertex {
    double position[3];
    double normal[3]; /* as packed: its length within 2^-13 of 1 */
    double uv[2];
    double tangent[3], sign; /* of the moving frame, as packed; sign 0: none */
};

struct decode_texture {
    const struct scene_header *scene;
    const struct scene_texture *head; /* null: none */
    double nudge[2];                  /* of what is sampled without filter, in texels */
};

struct decode_material {
    double ambient[3];  /* diffuse * ka * the scene's ambient */
    double diffuse[3];  /* diffuse * kd */
    double specular[3]; /* specular * ks */
    double shininess;
    struct decode_texture texture, bump;
    double grey[3]; /* what a texel's channels count where one is shaded: luma of the diffuse colour, of sum 1 */
    bool two_sided;
};

struct decode_light {
    bool point;
    double vector[3]; /* unit, towards the light, or its position */
    double colour[3];
};

struct decode_fog {
    int kind; /* enum scene_fog_kind */
    double colour[3], from, to, density;
};

struct decode_view {
    bool perspective, local_viewer;
    double focal; /* pixels, for the picture's size */
    double near_plane, far_plane;
    double background[3];
    struct decode_fog fog;
    unsigned light_count;
    struct decode_light lights[SCENE_MAX_LIGHTS];
};

/* The camera and lights of a checked scene at `time_ms`, for a picture of width x height. */
void decode_view(const struct scene_header *scene, uint32_t time_ms, unsigned width, unsigned height,
                 struct decode_view *view);

/* The vertices of scene_meshes(scene)[object->mesh] as that object places them at `time_ms`. */
void decode_vertices(const struct scene_header *scene, const struct scene_object *object, uint32_t time_ms,
                     struct decode_vertex *vertices);

/* Turns them about the object's own origin as glint_turn() says: the front right by `yaw`, then up by `pitch`, as the
 * eye sees it, in 1/65536 turns. */
void decode_turn(const struct scene_header *scene, const struct scene_object *object, uint32_t time_ms, uint16_t yaw,
                 uint16_t pitch, struct decode_vertex *vertices);

void decode_material(const struct scene_header *scene, unsigned index, struct decode_material *material);

/* Half the loss of the vertices' dot product along edge e, (1 - Ni.Nj) / 2. */
double decode_bend(const struct scene_triangle *triangle, unsigned e);

#endif

/* SPDX-License-Identifier: MIT */
/* One object in a frame: lights turned into its axes, its vertices on the screen and lit. */
#ifndef GLINT_OBJECT_H
#define GLINT_OBJECT_H

#include "geometry/transform.h"

/*
 * A vertex record is int16_t[VERTEX_LIGHTS + 2 * lights]: x and y (28.4, from the picture's centre), depth (as
 * uint16_t), then for each light N.L and N.H in Q14 within [-16384, 16383]. A vertex that cannot be projected has
 * VERTEX_UNPLACED for x.
 */
#define VERTEX_X        0
#define VERTEX_Y        1
#define VERTEX_DEPTH    2
#define VERTEX_LIGHTS   3
#define VERTEX_UNPLACED INT16_MIN

/* The lights as one object sees them: unit vectors in its own axes, Q14. Towards the light, and half-way to the eye. */
struct object_light {
    q14_t towards[3], half[3];
};

struct object_state {
    const struct scene_mesh *mesh;
    uint16_t first_vertex;
    uint16_t reserved;
    struct object_light light[SCENE_MAX_LIGHTS];
};

/* Lights of the scene at a time, in an object's axes. A point light, and the eye of a local viewer, is taken in its
 * direction from the object's position. */
void object_light_setup(struct object_state *object, const struct scene_header *scene, const struct view *view,
                        const struct pose *pose, const struct matrix *to_eye, uint32_t time_ms);

/* Fills the records of all of the mesh's vertices: 1 if each could be placed. */
int object_place_vertices(const struct object_state *object, const struct scene_header *scene,
                          const struct transform *transform, unsigned lights, int16_t *records);

#endif

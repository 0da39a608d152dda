/* SPDX-License-Identifier: MIT */
/* One object in a frame: lights and eye turned into its axes, its vertices on the screen and lit. */
#ifndef GLINT_OBJECT_H
#define GLINT_OBJECT_H

#include "geometry/transform.h"
#include "uses.h"

/*
 * A vertex record begins with int16_t[VERTEX_LIGHTS + 2 * lights]: x and y (28.4, from the picture's centre), depth (as
 * uint16_t), then for each light N.L and N.H in Q14 within [-16384, 16383]. A vertex that cannot be projected has
 * VERTEX_UNPLACED for x.
 */
#define VERTEX_X        0
#define VERTEX_Y        1
#define VERTEX_DEPTH    2
#define VERTEX_LIGHTS   3
#define VERTEX_UNPLACED INT16_MIN

/* A light or the eye as one object sees it. Far: a unit vector towards it in the object's axes, Q14 times 2^shift (0 to
 * 14). Near: its place in the mesh's position units times 2^shift (0 to 8), |p| <= 2^28; one farther than that is taken
 * as far. */
struct object_point {
    int32_t at[3];
    int16_t near, shift;
};

struct object_light {
    q14_t towards[3], half[3]; /* where light and eye are far: towards the light, half-way to the eye */
    struct object_point source;
};

struct object_state {
    const struct scene_mesh *mesh;
    uint16_t first_vertex;
    uint16_t local; /* a light or the eye is near: directions differ from place to place */
    struct object_point eye;
    struct object_light light[SCENE_MAX_LIGHTS];
};

/* Whether a place is near, and whether an object sees one that is. */
static inline int object_near(const struct object_point *point)
{
    return USES(USES_POINT_LIGHT | USES_LOCAL_VIEWER) && point->near;
}
/* The way from a place, in position units, to a near point, in these; towards a far one in Q14. The bits below, for
 * which object_towards() is, are left out. */
static inline int32_t object_way(const struct object_point *point, const int32_t place[3], int i)
{
    const int32_t at = point->at[i], below = (1 << point->shift) - 1;
    if (object_near(point))
        return ((at + (at >> 31 & below)) >> point->shift) - place[i]; /* towards 0 */
    return (at + ((below + 1) >> 1)) >> point->shift;                  /* to nearest */
}
static inline int object_local(const struct object_state *object)
{
    return USES(USES_POINT_LIGHT | USES_LOCAL_VIEWER) && object->local;
}

/* Lights and eye of the scene at a time, as an object in a pose sees them. */
void object_light_setup(struct object_state *object, const struct scene_header *scene, const struct view *view,
                        const struct pose *pose, const struct matrix *to_eye, uint32_t time_ms);

/* Towards a light, and half-way from it to the eye, seen from a place in the mesh's position units: unit vectors, Q14,
 * within 2^-12. */
void object_light_at(const struct object_state *object, unsigned light, const int32_t place[3], q14_t towards[3],
                     q14_t half[3]);

/* A unit vector towards a point from a place in 1/256 of position units, Q28, its length within 2^-19 of 1. */
void object_towards(const struct object_point *point, const int32_t place_q8[3], int32_t out[3]);

/* v / |v| in Q14, components of v below 2^30; of 0, (0, 0, 1). */
void object_unit(const int32_t v[3], q14_t out[3]);

/* The dot product of two unit vectors as a vertex record has it. */
static inline int16_t object_dot(const q14_t a[3], const q14_t b[3])
{
    /* |a|, |b| <= 1 + 2^-12 in Q14: |sum| <= 2^28 (1 + 2^-11); each product at most 2^28. */
    int32_t dot = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + (1 << 13)) >> 14;
    return fx_s16(dot > 16383 ? 16383 : dot < -16384 ? -16384 : dot);
}

/* Fills the records of all of the mesh's vertices, `stride` int16_t apart: 1 if each could be placed. What a record has
 * behind its lights is the shading method's; its last word is made 0. */
int object_place_vertices(const struct object_state *object, const struct scene_header *scene,
                          const struct transform *transform, unsigned lights, int16_t *records, unsigned stride);

#endif

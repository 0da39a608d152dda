/* SPDX-License-Identifier: MIT */
#include "geometry/object.h"

#include "geometry/project.h"

static q14_t q14_of_q30(q30_t x)
{
    /* |x| <= 2^30 (1 + 2^-18): the sum fits, the result is at most 16384. */
    return (q14_t)((x + (1 << 15)) >> 16);
}

/* A unit vector of the eye's axes in the object's own. */
static void to_object(const struct matrix *to_eye, const q30_t v[3], q14_t out[3])
{
    q30_t turned[3];
    matrix_apply_transposed(to_eye, v, turned);
    for (int i = 0; i < 3; i++)
        out[i] = q14_of_q30(turned[i]);
}

/* From the object to the eye: along +z at infinity, or from where it is. */
static void towards_eye(const struct scene_header *scene, const struct view *view, const struct pose *pose,
                        q30_t out[3])
{
    if (scene->camera.viewer == VIEWER_INFINITE) {
        out[0] = out[1] = 0;
        out[2] = Q30(1, 1);
        return;
    }
    int32_t from[3], eye[3];
    for (int i = 0; i < 3; i++) /* positions are below 2^30: a quarter of the difference is below 2^29 */
        from[i] = (int32_t)(((int64_t)view->position[i] - pose->position[i]) >> 2);
    matrix_apply(&view->matrix, from, eye);
    vector_normalise(eye, out);
}

void object_light_setup(struct object_state *object, const struct scene_header *scene, const struct view *view,
                        const struct pose *pose, const struct matrix *to_eye, uint32_t time_ms)
{
    const struct scene_light *light = scene_lights(scene);
    q30_t viewer[3];
    towards_eye(scene, view, pose, viewer);
    for (unsigned i = 0; i < scene->light_count; i++, light++) {
        int32_t vector[3], turned[3], half[3];
        q30_t towards[3];
        light_vector_at(scene, light, time_ms, vector);
        if (light->kind == LIGHT_POINT)
            for (int j = 0; j < 3; j++)
                vector[j] = (int32_t)(((int64_t)vector[j] - pose->position[j]) >> 2);
        matrix_apply(&view->matrix, vector, turned);
        for (int j = 0; j < 3; j++)
            turned[j] >>= 2; /* vector_normalise wants |.| < 2^30 */
        vector_normalise(turned, towards);
        for (int j = 0; j < 3; j++)
            half[j] = (towards[j] >> 2) + (viewer[j] >> 2);
        vector_normalise(half, half);
        to_object(to_eye, towards, object->light[i].towards);
        to_object(to_eye, half, object->light[i].half);
    }
}

static inline int16_t dot_q14(const q14_t a[3], const q14_t b[3])
{
    /* |a|, |b| <= 1 + 2^-12 in Q14: |sum| <= 2^28 (1 + 2^-11); each product at most 2^28. */
    int32_t dot = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + (1 << 13)) >> 14;
    return (int16_t)(dot > 16383 ? 16383 : dot < -16384 ? -16384 : dot);
}

/* N.L and N.H of a normal for each light, into a vertex record. */
static inline void light_vertex(const struct object_state *object, unsigned lights, const q14_t normal[3],
                                int16_t *record)
{
    const struct object_light *light = object->light;
    for (int16_t *out = record + VERTEX_LIGHTS; lights; lights--, light++, out += 2) {
        out[0] = dot_q14(normal, light->towards);
        out[1] = dot_q14(normal, light->half);
    }
}

int object_place_vertices(const struct object_state *object, const struct scene_header *scene,
                          const struct transform *transform, unsigned lights, int16_t *records)
{
    const struct scene_vertex *vertex = scene_at(scene, object->mesh->vertices);
    unsigned stride = VERTEX_LIGHTS + 2 * lights;
    int all = 1;
    for (uint32_t n = object->mesh->vertex_count; n; n--, vertex++, records += stride) {
        struct screen_point point = {0, 0, 0};
        int placed = project(transform, transform_point(transform, vertex->position), &point);
        records[VERTEX_X] = placed ? point.x : VERTEX_UNPLACED;
        records[VERTEX_Y] = point.y;
        records[VERTEX_DEPTH] = (int16_t)point.depth;
        all &= placed;
        light_vertex(object, lights, vertex->normal, records);
    }
    return all;
}

/* SPDX-License-Identifier: MIT */
#include "geometry/object.h"

#include "geometry/project.h"

#define FARTHEST (INT64_C(1) << 28)

void object_unit(const int32_t v[3], q14_t out[3])
{
    uint32_t largest = 0;
    for (int i = 0; i < 3; i++)
        largest |= (uint32_t)(v[i] < 0 ? -v[i] : v[i]);
    if (!largest) {
        out[0] = out[1] = 0;
        out[2] = Q14(1, 1);
        return;
    }
    /* To 15 bits: each square is at most 2^30, their sum at most 3 * 2^30, and at least 2^28. */
    int up = (int)fx_clz(largest) - 17;
    int32_t w[3];
    uint32_t squared = 0;
    for (int i = 0; i < 3; i++) {
        w[i] = up >= 0 ? v[i] * (1 << up) : v[i] >> -up;
        squared += (uint32_t)(w[i] * w[i]);
    }
    unsigned half_bits = squared >> 30 ? 0 : 1;
    int32_t inverse = (int32_t)(fx_rsqrt_norm(squared << (2 * half_bits)) >> 1); /* Q30 of 1 / sqrt(squared / 2^30) */
    /* w in Q15 of sqrt(2^30): w * inverse is Q45; a product with w < 2^16 moved up by 1 or 2 is Q14 after mulhi. */
    for (int i = 0; i < 3; i++)
        out[i] = (q14_t)(fx_mulhi_s32(w[i] * (1 << (half_bits + 2)), inverse) >> 1);
}

/* A unit vector of the eye's axes in the object's own, as something far. */
static void far_point(const struct matrix *to_eye, const q30_t v[3], struct object_point *out)
{
    q30_t turned[3];
    matrix_apply_transposed(to_eye, v, turned);
    for (int i = 0; i < 3; i++)
        out->at[i] = (turned[i] + (1 << 15)) >> 16; /* |turned| <= 2^30 (1 + 2^-16) */
    out->near = 0;
}

/* A place of the world in the mesh's position units. */
static void near_point(const q16_t world[3], const struct scene_mesh *mesh, const struct pose *pose,
                       struct object_point *out)
{
    struct matrix rotation = rotation_matrix(&pose->rotation);
    int32_t from[3], turned[3];
    int64_t place[3], largest = 0;
    /* matrix_apply_transposed() wants less than 2^29; differences of positions are below 2^31. They are taken times
     * 2^up / 4: what is near gets up to 12 bits more, since a small mesh has few positions to a Q16. */
    int up = 14;
    for (int i = 0; i < 3; i++) {
        int64_t way = (int64_t)world[i] - pose->position[i];
        while ((way < 0 ? -way : way) << up >> 2 >= 1 << 29)
            up--;
    }
    for (int i = 0; i < 3; i++)
        from[i] = (int32_t)((((int64_t)world[i] - pose->position[i]) * (1 << up)) >> 2);
    matrix_apply_transposed(&rotation, from, turned);
    for (int i = 0; i < 3; i++) {
        /* Q31 of the mesh's units, times 2^up / 4: below 2^60, the centre's share below 2^30 * 2^27 */
        int64_t local = (int64_t)turned[i] * (INT64_C(1) << 31) / pose->scale -
                        (int64_t)mesh->centre[i] * (INT64_C(1) << (13 + up));
        place[i] = local / mesh->extent * 4 / (1 << up);
        int64_t size = place[i] < 0 ? -place[i] : place[i];
        largest = size > largest ? size : largest;
    }
    int down = 0;
    while (largest >> down > FARTHEST)
        down++;
    for (int i = 0; i < 3; i++)
        out->at[i] = (int32_t)(place[i] >> down);
    out->near = down == 0;
    if (down) { /* so far that the mesh is a point */
        q14_t unit[3];
        object_unit(out->at, unit);
        for (int i = 0; i < 3; i++)
            out->at[i] = unit[i];
    }
}

/* Unit vector towards a point from a place. */
static void towards_point(const struct object_point *point, const int32_t place[3], q14_t out[3])
{
    if (!point->near) {
        for (int i = 0; i < 3; i++)
            out[i] = (q14_t)point->at[i];
        return;
    }
    int32_t way[3];
    for (int i = 0; i < 3; i++)
        way[i] = point->at[i] - place[i]; /* below 2^28 + 2^16 */
    object_unit(way, out);
}

static void half_way(const q14_t a[3], const q14_t b[3], q14_t out[3])
{
    int32_t sum[3];
    for (int i = 0; i < 3; i++)
        sum[i] = a[i] + b[i];
    object_unit(sum, out);
}

void object_light_at(const struct object_state *object, unsigned light, const int32_t place[3], q14_t towards[3],
                     q14_t half[3])
{
    const struct object_light *l = &object->light[light];
    towards_point(&l->source, place, towards);
    if (!l->source.near && !object->eye.near) {
        for (int i = 0; i < 3; i++)
            half[i] = l->half[i];
        return;
    }
    q14_t eye[3];
    towards_point(&object->eye, place, eye);
    half_way(towards, eye, half);
}

void object_light_setup(struct object_state *object, const struct scene_header *scene, const struct view *view,
                        const struct pose *pose, const struct matrix *to_eye, uint32_t time_ms)
{
    static const q30_t ahead[3] = {0, 0, Q30(1, 1)};
    const struct scene_light *light = scene_lights(scene);
    if (scene->camera.viewer == VIEWER_INFINITE)
        far_point(to_eye, ahead, &object->eye);
    else
        near_point(view->position, object->mesh, pose, &object->eye);
    object->local = (uint16_t)object->eye.near;
    for (unsigned i = 0; i < scene->light_count; i++, light++) {
        struct object_light *out = &object->light[i];
        int32_t vector[3], turned[3];
        light_vector_at(scene, light, time_ms, vector);
        if (light->kind == LIGHT_POINT) {
            near_point(vector, object->mesh, pose, &out->source);
            object->local |= (uint16_t)out->source.near;
        } else {
            q30_t towards[3];
            matrix_apply(&view->matrix, vector, turned);
            for (int j = 0; j < 3; j++)
                turned[j] >>= 2; /* vector_normalise wants |.| < 2^30 */
            vector_normalise(turned, towards);
            far_point(to_eye, towards, &out->source);
        }
        if (!out->source.near && !object->eye.near) {
            const int32_t nowhere[3] = {0, 0, 0};
            q14_t eye[3];
            towards_point(&out->source, nowhere, out->towards);
            towards_point(&object->eye, nowhere, eye);
            half_way(out->towards, eye, out->half);
        } else {
            for (int j = 0; j < 3; j++)
                out->towards[j] = out->half[j] = 0; /* vertices are lit anew, by place */
        }
    }
}

/* N.L and N.H of a vertex for each light that is far, with a far eye. */
static inline void light_vertex(const struct object_light *light, const struct object_light *end, const q14_t normal[3],
                                int16_t *out)
{
    for (; light != end; light++, out += 2) {
        out[0] = object_dot(normal, light->towards);
        out[1] = object_dot(normal, light->half);
    }
}

/* Lights all vertices anew where directions differ from place to place. */
static void light_locally(const struct object_state *object, const struct scene_vertex *vertex, unsigned lights,
                          int16_t *records, unsigned stride)
{
    for (uint32_t n = object->mesh->vertex_count; n; n--, vertex++, records += stride) {
        const int32_t place[3] = {vertex->position[0], vertex->position[1], vertex->position[2]};
        int16_t *out = records + VERTEX_LIGHTS;
        for (unsigned i = 0; i < lights; i++, out += 2) {
            q14_t towards[3], half[3];
            object_light_at(object, i, place, towards, half);
            out[0] = object_dot(vertex->normal, towards);
            out[1] = object_dot(vertex->normal, half);
        }
    }
}

int object_place_vertices(const struct object_state *object, const struct scene_header *scene,
                          const struct transform *transform, unsigned lights, int16_t *records, unsigned stride)
{
    const struct scene_vertex *const vertices = scene_at(scene, object->mesh->vertices), *vertex = vertices;
    int16_t *record = records;
    int all = 1;
    for (uint32_t n = object->mesh->vertex_count; n; n--, vertex++, record += stride) {
        struct screen_point point = {0, 0, 0};
        int placed = project(transform, transform_point(transform, vertex->position), &point);
        record[VERTEX_X] = placed ? point.x : VERTEX_UNPLACED;
        record[VERTEX_Y] = point.y;
        record[VERTEX_DEPTH] = (int16_t)point.depth;
        all &= placed;
        light_vertex(object->light, object->light + lights, vertex->normal, record + VERTEX_LIGHTS);
    }
    if (stride > VERTEX_LIGHTS + 2 * lights)
        for (; record != records; record -= stride)
            record[-1] = 0;
    if (object->local)
        light_locally(object, vertices, lights, records, stride);
    return all;
}

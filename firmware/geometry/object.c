/* SPDX-License-Identifier: MIT */
#include "geometry/object.h"

#include "geometry/project.h"

void object_unit(const int32_t v[3], q14_t out[3])
{
    uint32_t largest = 0;
    for (int i = 0; i < 3; i++)
        largest |= fx_u32(v[i] < 0 ? -v[i] : v[i]);
    if (!largest) {
        out[0] = out[1] = 0;
        out[2] = Q14(1, 1);
        return;
    }
    /* To 15 bits: each square is at most 2^30, their sum at most 3 * 2^30, and at least 2^28. */
    int up = fx_s32(fx_clz(largest)) - 17;
    int32_t w[3];
    uint32_t squared = 0;
    for (int i = 0; i < 3; i++) {
        w[i] = up >= 0 ? v[i] * (1 << up) : v[i] >> -up;
        squared += fx_u32(w[i] * w[i]);
    }
    unsigned half_bits = squared >> 30 ? 0 : 1;
    int32_t inverse = fx_s32(fx_rsqrt_norm(squared << (2 * half_bits)) >> 1); /* Q30 of 1 / sqrt(squared / 2^30) */
    /* w in Q15 of sqrt(2^30): w * inverse is Q45; a product with w < 2^16 moved up by 1 or 2 is Q14 after mulhi. */
    for (int i = 0; i < 3; i++)
        out[i] = fx_s16(fx_mulhi_s32(w[i] * (1 << (half_bits + 2)), inverse) >> 1);
}

/* Unit vector towards a point from a place. */
static void towards_point(const struct object_point *point, const int32_t place[3], q14_t out[3])
{
    int32_t way[3];
    for (int i = 0; i < 3; i++)
        way[i] = object_way(point, place, i); /* below 2^28 + 2^16 */
    if (object_near(point))
        object_unit(way, out);
    else
        for (int i = 0; i < 3; i++)
            out[i] = fx_s16(way[i]);
}

void object_towards(const struct object_point *point, const int32_t place_q8[3], int32_t out[3])
{
    int32_t way[3];
    uint32_t largest = 0, squared = 0;
    if (!object_near(point)) {
        for (int i = 0; i < 3; i++)
            out[i] = point->at[i] * (1 << (14 - point->shift));
        return;
    }
    for (int i = 0; i < 3; i++) { /* below 2^28 + 2^23 */
        way[i] = point->at[i] - (place_q8[i] >> (8 - point->shift));
        largest |= fx_u32(way[i] < 0 ? -way[i] : way[i]);
    }
    if (!largest) {
        out[0] = out[1] = 0;
        out[2] = 1 << 28;
        return;
    }
    /* to 30 bits: high words of squares are in [2^26, 2^28), their sum below 3 * 2^28 */
    const int32_t up = 1 << (fx_clz(largest) - 2);
    for (int i = 0; i < 3; i++) {
        way[i] *= up;
        squared += fx_u32(fx_mulhi_s32(way[i], way[i]));
    }
    /* even is 2 or 4; with q = squared 2^even, |way| 2^(even / 2) = 2^16 sqrt(q), and inverse = 2^45 / sqrt(q) */
    const unsigned even = fx_clz(squared) & ~1u;
    const int32_t inverse = fx_s32(fx_rsqrt_norm(squared << even) >> 1), scale = 1 << (even / 2 - 1);
    for (int i = 0; i < 3; i++)
        out[i] = fx_mulhi_s32(way[i], inverse) * scale;
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
    if (!object_near(&l->source) && !object_near(&object->eye)) {
        for (int i = 0; i < 3; i++)
            half[i] = l->half[i];
        return;
    }
    q14_t eye[3];
    towards_point(&object->eye, place, eye);
    half_way(towards, eye, half);
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
FX_COLD static void light_locally(const struct object_state *object, const struct scene_vertex *vertex, unsigned lights,
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
        record[VERTEX_DEPTH] = fx_wrap_s16(point.depth);
        all &= placed;
        light_vertex(object->light, object->light + lights, vertex->normal, record + VERTEX_LIGHTS);
    }
    if (stride > VERTEX_LIGHTS + 2 * lights)
        for (; record != records; record -= stride)
            record[-1] = 0;
    if (object_local(object))
        light_locally(object, vertices, lights, records, stride);
    return all;
}

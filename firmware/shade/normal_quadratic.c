/* SPDX-License-Identifier: MIT */
#include "shade/normal_quadratic.h"

#include "shade/piece.h"

#define LEAN     (1 << 16) /* 2^-12, all in Q28 */
#define PARALLEL (1 << 18) /* 2^-10 */
#define ACROSS   (1 << 26) /* 1/4 */

static inline int32_t size_of(int32_t x)
{
    return x < 0 ? -x : x;
}

static inline int32_t times_q30(int32_t x, q30_t y)
{
    return fx_mulhi_s32(x, y) * 4;
}

/* n . v in Q28, |v| <= 1. */
static int32_t dot(const q14_t n[3], const q30_t v[3])
{
    int32_t sum = 0;
    for (int k = 0; k < 3; k++)
        sum += fx_mulhi_s32(n[k] * 65536, v[k]);
    return sum;
}

/* a x b of vectors of at most 1 in Q30, in Q28. */
static void cross(const q30_t a[3], const q30_t b[3], int32_t out[3])
{
    out[0] = fx_mulhi_s32(a[1], b[2]) - fx_mulhi_s32(a[2], b[1]);
    out[1] = fx_mulhi_s32(a[2], b[0]) - fx_mulhi_s32(a[0], b[2]);
    out[2] = fx_mulhi_s32(a[0], b[1]) - fx_mulhi_s32(a[1], b[0]);
}

static void edge_between(const struct scene_vertex *a, const struct scene_vertex *b, int32_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = b->position[k] - a->position[k];
}

/* 3 (n0 + n1, g) g for a unit vector g: |(n0 + n1, g)| <= 2 (1 + 2^-13), so 3 of it stay below 2^30.6. */
static void bend_edge(struct normal_quadratic *out, int e, const struct scene_vertex *a, const struct scene_vertex *b,
                      const q30_t g[3])
{
    const int32_t along = 3 * (dot(a->normal, g) + dot(b->normal, g));
    for (int axis = 0; axis < 3; axis++)
        out->bulge[axis][e] = times_q30(along, g[axis]);
}

static void gather(const struct scene_vertex *const corner[3], struct normal_quadratic *out)
{
    for (int k = 0; k < 3; k++)
        for (int axis = 0; axis < 3; axis++)
            out->value[axis][k] = corner[k]->normal[axis];
}

void normal_quadratic_overveld(const struct scene_vertex *const corner[3], struct normal_quadratic *out)
{
    gather(corner, out);
    for (int e = 0; e < 3; e++) {
        const struct scene_vertex *a = corner[e], *b = corner[e == 2 ? 0 : e + 1];
        int32_t edge[3];
        edge_between(a, b, edge);
        vector_normalise(edge, edge);
        bend_edge(out, e, a, b, edge);
    }
}

/* v less its part along a unit vector, Q28: |v| <= 1 in Q30. */
static void part_across(const q30_t v[3], const q30_t unit[3], int32_t out[3])
{
    int32_t along = 0;
    for (int k = 0; k < 3; k++)
        along += fx_mulhi_s32(v[k], unit[k]);
    for (int k = 0; k < 3; k++)
        out[k] = (v[k] >> 2) - times_q30(along, unit[k]);
}

static int is_shorter(const int32_t v_q28[3], int32_t than_q28)
{
    int64_t squared = 0; /* components below 2^30 */
    for (int k = 0; k < 3; k++)
        squared += fx_s64(v_q28[k]) * v_q28[k];
    return squared < fx_s64(than_q28) * than_q28;
}

static void widen(const q14_t n[3], q30_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = n[k] * 65536;
}

static void face_normal(const struct scene_vertex *const corner[3], q30_t out[3])
{
    int32_t a[3], b[3];
    edge_between(corner[0], corner[1], a);
    edge_between(corner[0], corner[2], b);
    vector_normalise(a, a);
    vector_normalise(b, b);
    cross(a, b, out);
    vector_normalise(out, out);
}

/* The unit vector along G of edge e; 0 if the edge is linear. */
static int direction(const struct scene_vertex *const corner[3], int e, q30_t out[3])
{
    const struct scene_vertex *a = corner[e], *b = corner[e == 2 ? 0 : e + 1];
    int32_t edge[3], n0[3], n1[3], face[3], lean0 = 0, lean1 = 0;
    edge_between(a, b, edge);
    for (int k = 0; k < 3; k++) { /* |n| <= 2^14 (1 + 2^-13), |edge| <= 2^16 sqrt(3): every sum is below 2^30.9 */
        lean0 += a->normal[k] * edge[k];
        lean1 += b->normal[k] * edge[k];
    }
    if ((lean0 ^ lean1) < 0)
        return 0; /* most edges of most meshes: saves the root */
    vector_normalise(edge, edge);
    if (size_of(dot(a->normal, edge)) <= LEAN || size_of(dot(b->normal, edge)) <= LEAN)
        return 0;
    widen(a->normal, n0);
    widen(b->normal, n1);
    cross(n0, n1, out);
    if (!is_shorter(out, PARALLEL)) {
        vector_normalise(out, out);
        part_across(edge, out, out);
        if (!is_shorter(out, ACROSS)) {
            vector_normalise(out, out);
            return 1;
        }
    }
    /* The edge lies in the triangle: projected on the plane of a normal and the triangle's, it has the direction of the
     * normal's part in the triangle. */
    face_normal(corner, face);
    part_across(size_of(lean0) >= size_of(lean1) ? n0 : n1, face, out);
    if (is_shorter(out, PARALLEL))
        return 0;
    vector_normalise(out, out);
    return 1;
}

int normal_quadratic_lee_jen(const struct scene_vertex *const corner[3], unsigned edges, struct normal_quadratic *out)
{
    int bent = 0;
    gather(corner, out);
    for (int e = 0; e < 3; e++) {
        q30_t g[3];
        if (edges >> e & 1u && direction(corner, e, g)) {
            bend_edge(out, e, corner[e], corner[e == 2 ? 0 : e + 1], g);
            bent = 1;
        } else {
            out->bulge[0][e] = out->bulge[1][e] = out->bulge[2][e] = 0;
        }
    }
    return bent;
}

void normal_quadratic_corners(const struct shade_input *in, const struct scene_vertex *corner[3])
{
    for (int k = 0; k < 3; k++)
        corner[k] = &in->vertices[in->triangle->corner[SHADE_TURN(k)]];
}

void normal_quadratic_restrict(const struct shade_input *in, struct normal_quadratic *n)
{
    for (int axis = 0; in->weight && axis < 3; axis++)
        piece_quadratic(in->weight, n->value[axis], n->bulge[axis]);
}

void normal_quadratic_channels(struct shade_setup *setup, const struct normal_quadratic *n)
{
    plane_setup_quadratic(&setup->plane);
    setup->quadratic = 1;
    for (int axis = 0; axis < 3; axis++)
        plane_quadratic_large(&setup->plane, n->value[axis], n->bulge[axis], &setup->channel[axis]);
}

/* SPDX-License-Identifier: MIT */
#include "import/normals.h"

#include "scene/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LEAF     16   /* corners of a cluster that are looked at one by one */
#define SAME     1e-6 /* radians: normals this close differ by rounding, which is no crease */
#define ROUNDING 1e-7 /* radians: more than acos() can be wrong by */

/* A corner of a triangle that has an area. */
struct corner {
    double position[3], face[3], angle;
    size_t index; /* 3 * triangle + corner */
    uint32_t key; /* close faces mostly have close keys */
};

/* Corners at one position, consecutive in their order. Their faces' normals lie in a cap around the axis: a normal
 * whose product with the axis is at least `inside` is within the crease of them all, and below `outside` of none. */
struct cluster {
    double axis[3], inside, outside;
    double sum[3]; /* of angle * face */
};

/* All corners at one position: a binary tree of clusters, the children of i at 2 i + 1 and 2 i + 2, each with half of
 * the corners, down to LEAF corners or fewer, which have no cluster. */
struct fan {
    const struct corner *corners;
    struct cluster *clusters;
    double crease, least; /* its cosine */
};

bool normals_face(const struct model_mesh *mesh, const struct model_triangle *triangle, double out[3])
{
    const double *a = mesh->vertices[triangle->corner[0]].position;
    double ab[3], ac[3];
    vec_sub(mesh->vertices[triangle->corner[1]].position, a, ab);
    vec_sub(mesh->vertices[triangle->corner[2]].position, a, ac);
    memcpy(out, (double[]){0, 0, 0}, 3 * sizeof *out);
    if (!vec_normalise(ab) || !vec_normalise(ac)) /* first, so that no product underflows */
        return false;
    vec_cross(ab, ac, out);
    return vec_normalise(out);
}

/* A vertex for every corner: 3 i + k for corner k of triangle i. */
static void split(struct model_mesh *mesh)
{
    struct model_vertex *vertices = model_alloc(3 * mesh->triangle_count * sizeof *vertices);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint32_t *corner = &mesh->triangles[i / 3].corner[i % 3];
        vertices[i] = mesh->vertices[*corner];
        *corner = (uint32_t)i;
    }
    free(mesh->vertices);
    mesh->vertices = vertices;
    mesh->vertex_count = mesh->vertex_room = 3 * mesh->triangle_count;
}

void normals_flat(struct model_mesh *mesh)
{
    split(mesh);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        double normal[3];
        normals_face(mesh, &mesh->triangles[i], normal);
        for (int k = 0; k < 3; k++)
            memcpy(mesh->vertices[3 * i + (size_t)k].normal, normal, sizeof normal);
    }
    mesh->normals = MODEL_NORMALS_FLAT;
}

static int compare_positions(const struct corner *p, const struct corner *q)
{
    for (int k = 0; k < 3; k++)
        if (p->position[k] != q->position[k])
            return p->position[k] < q->position[k] ? -1 : 1;
    return 0;
}

/* The index makes the order, and so the rounding of the sums, the same everywhere. */
static int by_position(const void *a, const void *b)
{
    const struct corner *p = a, *q = b;
    int order = compare_positions(p, q);
    if (order == 0)
        order = (p->key > q->key) - (p->key < q->key);
    return order ? order : (p->index > q->index) - (p->index < q->index);
}

/* Morton (1966): the bits of the three components take turns, highest first. */
static uint32_t face_key(const double face[3])
{
    uint32_t key = 0;
    for (int bit = 9; bit >= 0; bit--)
        for (int k = 0; k < 3; k++)
            key = key << 1 | ((uint32_t)((face[k] + 1) * 511.5) >> bit & 1);
    return key;
}

static struct corner *sorted_corners(const struct model_mesh *mesh, size_t *count)
{
    struct corner *corners = model_alloc(3 * mesh->triangle_count * sizeof *corners);
    *count = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const struct model_triangle *t = &mesh->triangles[i / 3];
        const double *here = mesh->vertices[i].position;
        double to_next[3], to_last[3];
        vec_sub(mesh->vertices[t->corner[(i + 1) % 3]].position, here, to_next);
        vec_sub(mesh->vertices[t->corner[(i + 2) % 3]].position, here, to_last);
        struct corner *c = &corners[*count];
        if (!normals_face(mesh, t, c->face) || !vec_normalise(to_next) || !vec_normalise(to_last))
            continue;
        memcpy(c->position, here, sizeof c->position);
        c->angle = acos(fmax(-1, fmin(1, vec_dot(to_next, to_last))));
        c->index = i;
        c->key = face_key(c->face);
        ++*count;
    }
    qsort(corners, *count, sizeof *corners, by_position);
    return corners;
}

static void build(struct fan *fan, size_t node, size_t first, size_t end)
{
    if (end - first <= LEAF)
        return;
    struct cluster *cluster = &fan->clusters[node];
    for (size_t i = first; i < end; i++)
        for (int k = 0; k < 3; k++) {
            cluster->axis[k] += fan->corners[i].face[k];
            cluster->sum[k] += fan->corners[i].angle * fan->corners[i].face[k];
        }
    if (!vec_normalise(cluster->axis)) /* they cancel out: any axis will do */
        cluster->axis[0] = 1;
    double least = 1;
    for (size_t i = first; i < end; i++)
        least = fmin(least, vec_dot(cluster->axis, fan->corners[i].face));
    const double radius = acos(fmax(-1, least)) + ROUNDING;
    cluster->inside = radius < fan->crease ? cos(fan->crease - radius) : 2;
    cluster->outside = fan->crease + radius < M_PI ? cos(fan->crease + radius) : -2;
    if (radius < 2 * ROUNDING) /* all the same: or those at the very crease would be looked at one by one */
        cluster->inside = cluster->outside = fan->least;
    const size_t middle = first + (end - first) / 2;
    build(fan, 2 * node + 1, first, middle);
    build(fan, 2 * node + 2, middle, end);
}

/* Adds the corners of a node whose faces are within the crease of this one, by whole clusters where it can. */
static void add_near(const struct fan *fan, size_t node, size_t first, size_t end, const double face[3], double sum[3])
{
    if (end - first <= LEAF) {
        for (const struct corner *c = fan->corners + first; c < fan->corners + end; c++)
            for (int k = 0; vec_dot(face, c->face) >= fan->least && k < 3; k++)
                sum[k] += c->angle * c->face[k];
        return;
    }
    const struct cluster *cluster = &fan->clusters[node];
    const double product = vec_dot(face, cluster->axis);
    if (product >= cluster->inside) {
        for (int k = 0; k < 3; k++)
            sum[k] += cluster->sum[k];
    } else if (product >= cluster->outside) {
        const size_t middle = first + (end - first) / 2;
        add_near(fan, 2 * node + 1, first, middle, face, sum);
        add_near(fan, 2 * node + 2, middle, end, face, sum);
    }
}

void normals_smooth(struct model_mesh *mesh, double crease)
{
    split(mesh);
    size_t count;
    struct corner *corners = sorted_corners(mesh, &count);
    crease = fmax(crease, SAME);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        memset(mesh->vertices[i].normal, 0, sizeof mesh->vertices[i].normal);
    for (size_t first = 0, end; first < count; first = end) {
        for (end = first + 1; end < count && compare_positions(&corners[first], &corners[end]) == 0;)
            end++;
        struct fan fan = {.corners = corners, .crease = crease, .least = cos(crease)};
        if (end - first > LEAF) /* n corners have less than 2 n / LEAF nodes in the lowest row */
            fan.clusters = model_alloc((4 * (end - first) / LEAF + 1) * sizeof *fan.clusters);
        build(&fan, 0, first, end);
        for (size_t i = first; i < end; i++)
            add_near(&fan, 0, first, end, corners[i].face, mesh->vertices[corners[i].index].normal);
        free(fan.clusters);
    }
    free(corners);
    mesh->normals = MODEL_NORMALS_SMOOTHED;
}

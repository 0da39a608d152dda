/* SPDX-License-Identifier: MIT */
#include "import/normals.h"

#include "scene/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct corner {
    double position[3], face[3], angle;
    size_t index; /* 3 * triangle + corner */
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
    return order ? order : (p->index > q->index) - (p->index < q->index);
}

static struct corner *sorted_corners(const struct model_mesh *mesh)
{
    struct corner *corners = model_alloc(3 * mesh->triangle_count * sizeof *corners);
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const struct model_triangle *t = &mesh->triangles[i / 3];
        const double *here = mesh->vertices[i].position;
        double to_next[3], to_last[3];
        vec_sub(mesh->vertices[t->corner[(i + 1) % 3]].position, here, to_next);
        vec_sub(mesh->vertices[t->corner[(i + 2) % 3]].position, here, to_last);
        struct corner *c = &corners[i];
        c->index = i;
        memcpy(c->position, here, sizeof c->position);
        if (normals_face(mesh, t, c->face) && vec_normalise(to_next) && vec_normalise(to_last))
            c->angle = acos(fmax(-1, fmin(1, vec_dot(to_next, to_last))));
    }
    qsort(corners, 3 * mesh->triangle_count, sizeof *corners, by_position);
    return corners;
}

void normals_smooth(struct model_mesh *mesh, double crease)
{
    split(mesh);
    const size_t count = mesh->vertex_count;
    struct corner *corners = sorted_corners(mesh);
    const double least = cos(crease);
    for (size_t first = 0, end; first < count; first = end) {
        for (end = first + 1; end < count && compare_positions(&corners[first], &corners[end]) == 0;)
            end++;
        for (size_t i = first; i < end; i++) {
            double *normal = mesh->vertices[corners[i].index].normal;
            memcpy(normal, (double[]){0, 0, 0}, sizeof corners->face);
            for (size_t j = first; j < end; j++)
                if (i == j || vec_dot(corners[i].face, corners[j].face) >= least)
                    for (int k = 0; k < 3; k++)
                        normal[k] += corners[j].angle * corners[j].face[k];
        }
    }
    free(corners);
    mesh->normals = MODEL_NORMALS_SMOOTHED;
}

/* SPDX-License-Identifier: MIT */
#include "import/tangents.h"

#include "scene/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NONE UINT32_MAX

/* What makes vertices share a tangent; texture coordinates in 1/4096 turn, as they are packed. */
struct key {
    double position[3], normal[3];
    double uv[2], sign;
    uint32_t vertex;
};

/* dP/du on the triangle, unit, and which way its texture coordinates turn; 0 where they span no area. */
static double direction(const struct model_mesh *mesh, const struct model_triangle *t, double out[3])
{
    const struct model_vertex *v[3];
    double ab[3], ac[3];
    for (int k = 0; k < 3; k++)
        v[k] = &mesh->vertices[t->corner[k]];
    vec_sub(v[1]->position, v[0]->position, ab);
    vec_sub(v[2]->position, v[0]->position, ac);
    const double u1 = v[1]->uv[0] - v[0]->uv[0], v1 = v[1]->uv[1] - v[0]->uv[1];
    const double u2 = v[2]->uv[0] - v[0]->uv[0], v2 = v[2]->uv[1] - v[0]->uv[1], turn = u1 * v2 - u2 * v1;
    for (int k = 0; k < 3; k++) /* dP/du times |turn| */
        out[k] = turn < 0 ? ac[k] * v1 - ab[k] * v2 : ab[k] * v2 - ac[k] * v1;
    if (!(fabs(turn) > 0) || !vec_normalise(out))
        return 0;
    return turn < 0 ? -1 : 1;
}

/* Gives every vertex the sign of its triangles, and those of the other sign a copy. */
static void split_signs(struct model_mesh *mesh)
{
    const size_t before = mesh->vertex_count;
    uint32_t *other = model_alloc(before * sizeof *other);
    memset(other, 0xff, before * sizeof *other);
    for (size_t i = 0; i < before; i++)
        mesh->vertices[i].sign = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        struct model_triangle *t = &mesh->triangles[i / 3];
        uint32_t *corner = &t->corner[i % 3];
        double along[3], sign = direction(mesh, t, along);
        if (mesh->vertices[*corner].sign == 0)
            mesh->vertices[*corner].sign = sign;
        if (sign == 0 || mesh->vertices[*corner].sign == sign)
            continue;
        if (other[*corner] == NONE) {
            const struct model_vertex copy = mesh->vertices[*corner];
            other[*corner] = model_add_vertex(mesh, copy.position, copy.normal, copy.uv[0], copy.uv[1]);
            mesh->vertices[other[*corner]].sign = sign;
            memcpy(mesh->vertices[other[*corner]].tangent, copy.tangent, sizeof copy.tangent);
        }
        *corner = other[*corner];
    }
    free(other);
}

static int compare_keys(const void *a, const void *b)
{
    return memcmp(a, b, offsetof(struct key, vertex));
}

/* Which vertex stands for all that share its tangent, of each. */
static uint32_t *find_groups(const struct model_mesh *mesh)
{
    uint32_t *group = model_alloc(mesh->vertex_count * sizeof *group), first = 0;
    struct key *keys = model_alloc(mesh->vertex_count * sizeof *keys);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct model_vertex *v = &mesh->vertices[i];
        for (int k = 0; k < 3; k++) { /* + 0: no negative zeros */
            keys[i].position[k] = v->position[k] + 0.;
            keys[i].normal[k] = v->normal[k] + 0.;
        }
        for (int k = 0; k < 2; k++)
            keys[i].uv[k] = fmod(floor((v->uv[k] - floor(v->uv[k])) * 4096 + .5), 4096) + 0.;
        keys[i].sign = v->sign;
        keys[i].vertex = i;
    }
    qsort(keys, mesh->vertex_count, sizeof *keys, compare_keys);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        if (i == 0 || compare_keys(&keys[i - 1], &keys[i]) != 0)
            first = keys[i].vertex;
        group[keys[i].vertex] = first;
    }
    free(keys);
    return group;
}

/* The angle of a triangle at its corner k; 0 if it has none. */
static double angle_at(const struct model_mesh *mesh, const struct model_triangle *t, int k)
{
    double next[3], last[3];
    const double *here = mesh->vertices[t->corner[k]].position;
    vec_sub(mesh->vertices[t->corner[(k + 1) % 3]].position, here, next);
    vec_sub(mesh->vertices[t->corner[(k + 2) % 3]].position, here, last);
    return vec_normalise(next) && vec_normalise(last) ? acos(fmax(-1, fmin(1, vec_dot(next, last)))) : 0;
}

/* Adds, for each group, the triangles' directions. */
static void add_directions(const struct model_mesh *mesh, const uint32_t *group, double (*sum)[3])
{
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const struct model_triangle *t = &mesh->triangles[i];
        double along[3];
        if (direction(mesh, t, along) == 0)
            continue;
        for (int k = 0; k < 3; k++) {
            const double weight = angle_at(mesh, t, k);
            for (int axis = 0; axis < 3; axis++)
                sum[group[t->corner[k]]][axis] += weight * along[axis];
        }
    }
}

/* False if the tangent lies along the normal. */
static bool upright(const double normal[3], double tangent[3])
{
    const double lean = vec_dot(normal, tangent);
    for (int k = 0; k < 3; k++)
        tangent[k] -= lean * normal[k];
    return vec_length(tangent) > 1e-6 && vec_normalise(tangent);
}

void tangents_upright(const double normal[3], double tangent[3])
{
    bool done = vec_normalise(tangent) && upright(normal, tangent);
    for (int axis = 0; !done && axis < 3; axis++) { /* one of the three leans less than 55 degrees from the plane */
        memcpy(tangent, (double[]){axis == 0, axis == 1, axis == 2}, 3 * sizeof *tangent);
        done = fabs(normal[axis]) < .8 && upright(normal, tangent);
    }
}

/* What a vertex without a usable tangent takes. */
static void finish(struct model_vertex *v, const double sum[3])
{
    double normal[3], tangent[3];
    memcpy(normal, v->normal, sizeof normal);
    if (!vec_normalise(normal)) /* packing takes the face's, and turns the tangent again */
        memcpy(normal, (double[]){0, 0, 1}, sizeof normal);
    memcpy(tangent, v->tangent, sizeof tangent);
    if (!vec_normalise(tangent) || !upright(normal, tangent))
        memcpy(tangent, sum, sizeof tangent);
    tangents_upright(normal, tangent);
    memcpy(v->tangent, tangent, sizeof tangent);
}

void tangents_make(struct model_mesh *mesh)
{
    split_signs(mesh);
    uint32_t *group = find_groups(mesh);
    double(*sum)[3] = model_alloc(mesh->vertex_count * sizeof *sum);
    add_directions(mesh, group, sum);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        struct model_vertex *v = &mesh->vertices[i];
        v->sign = v->sign < 0 ? -1 : 1;
        finish(v, sum[group[i]]);
    }
    free(group);
    free(sum);
}

/* SPDX-License-Identifier: MIT */
#include "pack/inflection.h"

#include "scene/model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define UPRIGHT 0x1p-12 /* a normal leans by more, as in the firmware's normal_quadratic.c */

/* A triangle's edge with its vertices by place and normal, the lower first. */
struct inflection_edge {
    uint32_t a, b, triangle, e;
};

struct inflection_vertex {
    struct scene_vertex vertex;
    uint32_t index;
};

static int compare_vertices(const void *p, const void *q)
{
    const struct inflection_vertex *a = p, *b = q;
    const int order = memcmp(&a->vertex, &b->vertex, sizeof a->vertex);
    return order ? order : (a->index > b->index) - (a->index < b->index);
}

/* Gives vertices that differ only in what lies beside them (texture coordinates, tangents) one number. */
static uint32_t *number_vertices(const struct scene_vertex *vertices, uint32_t count)
{
    struct inflection_vertex *sorted = model_alloc(count * sizeof *sorted), *last = sorted;
    uint32_t *number = model_alloc(count * sizeof *number);
    for (uint32_t i = 0; i < count; i++)
        sorted[i] = (struct inflection_vertex){vertices[i], i};
    qsort(sorted, count, sizeof *sorted, compare_vertices);
    for (uint32_t i = 0; i < count; i++) {
        if (memcmp(&sorted[i].vertex, &last->vertex, sizeof last->vertex) != 0)
            last = &sorted[i];
        number[sorted[i].index] = last->index;
    }
    free(sorted);
    return number;
}

static int compare_edges(const void *p, const void *q)
{
    const struct inflection_edge *a = p, *b = q;
    if (a->a != b->a)
        return a->a < b->a ? -1 : 1;
    return (a->b > b->b) - (a->b < b->b);
}

/* Both normals lean the same way along the edge. */
static int leans(const struct scene_vertex *a, const struct scene_vertex *b)
{
    double length = 0, lean[2] = {0, 0};
    for (int k = 0; k < 3; k++) {
        const double d = b->position[k] - a->position[k];
        length += d * d;
        lean[0] += a->normal[k] * d;
        lean[1] += b->normal[k] * d;
    }
    const double upright = UPRIGHT * 16384 * sqrt(length);
    return fmin(lean[0], lean[1]) > upright || fmax(lean[0], lean[1]) < -upright;
}

/* The edges of a triangle that pass the test, a bit each. */
static unsigned passing(const struct scene_vertex *vertices, const struct scene_triangle *triangle)
{
    unsigned passed = 0;
    for (unsigned e = 0; e < 3; e++)
        if (leans(&vertices[triangle->corner[e]], &vertices[triangle->corner[(e + 1) % 3]]))
            passed |= 1u << e;
    return passed;
}

/* One edge's entries, one for each triangle at it. */
static void mark(const struct inflection_edge *edge, size_t count, const uint8_t *passed,
                 struct scene_triangle *triangles)
{
    int agrees = 1;
    for (size_t i = 0; i < count; i++)
        agrees = agrees && passed[edge[i].triangle] >> edge[i].e & 1 && passed[edge[i].triangle] & ~(1u << edge[i].e);
    for (size_t i = 0; agrees && i < count; i++)
        triangles[edge[i].triangle].flags |= (uint16_t)(TRIANGLE_QUADRATIC << edge[i].e);
}

void inflection_mark(const struct scene_vertex *vertices, uint32_t vertex_count, struct scene_triangle *triangles,
                     uint32_t triangle_count)
{
    const size_t count = 3 * (size_t)triangle_count;
    uint32_t *number = number_vertices(vertices, vertex_count);
    uint8_t *passed = model_alloc(triangle_count);
    struct inflection_edge *edges = model_alloc(count * sizeof *edges);
    for (uint32_t t = 0; t < triangle_count; t++) {
        passed[t] = (uint8_t)passing(vertices, &triangles[t]);
        triangles[t].flags = 0;
        for (uint32_t e = 0; e < 3; e++) {
            const uint32_t a = number[triangles[t].corner[e]], b = number[triangles[t].corner[(e + 1) % 3]];
            edges[3 * t + e] = (struct inflection_edge){a < b ? a : b, a < b ? b : a, t, e};
        }
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    for (size_t first = 0, end; first < count; first = end) {
        for (end = first + 1; end < count && !compare_edges(&edges[first], &edges[end]);)
            end++;
        mark(&edges[first], end - first, passed, triangles);
    }
    free(edges);
    free(passed);
    free(number);
}

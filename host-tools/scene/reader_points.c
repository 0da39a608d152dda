/* SPDX-License-Identifier: MIT */
/* Meshes whose points stand in the scene file: triangles and patches. */
#include "import/import.h"
#include "import/normals.h"
#include "import/patch.h"
#include "scene/reader.h"
#include "scene/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST_POINTS   65535
#define MOST_PATCHES  1024
#define MOST_SEGMENTS 32

/* The member `key`, a list of triples; null, having said why, unless there are `least` or more. */
static double (*read_triples(const struct node *owner, const char *key, size_t least, size_t most, size_t *count))[3]
{
    struct node list = node_member(owner, key);
    if (!list.value)
        node_fail(&list, "missing");
    *count = node_length(&list, least, most);
    double(*out)[3] = model_alloc(*count * sizeof *out);
    for (size_t i = 0; i < *count; i++) {
        struct node item = node_item(&list, i);
        node_vector(&item, out[i], 3, -READER_MOST_LENGTH, READER_MOST_LENGTH);
    }
    if (!owner->file->failed)
        return out;
    free(out);
    return NULL;
}

/* A list of `count` whole numbers below `end`. */
static void read_indices(const struct node *list, uint32_t *out, size_t count, size_t end)
{
    if (node_length(list, count, count) == count)
        for (size_t i = 0; i < count; i++) {
            struct node item = node_item(list, i);
            out[i] = node_integer(&item, 0, (unsigned)end - 1, NAN);
        }
}

void reader_patches(const struct node *node, struct model_mesh *mesh)
{
    size_t point_count;
    unsigned segments = node_member_integer(node, "segments", 1, MOST_SEGMENTS, 4);
    double(*points)[3] = read_triples(node, "points", 1, MOST_POINTS, &point_count);
    struct node list = node_member(node, "patches");
    if (!list.value)
        node_fail(&list, "missing");
    size_t count = node_length(&list, 1, MOST_PATCHES);
    for (size_t i = 0; points && i < count; i++) {
        struct node item = node_item(&list, i);
        uint32_t index[PATCH_POINTS] = {0};
        double net[PATCH_POINTS][3];
        read_indices(&item, index, PATCH_POINTS, point_count);
        for (size_t k = 0; k < PATCH_POINTS; k++)
            memcpy(net[k], points[index[k]], sizeof net[k]);
        if (!node->file->failed)
            patch_add(mesh, (const double(*)[3])net, segments);
    }
    free(points);
}

/* Normals, one a vertex, or without them a crease to make them by. */
static void read_normals(const struct node *node, struct model_mesh *mesh)
{
    struct node list = node_member(node, "normals"), crease = node_member(node, "crease");
    size_t count;
    if (!list.value) {
        double angle = node_number(&crease, 0, 180, IMPORT_CREASE) * M_PI / 180;
        if (!node->file->failed)
            normals_smooth(mesh, angle);
        return;
    }
    if (crease.value)
        node_fail(&crease, "not together with \"normals\"");
    double(*normals)[3] = read_triples(node, "normals", mesh->vertex_count, mesh->vertex_count, &count);
    for (size_t i = 0; normals && i < count; i++) {
        struct node item = node_item(&list, i);
        if (!vec_normalise(normals[i]))
            node_fail(&item, "must not be zero");
        memcpy(mesh->vertices[i].normal, normals[i], sizeof normals[i]);
    }
    free(normals);
}

void reader_triangles(const struct node *node, struct model_mesh *mesh)
{
    size_t point_count;
    double(*points)[3] = read_triples(node, "vertices", 3, MOST_POINTS, &point_count);
    struct node list = node_member(node, "triangles");
    if (!list.value)
        node_fail(&list, "missing");
    size_t count = node_length(&list, 1, MOST_POINTS);
    mesh->has_uvs = false;
    for (size_t i = 0; points && i < point_count; i++)
        model_add_vertex(mesh, points[i], (const double[3]){0, 0, 0}, 0, 0);
    for (size_t i = 0; points && i < count; i++) {
        struct node item = node_item(&list, i);
        uint32_t corner[3] = {0};
        read_indices(&item, corner, 3, point_count);
        model_add_triangle(mesh, corner[0], corner[1], corner[2], 0);
    }
    free(points);
    if (!node->file->failed)
        read_normals(node, mesh);
}

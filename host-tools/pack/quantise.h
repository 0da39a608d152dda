/* SPDX-License-Identifier: MIT */
/*
 * A mesh in double precision becomes one or more of the blob's: positions on a grid around the centre of the bounding
 * box, normals in Q14, vertices that are then equal welded, triangles without area on the grid dropped. All parts of a
 * mesh share the grid, so that no crack opens between them.
 */
#ifndef QUANTISE_H
#define QUANTISE_H

#include "pack/report.h"
#include "scene/scene.h"

struct quantise_part {
    struct scene_mesh head; /* its offsets are for the writer of the blob to fill */
    struct scene_vertex *vertices;
    struct scene_triangle *triangles; /* materials as in the model */
    int16_t (*uvs)[2];                /* null: none */
    struct scene_tangent *tangents;   /* null: none */
};

struct quantise_mesh {
    struct quantise_part *parts;
    unsigned part_count;
};

/* `material` >= 0 replaces the mesh's own. Fills the report but for its name. Returns null, or why the mesh cannot be
 * packed; then there is nothing to free. */
const char *quantise_mesh(const struct model *model, const struct model_mesh *mesh, int material,
                          struct quantise_mesh *out, struct pack_mesh_report *report);

void quantise_free(struct quantise_mesh *mesh);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * On which edges of a mesh a normal that is interpolated quadratically may be. The test for an inflection of Lee and
 * Jen (2001, section 3.1), that both normals lean the same way along an edge, is passed too by the diagonals of quads
 * on saddles and twisted parts, which have none; such a diagonal darkens or brightens its quad by itself. An inflection
 * is a thing of the surface: where there is one, it crosses both triangles at the edge, and leaves each by another
 * edge.
 */
#ifndef INFLECTION_H
#define INFLECTION_H

#include "scene/scene.h"

/* Sets the flags of all triangles: an edge's if it passes the test and in each triangle at it another edge does. Edges
 * are the same where positions and normals are. */
void inflection_mark(const struct scene_vertex *vertices, uint32_t vertex_count, struct scene_triangle *triangles,
                     uint32_t triangle_count);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Parametric shapes. Each adds its vertices and triangles, counter-clockwise from outside, with analytic normals,
 * tangents and texture coordinates 0..1 to a mesh. Rows of quads split along (i, j)-(i+1, j+1); the first and the last
 * column coincide exactly. Vertices that coincide are left for welding, and triangles without area (at a pole) for
 * dropping.
 */
#ifndef SHAPE_H
#define SHAPE_H

#include "scene/model.h"

/* The axis that a shape lies around; formulas are for z. Y exchanges y and z, X turns z to x. */
enum shape_axis { SHAPE_X, SHAPE_Y, SHAPE_Z };

/* Vertex (i, j), u = 2 pi i / rings, v = 2 pi j / sides: ((R + r cos v) cos u, (R + r cos v) sin u, r sin v). */
void shape_torus(struct model_mesh *mesh, enum shape_axis axis, double radius, double tube, unsigned rings,
                 unsigned sides);

/* Vertex (i, j), u = 2 pi i / slices, v = pi j / stacks from the pole at +z: R (sin v cos u, sin v sin u, cos v). */
void shape_sphere(struct model_mesh *mesh, enum shape_axis axis, double radius, unsigned slices, unsigned stacks);

/* A rectangle around the origin, facing along +axis, of segments x segments quads. */
void shape_plane(struct model_mesh *mesh, enum shape_axis axis, const double size[2], unsigned segments);

/* The profile's points (distance from the axis >= 0, height along it) turned about the axis. Outside is to the right
 * of the way along the profile, as for one that rises. Neighbouring segments that meet at less than `crease` radians
 * share normals; at the axis a segment's neighbour is its own mirror image. */
void shape_revolve(struct model_mesh *mesh, enum shape_axis axis, const double (*profile)[2], size_t points,
                   unsigned slices, double crease);

#endif

/* SPDX-License-Identifier: MIT */
/* Normals for meshes that come without, or that want others. Both give every corner a vertex of its own. */
#ifndef NORMALS_H
#define NORMALS_H

#include "scene/model.h"

/* The unit normal of a triangle; false if it has no area. */
bool normals_face(const struct model_mesh *mesh, const struct model_triangle *triangle, double out[3]);

/* Every corner takes its face's normal. */
void normals_flat(struct model_mesh *mesh);

/* Every corner takes the mean of the normals of the faces that meet at its position at less than `crease` radians from
 * its own, each weighted by its angle there. */
void normals_smooth(struct model_mesh *mesh, double crease);

#endif

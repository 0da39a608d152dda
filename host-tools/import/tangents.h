/* SPDX-License-Identifier: MIT */
/*
 * The moving frame of bump mapping at every vertex: T along growing u, made unit and at right angles to the normal
 * (Gram-Schmidt), and B = sign N x T along growing v. The sign is that of the texture coordinates' turn on the
 * triangles, -1 where they are mirrored.
 */
#ifndef TANGENTS_H
#define TANGENTS_H

#include "scene/model.h"

/* Fills tangent and sign of every vertex that triangles use. A tangent that is there (an analytic one, or a file's) is
 * kept but for its length and lean; others are the mean of those of the triangles at the same position, normal and
 * texture coordinate, whole turns apart included, weighted by their angles. A vertex of triangles of both signs becomes
 * two. Where texture coordinates leave T open it is any. */
void tangents_make(struct model_mesh *mesh);

/* Turns a tangent to a right angle with a unit normal, and makes it unit: any other if it lies along the normal. */
void tangents_upright(const double normal[3], double tangent[3]);

#endif

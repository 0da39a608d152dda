/* SPDX-License-Identifier: MIT */
/*
 * Bicubic Bezier patches. The net's 16 points are four rows of four; u runs along a row, v from row to row, and outside
 * is where du x dv points. Farin, "Curves and Surfaces for CAGD": position and derivatives by Bernstein polynomials.
 */
#ifndef PATCH_H
#define PATCH_H

#include "scene/model.h"

#define PATCH_POINTS 16

/* Adds the patch as segments x segments quads of two triangles, split along (i, j)-(i+1, j+1), with the surface's own
 * normals and u, v as texture coordinates.
 *
 * Two patches that share the points of a side get equal bits there, whichever way each runs, so packing welds them
 * wherever their normals agree. Where a side is one point, a pole, the normal is the limit of those beside it, and the
 * quads along it are a fan and a strip on a ring of half as many vertices halfway to the next row: as many triangles
 * as anywhere else, none without area. If `segments` is odd, or at a second pole, they are quads with two equal
 * corners. Where the surface has no tangent plane even in the limit the normal is zero. */
void patch_add(struct model_mesh *mesh, const double net[PATCH_POINTS][3], unsigned segments);

#endif

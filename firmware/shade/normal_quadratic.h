/* SPDX-License-Identifier: MIT */
/*
 * The normal as a quadratic over the triangle: along an edge D from n0 to n1
 *     n(s) = n0 + (n1 - n0 - b) s + b s^2,   b = 3 (n0 + n1, G) / |G|^2 G,
 * so that over the edge the normal's part along G is 0 in the mean, as a curve through both ends has it ("Improved
 * quadratic normal vector interpolation for realistic shading", Lee and Jen 2001, eq. 1, 5 and 8). b is the edge's
 * bulge in N = sum ni li - sum bij li lj, the quadratic through the corners and the middles of the edges (eq. 9).
 */
#ifndef GLINT_NORMAL_QUADRATIC_H
#define GLINT_NORMAL_QUADRATIC_H

#include "shade/shade.h"

/* Van Overveld and Wyvill: G = D, on every edge. `corner` as the input has them. */
void normal_quadratic_overveld(const struct scene_vertex *const corner[3], struct normal_quadratic *out);

/*
 * Lee and Jen, on the edges whose bits are in `edges` (bit e: from corner e to the next): only where both normals lean
 * the same way along the edge, each by more than 2^-12 (section 3.1); G is the edge projected on the plane of its
 * normals (3.2). Where these are parallel (their product shorter than 2^-10) or the edge is nearly perpendicular to
 * that plane (|G| < |D| / 4), the triangle's normal takes the place of the one that leans less; where then |G| < |D| /
 * 16, the bulge fades with it, to be 0 where its direction ends; where the other is parallel to the triangle's as well,
 * the edge is linear. Returns 0 if all three edges are.
 */
int normal_quadratic_lee_jen(const struct scene_vertex *const corner[3], unsigned edges, struct normal_quadratic *out);

/* Where the input is a piece made by clipping: the same over the piece. */
void normal_quadratic_restrict(const struct shade_input *in, struct normal_quadratic *n);

/* The vertices of the input's source triangle. */
void normal_quadratic_corners(const struct shade_input *in, const struct scene_vertex *corner[3]);

/* Channels 0 to 2, Q30. */
void normal_quadratic_channels(struct shade_setup *setup, const struct normal_quadratic *n);

#endif

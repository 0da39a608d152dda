/* SPDX-License-Identifier: MIT */
/*
 * Clips a triangle at the near and far planes and the guard band, in the eye's units, before any divide.
 *
 * A corner made by clipping keeps its barycentric coordinates in the triangle it comes from, so that any quantity
 * defined over that triangle, quadratic ones too, can be restricted to the pieces. An edge shared by two triangles is
 * cut at the same point in both: a cut is computed from the inside end to the outside end, which they agree on.
 */
#ifndef GLINT_CLIP_H
#define GLINT_CLIP_H

#include "geometry/transform.h"

#define CLIP_MAX_CORNERS 9 /* 3, and one more for each of 6 planes */

struct clip_corner {
    struct eye_point eye;
    /* Barycentric, of the original corners, 0..1. They sum to 1 within 2^-27: a cut of an edge of the triangle's own
     * errs by 1 at most, one by each further plane by 3/2 more, which is 8. */
    q30_t weight[3];
};

struct clip_polygon {
    int count;
    struct clip_corner corner[CLIP_MAX_CORNERS];
};

/* Cuts the triangle of three eye points to what can be projected, in place: fewer than 3 corners when nothing remains.
 * `other` is scratch of the same size. */
void clip_triangle(const struct transform *transform, struct clip_polygon *polygon, struct clip_polygon *other);

#endif

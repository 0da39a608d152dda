/* SPDX-License-Identifier: MIT */
/*
 * "The approximation will always do better than a linear approximation" says "Fast Near Phong-Quality Software Shading"
 * of X-shading. Here are counted, over random normals and lights, the triangles on which it does not: where the RMS
 * difference of X's N.L from Phong's is larger than that of the line, before clamping to 0..1 and after.
 */
#ifndef WORSE_H
#define WORSE_H

#include "reference/decode.h"
#include "reference/shading.h"

#include <stdint.h>

struct worse_triangle {
    struct shading shading;
    double smallest; /* cosine between two of the normals */
};

/* Corner normals of which no two directions within the angle of +z whose cosine this is are likelier than others, under
 * one light of `view` anywhere, by X. `seed` is not 0, and goes on. */
void worse_make(struct worse_triangle *t, struct decode_view *view, double cosine, uint32_t *seed);

/* N.L at barycentric coordinates: Phong's, X's, the line's and the line between corners that are clamped. */
struct worse_values {
    double truth, x, line, clamped_line;
};
struct worse_values worse_at(const struct worse_triangle *t, const double at[3]);

/* Triangles on which X is worse, and how: X's RMS difference over the line's at most, and the smallest angle between
 * two normals of one on which it is, 180 where there is none. */
struct worse_count {
    unsigned worse, clamped_worse;
    double ratio, clamped_ratio, clamped_degrees;
};

/* Of random triangles, always the same, whose normals lie within `degrees` of one direction. */
struct worse_count worse_count(double degrees, unsigned triangles);

#endif

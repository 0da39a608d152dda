/* SPDX-License-Identifier: MIT */
/* Parts of a triangle: the colours of their corners, and polynomials over them. */
#ifndef GLINT_PART_H
#define GLINT_PART_H

#include "shade/shade.h"

#define PART_ONE 32768u /* weights are Q15, three that sum to this */

/* A corner's place from the picture's centre in 2^-15 sub-pixels, exact: |x|, |y| <= 2^29. */
struct part_place {
    int32_t x, y;
};
struct part_place part_place(const struct shade_input *in, const struct part_corner *corner);

/* The weights of a corner in the source triangle, Q15. */
void part_weights(const struct shade_input *in, const struct part_corner *corner, uint16_t weight[3]);

/* Fills in the colour: that of the normal there, interpolated over the source triangle and normalised, and of the
 * place where light or viewer are near. */
void part_shade(const struct shade_input *in, struct part_corner *corner);

/* The triangle's corner k, shaded. */
void part_whole(const struct shade_input *in, int k, struct part_corner *corner);

/* Half-way between two, shaded; exact where their weights are even. */
void part_between(const struct shade_input *in, const struct part_corner *a, const struct part_corner *b,
                  struct part_corner *out);

/* The lowest height of the triangle of three places, sub-pixels, rounded down by at most an eighth. */
int32_t part_height(const struct part_place p[3]);

/*
 * Colour channels over the part of three corners, linear, with the set-up's own origin. `fine`: Q24 steps, for loops
 * that trust corner values to bound it; else Q22, to be clamped. Returns 0, and leaves them, if asked for `fine` where
 * the part's shape or its rounding do not allow it. Here and below, a part is a sub-pixel wide or high at least, as all
 * are that keep an edge of the triangle or half of one that is not short.
 */
int part_linear(struct shade_setup *setup, const struct shade_input *in, const struct part_corner *const corner[3],
                int fine);

/*
 * A quadratic of any kind over the part of three corners: values in Q14 and bulges in Q28 as plane_quadratic() takes
 * them, that of the edge 1-2 to 2^29, as no height is below 2 pixels: second differences stay within 2^30. The
 * channel's are times 2^up modulo 2^32 (up >= -8). Returns 0, and leaves it, where the part is lower than that or too
 * thin.
 */
int part_channel(const struct shade_setup *setup, const struct shade_input *in,
                 const struct part_corner *const corner[3], const int32_t value[3], const int32_t bulge[3], int up,
                 struct channel *channel);

/* The quadratic through corners and middles of the edges 0-1, 1-2, 2-0 of finished colours, Q22 steps ("Quadratic
 * Interpolation in Hardware Rendering", section 3). Returns 0, and leaves them, where the part is too thin for one. */
int part_quadratic(struct shade_setup *setup, const struct shade_input *in, const struct part_corner *const corner[3],
                   const struct part_corner middle[3]);

#endif

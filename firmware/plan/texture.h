/* SPDX-License-Identifier: MIT */
/*
 * What texture coordinates that are not divided by W at each pixel err by at most, and the cheapest kind within a
 * budget.
 *
 * With l_i the barycentric coordinates on the screen, s_i = 1/w_i and S = sum si li, the true coordinate is sum ui mi,
 * mi = si li / S. Let d be the largest difference of the ui, s and s' the largest and the smallest si and
 * q = (s - s') / (s + s').
 *
 * Affine: |sum ui (mi - li)| <= d q / (1 + sqrt(1 - q^2)) <= d q / (2 - q^2).
 *   The mi and the li both sum to 1, so the left side is at most d (M - L), where L and M are the sums of li and of mi
 *   over those i where mi > li. There si > S, elsewhere si <= S; M / (1 - M) <= (s / s') L / (1 - L), since the mean of
 *   the si is at most s over the first and at least s' over the others. The largest M - L of that is
 *   (sqrt(s) - sqrt(s')) / (sqrt(s) + sqrt(s')), which is the form in q; sqrt(1 - q^2) >= 1 - q^2. An edge with d and q
 *   comes to it.
 *
 * Quadratic through the true values at the corners and at the middles of the edges: with the bulges of shade/uv.h, by
 *   multiplying out,  error = sum_{i<j} li lj (ui - uj) (si - sj) (1 / S - 2 / (si + sj)).
 *   On an edge that is d q^2 (s + s') t (1 - t) (1 - 2 t) / S. tests/unit/test_texture_uv.c searches the triangle
 * for all orders of the si and all ui of 0 and d, which suffices as the error is linear in them: nowhere does it pass
 * the edge's by more than .05 %, and that is at most d q^2 (.1927 + .1 q + .2 q^2) for q <= 3/4.
 *
 * A texel that is off by x columns and y rows is off by at most (x + y) * contrast where it is interpolated. The
 * nearest texel is a step: any error may cost all of it somewhere. There only what errs by less than 2^-6 texels is
 * taken, as it is no more than what rounding to pixels does.
 */
#ifndef GLINT_PLAN_TEXTURE_H
#define GLINT_PLAN_TEXTURE_H

#include "scene/scene.h"

/* Of a triangle. */
struct texture_spread {
    uint32_t texels; /* columns and rows between the corners, their largest differences together; Q8, at most 2^23 */
    uint32_t worth;  /* that times contrast and light: 1/255 of full intensity, Q8, saturated at 2^24 */
    int32_t ratio;   /* q of its corners, Q15 */
};

/* d[0], d[1]: the largest differences of the coordinates, Q28, at most 16 turns; `lit`: the most light that a texel can
 * get, Q8. */
struct texture_spread texture_spread(const struct scene_texture *texture, const uint32_t d[2], int32_t ratio_q15,
                                     uint32_t lit_q8);

/* By which part of d the two kinds are off at most: Q16. */
uint32_t texture_affine(int32_t ratio_q15);
uint32_t texture_quadratic(int32_t ratio_q15);

/* What a pixel may be off by a kind: Q8 of 1/255, saturated at 2^16 - 1. No kind but the first two errs. */
uint32_t texture_error(const struct texture_spread *spread, unsigned kind);

/* The cheapest of GLINT_TEXTURE_AFFINE, _QUADRATIC and _PERSPECTIVE within `allowed`, Q8 of 1/255. */
unsigned texture_choose(const struct scene_texture *texture, const struct texture_spread *spread, uint32_t allowed,
                        uint32_t *error);

#endif

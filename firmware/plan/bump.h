/* SPDX-License-Identifier: MIT */
/*
 * How a bump-mapped triangle's L' and H' are to be interpolated for every pixel to stay within the budget. The truth is
 * u = V / |V| of the linear V between unit vectors Vi, times the map's normal N'. With kij = (1 - Vi.Vj) / 2:
 *
 *   linear       V lies along u and is short by r <= 1 - sqrt(1 - 4 S), S <= max(k1 / 4, (2 k1 + k2 + k3) / 12), k1 the
 *                largest (plan/README.md, (a)): N'.L' is off by r at most, the power by 1 - (1 - r)^n, as it is convex
 *   quadratic    Q - u is at most E(k1) long, and at most R(3 max S) along u. N'.L' is off by E. With N' at an angle t
 *                from u, N'.Q <= (1 + R + E^2 / 2) cos(t - E), so the power is off by at most
 *                E max |d cos^n t / dt| + (1 + R + E^2 / 2)^n - 1, the first <= E sqrt(n) (.6065 + .4 / n)
 *   normalised   the truth, but for roundings
 *
 * E and R are tables with numerical verification (tests/unit/test_plan_bump.c), 2 % above what was found. In a
 * perspective view the first two are interpolated in the picture, which moves barycentric coordinates by `shift` and
 * vectors by that times the longest chord. Which texel a pixel takes is not counted: one whose centre lies within 2^-10
 * of a texel from a border may take the neighbour.
 */
#ifndef GLINT_PLAN_BUMP_H
#define GLINT_PLAN_BUMP_H

#include "plan/plan.h"

/* Errors so far, Q8 of 1/255. */
struct plan_bump {
    uint32_t linear, quadratic;
};

enum plan_bump_kind { PLAN_BUMP_LINEAR, PLAN_BUMP_QUADRATIC, PLAN_BUMP_NORMALISED };

/* Adds a light: bend[0] and [1] are the kij of L' and H' on the three edges, Q16; shift of plan_shift(), 0 where the
 * view is orthographic. */
void plan_bump_light(struct plan_bump *plan, const struct plan_surface *s, unsigned light, const uint16_t bend[2][3],
                     uint32_t shift);

/* The cheapest that keeps the surface's budget, and *error what a pixel can then be off by. */
enum plan_bump_kind plan_bump_choose(const struct plan_bump *plan, const struct plan_surface *s, uint16_t *error);

/* The bounds of the quadratic, Q16, at a k in Q16 of at most CURVE_MOST_BEND and a step: E, and R. */
uint32_t plan_bump_distance(uint32_t k);
uint32_t plan_bump_length(uint32_t k);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Which triangles may hold the centre of a highlight: the tests H1 and H2 of Cho, Neumann and Woo, "Improved Specular
 * Highlights with Adaptive Shading" (1996), section 2, in the object's axes and without a root.
 *
 * At a point with normal N, L and V the ways to light and viewer, the centre satisfies
 *     H1: (L x V) . N = 0,    H2: V.N / |V| = L.N / |L|.
 * Both change sign within a triangle only if they do between its corners, for far light and viewer and a normal
 * interpolated linearly; near ones make it a good guess. A zero, and what is nearer to 0 than its rounding, counts as
 * both signs.
 */
#ifndef GLINT_HIGHLIGHTED_H
#define GLINT_HIGHLIGHTED_H

#include "geometry/object.h"
#include "glint.h"

/* A point of a mesh: place in position units, |p| <= 2^15; normal of any length, |n| <= 2^25. */
struct highlighted_point {
    int32_t place[3], normal[3];
};

/* At one point, a bit a light. */
struct highlighted_signs {
    uint8_t below1, above1, below2, above2; /* H1's and H2's left side less their right: <= 0, >= 0 */
    uint8_t away;                           /* the point faces away from light and viewer */
    uint8_t towards;                        /* it faces both: its back does not */
};

/* A light's two conditions at a point: -1, 0 or 1. */
struct highlighted_conditions {
    int8_t h1, h2, away, towards;
};
struct highlighted_conditions highlighted_at(const struct object_state *object, unsigned light,
                                             const struct highlighted_point *point);

/* Of all lights. */
struct highlighted_signs highlighted_signs(const struct object_state *object, unsigned lights,
                                           const struct highlighted_point *point);

/* The lights whose highlight may be centred in the triangle of three points, or in its back if it faces away, a bit
 * each. */
static inline unsigned highlighted_centres(const struct highlighted_signs *a, const struct highlighted_signs *b,
                                           const struct highlighted_signs *c)
{
    return fx_u32((a->below1 | b->below1 | c->below1) & (a->above1 | b->above1 | c->above1) &
                  (a->below2 | b->below2 | c->below2) & (a->above2 | b->above2 | c->above2));
}

/* The lights whose highlight may be centred in the triangle. */
static inline unsigned highlighted_lights(const struct highlighted_signs *a, const struct highlighted_signs *b,
                                          const struct highlighted_signs *c)
{
    return highlighted_centres(a, b, c) & ~fx_u32(a->away & b->away & c->away);
}

/*
 * Tests all triangles of an object. Of the words that a method keeps behind a vertex record's lights, the first
 * HIGHLIGHTED_WORDS are used meanwhile and left 0; the next gets a bit at the corners of each triangle that passes,
 * else it is 0: a triangle of which a corner has it is one that passes or one of its neighbours. Another bit is that of
 * backs, in scenes that have two-sided materials.
 */
#define HIGHLIGHTED_WORDS 4
#define HIGHLIGHTED_FRONT 1
#define HIGHLIGHTED_BACK  2
void highlighted_mark(const struct object_state *object, const struct scene_header *scene, int16_t *records,
                      unsigned stride, struct glint_stats *stats);

#endif

/* SPDX-License-Identifier: MIT */
/* The highlight test of "Improved Specular Highlights with Adaptive Shading", section 2.3. */
#ifndef HIGHLIGHT_H
#define HIGHLIGHT_H

#include "reference/shading.h"

#include <stdbool.h>

/* Where a point is beside the two planes in which the normal at the centre of a highlight lies: H1, in the plane of
 * light, viewer and point, and H2, in the one half-way between light and viewer at right angles to it. */
struct highlight_sides {
    double h1, h2;
    bool faces; /* light or viewer */
};

struct highlight_sides highlight_sides(const struct decode_view *view, unsigned light,
                                       const struct decode_vertex *vertex);

/* Can the centre of a highlight of this light lie in this triangle? */
bool highlight_under(const struct decode_view *view, unsigned light, const struct decode_vertex corner[3]);

/* Can the centre of a highlight lie in this triangle, under any of the lights? */
bool highlight_possible(const struct decode_view *view, const struct decode_vertex corner[3]);

/* Sets reached[] of every vertex of such a triangle, clears the others'. A highlight is wider than its centre: what it
 * can reach are all triangles at these vertices (section 4). */
void highlight_mark(const struct decode_view *view, const struct scene_triangle *triangles, uint32_t count,
                    const struct decode_vertex *vertices, bool *reached, uint32_t vertex_count);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Scan conversion: which pixels a triangle covers. A pixel belongs to it when its centre does; on an edge, when the
 * edge is a left one or a top one: rows ceil(y - 1/2) and columns ceil(x - 1/2), half open. Crossings are exact: whole
 * quotients and remainders are carried from row to row, so an edge that two triangles share is the same for both.
 */
#ifndef GLINT_EDGES_H
#define GLINT_EDGES_H

#include "fixed/fixed.h"

/* One edge at the current row: the first column whose centre is not left of it, and what is left over of the
 * division, in [0, den). */
struct edge {
    int32_t column, rest, column_step, rest_step, den;
};

/* A triangle's rows [row, last), and its two sides at `row`. */
struct edges {
    struct edge left, right;
    int32_t row, middle, last;
    int32_t lower_x, lower_y, lower_dx, lower_dy; /* at `middle` one side turns to the lower edge */
    uint8_t lower_is_left, turned;
    uint8_t cut; /* may reach past the picture's sides */
};

/* Columns [x0, x1) of a row, inside the picture; x1 <= x0: none. */
struct span {
    int16_t x0, x1;
};

/* The first row (or column) whose centre, at 16 i + 8, is not before v: v in 28.4 from the picture's corner. */
static inline int32_t edges_first(int32_t v)
{
    return (v + 7) >> 4;
}

/*
 * Starts at the row `from` or the triangle's first, whichever is lower. Corners are p[k] = x, y, 28.4 from the
 * picture's centre, clockwise on the screen. Returns 0 if no row is left before `to`.
 */
int edges_setup(struct edges *e, const int16_t *const p[3], unsigned width, unsigned height, int32_t from, int32_t to);

/* The spans of the next rows, at most `most` of them: how many. */
int edges_spans(struct edges *e, int width, struct span *out, int most);

#endif

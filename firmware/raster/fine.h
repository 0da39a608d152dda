/* SPDX-License-Identifier: MIT */
/*
 * Scan conversion of parts of a triangle, by the rule of edges.h. The corners of parts are weighted means of the
 * triangle's, with weights in Q15: in 28.19 they are exact. So a corner set on an edge lies on it, parts meet without
 * gap or overlap, and together they cover what the triangle covers, however it was split.
 */
#ifndef GLINT_FINE_H
#define GLINT_FINE_H

#include "raster/edges.h"
#include "shade/part.h"

/* The first row whose centre is not above y. */
static inline int32_t fine_row(int32_t y, unsigned height)
{
    /* (8 height - 8) / 16 rows lie above the picture's centre: at most 2^29 more */
    return (y + (8 * fx_s32(height) - 8) * (1 << 15) + (1 << 19) - 1) >> 19;
}

/*
 * The first rows of [from, to) that the triangle of corners p, clockwise on the screen, covers and in which no side
 * turns, for edges_spans(); 0 if there are none. Others begin at e->last.
 */
int fine_setup(struct edges *e, const struct part_place p[3], unsigned width, unsigned height, int32_t from,
               int32_t to);

#endif

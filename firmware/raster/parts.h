/* SPDX-License-Identifier: MIT */
/* Pixels of parts of the triangle in hand. Each is drawn over the band's rows; returns its pixels. `e` is overwritten:
 * there is room for one struct edges on the stack. */
#ifndef GLINT_PARTS_H
#define GLINT_PARTS_H

#include "raster/fine.h"
#include "raster/raster.h"

/* Colours linear between its corners. */
uint32_t parts_linear(struct raster *r, struct edges *e, const struct part_corner *const corner[3]);

/* Colours quadratic through its corners and the middles of its edges 01, 12, 20. */
uint32_t parts_quadratic(struct raster *r, struct edges *e, const struct part_corner *const corner[3],
                         const struct part_corner middle[3]);

/* 1 if it has a row in the band. */
int parts_shows(const struct raster *r, const struct part_corner *const corner[3]);

#endif

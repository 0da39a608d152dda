/* SPDX-License-Identifier: MIT */
/* Pixels of parts of the triangle in hand. Each is drawn over the rows [from, to); returns its pixels. */
#ifndef GLINT_PARTS_H
#define GLINT_PARTS_H

#include "raster/fine.h"
#include "raster/raster.h"

/* Colours linear between its corners. */
uint32_t parts_linear(struct raster *r, const struct part_corner *const corner[3], int32_t from, int32_t to);

/* Colours quadratic through its corners and the middles of its edges 01, 12, 20. */
uint32_t parts_quadratic(struct raster *r, const struct part_corner *const corner[3],
                         const struct part_corner middle[3], int32_t from, int32_t to);

/* 1 if it has a row in [from, to). */
int parts_shows(const struct raster *r, const struct part_corner *const corner[3], int32_t from, int32_t to);

#endif

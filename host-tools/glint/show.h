/* SPDX-License-Identifier: MIT */
/* What glint_auto chose, as a picture: each triangle in the colour of the way that it is drawn by, a little lighter or
 * darker than its neighbours, without texture and fog. */
#ifndef SHOW_H
#define SHOW_H

#include "glint.h"

/* A method that plans as glint_auto does and paints that. */
extern const struct glint_method show_plan;

/* The legend, cheapest first: as in glint_method_names, and how it is painted. */
enum { SHOW_WAYS = 10 };
extern const struct show_way {
    enum glint_method_id id;
    uint8_t rgb[3];
} show_ways[SHOW_WAYS];

#endif

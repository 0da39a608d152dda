/* SPDX-License-Identifier: MIT */
/*
 * Which pixels a polygon covers, by another way than the renderer's: a ray to the left from each pixel's centre crosses
 * the outline an odd number of times. The top-left rule is that of a centre moved right a little, and down far less.
 */
#ifndef COVER_H
#define COVER_H

#include <stdint.h>

struct cover_point {
    int32_t x, y; /* 28.4 from the picture's centre, y down */
};

/* The centre of pixel (column, row) in those. */
static inline struct cover_point cover_centre(int column, int row, unsigned width, unsigned height)
{
    return (struct cover_point){16 * column + 8 - 8 * (int32_t)width, 16 * row + 8 - 8 * (int32_t)height};
}

/* Twice the area that three points span, positive if they turn clockwise with y down. */
static inline int64_t cover_turn(struct cover_point a, struct cover_point b, struct cover_point c)
{
    return (int64_t)(b.x - a.x) * (c.y - a.y) - (int64_t)(c.x - a.x) * (b.y - a.y);
}

/* 1 if a simple polygon, either way round, covers the pixel whose centre is c. */
static inline int cover_polygon(const struct cover_point *p, int count, struct cover_point c)
{
    int inside = 0;
    for (int i = 0; i < count; i++) {
        const struct cover_point *upper = &p[i], *lower = &p[i + 1 == count ? 0 : i + 1];
        if (upper->y > lower->y) {
            const struct cover_point *swap = upper;
            upper = lower;
            lower = swap;
        }
        if (upper->y <= c.y && c.y < lower->y)
            inside ^= cover_turn(*upper, *lower, c) <= 0; /* the crossing is at c or to its left */
    }
    return inside;
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * What a pixel is by definition, in whole numbers: slow, and as short as it can be. Nothing here is taken from the
 * renderer's sources but the shapes of its results.
 *
 *   coverage     three edge functions at the pixel's centre; where one is 0, the edge must be a top or a left one
 *   value        sum Ii li - sum aij li lj over the barycentric coordinates l, a rational number (exact_rational.h)
 *   polynomial   the same as f + d i + e j + a i^2 + b j^2 + c i j from an origin pixel: six rationals
 *   a channel    whole coefficients, each within a bound of its rational (exact_bounds.h); from there on all is exact
 */
#ifndef EXACT_H
#define EXACT_H

#include "shade/plane.h"
#include "tests/unit/cover.h"

/* Corners of a triangle, clockwise on the screen, in a picture of this size. |p| <= 2^15: edge functions are below
 * 2^33. */
struct exact_triangle {
    struct cover_point p[3];
    unsigned width, height;
};

/* Twice the area, in sub-pixels. */
static inline int64_t exact_area(const struct exact_triangle *t)
{
    return cover_turn(t->p[0], t->p[1], t->p[2]);
}

/* The edge function of the edge that begins at corner k: positive inside. */
static inline int64_t exact_edge(const struct exact_triangle *t, int k, struct cover_point c)
{
    return cover_turn(t->p[k], t->p[(k + 1) % 3], c);
}

/* Clockwise with y down, a left edge goes up and a top one to the right. */
static inline int exact_owns(const struct exact_triangle *t, int k)
{
    const struct cover_point a = t->p[k], b = t->p[(k + 1) % 3];
    return b.y < a.y || (b.y == a.y && b.x > a.x);
}

static inline int exact_covers(const struct exact_triangle *t, int x, int y)
{
    const struct cover_point c = cover_centre(x, y, t->width, t->height);
    for (int k = 0; k < 3; k++) {
        const int64_t side = exact_edge(t, k, c);
        if (side < 0 || (side == 0 && !exact_owns(t, k)))
            return 0;
    }
    return 1;
}

/* What a polynomial of whole coefficients is at column i, row j of its origin, |i|, |j| < 2^11: all of it, below 2^55,
 * then its low 32 bits. */
static inline uint32_t exact_at(const struct polynomial *p, int i, int j)
{
    const int64_t f = (int32_t)p->f, d = (int32_t)p->d, e = (int32_t)p->e, a = (int32_t)p->a, b = (int32_t)p->b,
                  c = (int32_t)p->c;
    return (uint32_t)(f + d * i + e * j + a * i * i + b * j * j + c * i * j);
}

/* The origin: the pixel of the picture nearest to the one that corner 0 lies in; and its centre from there, in
 * sub-pixels. */
struct exact_origin {
    int x, y;
    int32_t from_x, from_y;
};

static inline int exact_clamped(int v, int size)
{
    return v < 0 ? 0 : v >= size ? size - 1 : v;
}

static inline struct exact_origin exact_origin(const struct exact_triangle *t)
{
    const int column = (t->p[0].x + 8 * (int)t->width) >> 4, row = (t->p[0].y + 8 * (int)t->height) >> 4;
    struct exact_origin o = {.x = exact_clamped(column, (int)t->width), .y = exact_clamped(row, (int)t->height)};
    const struct cover_point centre = cover_centre(o.x, o.y, t->width, t->height);
    o.from_x = centre.x - t->p[0].x;
    o.from_y = centre.y - t->p[0].y;
    return o;
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * What a pixel is by definition, in whole numbers of 128 bits and rationals of them: slow, and as short as it can be.
 * Nothing here is taken from the renderer's sources but the shapes of its results.
 *
 *   coverage     three edge functions at the pixel's centre; where one is 0, the edge must be a top or a left one
 *   value        sum Ii li - sum aij li lj over the barycentric coordinates l, a rational number
 *   polynomial   the same as f + d i + e j + a i^2 + b j^2 + c i j from an origin pixel: six rationals
 *   a channel    whole coefficients, each within a bound of its rational (exact_bounds.h); from there on all is exact
 */
#ifndef EXACT_H
#define EXACT_H

#include "shade/plane.h"
#include "tests/unit/cover.h"

typedef __int128 exact_t;

/* Corners of a triangle, clockwise on the screen, in a picture of this size. |p| <= 2^15: edge functions are below
 * 2^33, a linear value's numerator below 2^17 2^33 3, a quadratic one's below 2^31 2^66 2^4. */
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

/* Barycentric coordinates of the pixel's centre, times the area. */
static inline void exact_weights(const struct exact_triangle *t, int x, int y, exact_t l[3])
{
    const struct cover_point c = cover_centre(x, y, t->width, t->height);
    for (int k = 0; k < 3; k++)
        l[k] = exact_edge(t, (k + 1) % 3, c);
}

/* A quantity over a triangle: corner values, of which the channel holds `unit` times as much, and bulges of the edges
 * 0-1, 1-2, 2-0 in Q28, of which it holds 4 times as much (Q30). */
struct exact_quantity {
    int32_t value[3], bulge[3];
    int32_t unit; /* 2^16, or 1 where corner values are in Q30 themselves */
};

/* What the channel should hold at a pixel, times the area squared. */
static inline exact_t exact_value(const struct exact_triangle *t, const struct exact_quantity *q, int x, int y)
{
    exact_t l[3], linear = 0, bend = 0;
    exact_weights(t, x, y, l);
    for (int k = 0; k < 3; k++) {
        linear += q->value[k] * l[k];
        bend += q->bulge[k] * l[k] * l[(k + 1) % 3];
    }
    return linear * q->unit * exact_area(t) - 4 * bend;
}

/* The six rationals, all over `den`. */
struct exact_polynomial {
    exact_t f, d, e, a, b, c, den;
};

/* From values at six pixels about the origin (ox, oy): a quadratic has no more to it. */
static inline struct exact_polynomial exact_polynomial(const struct exact_triangle *t, const struct exact_quantity *q,
                                                       int ox, int oy)
{
    const exact_t here = exact_value(t, q, ox, oy), right = exact_value(t, q, ox + 1, oy),
                  left = exact_value(t, q, ox - 1, oy), below = exact_value(t, q, ox, oy + 1),
                  above = exact_value(t, q, ox, oy - 1), both = exact_value(t, q, ox + 1, oy + 1);
    /* over twice the area squared, as the halves may not be whole */
    return (struct exact_polynomial){.f = 2 * here,
                                     .d = right - left,
                                     .e = below - above,
                                     .a = right + left - 2 * here,
                                     .b = below + above - 2 * here,
                                     .c = 2 * (both - right - below + here),
                                     .den = 2 * (exact_t)exact_area(t) * exact_area(t)};
}

/* How far 32 bits are from a rational number, modulo 2^32: the rational taken exactly, the difference to a double. */
static inline double exact_off(uint32_t got, exact_t number, exact_t den)
{
    const exact_t turn = den << 32;
    exact_t off = (got * den - number) % turn;
    if (off > turn / 2)
        off -= turn;
    if (off < -(turn / 2))
        off += turn;
    return (double)off / (double)den;
}

/* What a polynomial of whole coefficients is at column i, row j of its origin: all of it, then its low 32 bits. */
static inline uint32_t exact_at(const struct polynomial *p, int i, int j)
{
    const exact_t f = (int32_t)p->f, d = (int32_t)p->d, e = (int32_t)p->e, a = (int32_t)p->a, b = (int32_t)p->b,
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

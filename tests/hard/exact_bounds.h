/* SPDX-License-Identifier: MIT */
/*
 * How far a channel's whole coefficients may be from the rationals that they stand for (exact_rational.h), in units of
 * the channel's last place. Each bound adds up what the ways of shade/plane.h round, step by step; nothing is measured:
 *
 *   the reciprocal    errs by 2^-30.46 of itself (fixed.h), 2.91 * 2^-32; halved it loses 2^-31 more: 5 * 2^-32
 *   its square        5.82 * 2^-32, and less than a unit of 2^29 (in 64 bits: of 2^30): 14 (10) * 2^-32
 *   a high product    drops less than 1, which its shift multiplies; a shift down rounds by half a unit
 */
#ifndef EXACT_BOUNDS_H
#define EXACT_BOUNDS_H

#include "exact_rational.h"

#include <math.h>
#include <stdlib.h>

struct exact_bounds {
    double f, d, e, a, b, c;
};

/* A triangle from its first corner, in sub-pixels. */
struct exact_frame {
    double x1, y1, x2, y2, area; /* sizes */
    int up, scale;               /* leading zeros of the area's 32 bits; 14 less the bits of the largest difference */
    double from_x, from_y;       /* size of the origin's distance */
};

static inline int exact_bits(uint64_t v)
{
    int n = 0;
    for (; v; v >>= 1)
        n++;
    return n;
}

static inline struct exact_frame exact_frame(const struct exact_triangle *t)
{
    const struct exact_origin o = exact_origin(t);
    struct exact_frame f = {.x1 = abs(t->p[1].x - t->p[0].x),
                            .y1 = abs(t->p[1].y - t->p[0].y),
                            .x2 = abs(t->p[2].x - t->p[0].x),
                            .y2 = abs(t->p[2].y - t->p[0].y),
                            .area = (double)exact_area(t),
                            .up = 32 - exact_bits((uint64_t)exact_area(t)),
                            .from_x = abs(o.from_x),
                            .from_y = abs(o.from_y)};
    f.scale = 14 - exact_bits((uint64_t)fmax(fmax(f.x1, f.y1), fmax(f.x2, f.y2)));
    return f;
}

/* A product that drops less than 1, then goes up by `up`, or is rounded where that is negative. */
static inline double exact_product_error(int up)
{
    return ldexp(1, up) + (up < 0 ? .5 : 0);
}

/* The size of one rational. */
static inline double exact_size(exact_t number, exact_t den)
{
    return fabs((double)number / (double)den);
}

/* A gradient's error, a sub-pixel's step: `dropped`, by how much corner differences are rounded before; `reach1` and
 * `reach2`, by what these are multiplied. */
static inline double exact_gradient_error(const struct exact_frame *f, double gradient, double dropped, double reach1,
                                          double reach2)
{
    const double lost = dropped + (f->scale < 0 ? ldexp(1, -f->scale - 1) : 0);
    return exact_product_error(f->up - f->scale - 14) + gradient * 5 * 0x1p-32 +
           lost * 65536 * (reach1 + reach2) / f->area * (1 + 5 * 0x1p-32);
}

/* plane_linear(): only the gradient is rounded. */
static inline struct exact_bounds exact_linear_bounds(const struct exact_triangle *t, const struct exact_polynomial *p)
{
    const struct exact_frame f = exact_frame(t);
    const double gx = exact_gradient_error(&f, exact_size(p->d, p->den) / 16, 0, f.y1, f.y2),
                 gy = exact_gradient_error(&f, exact_size(p->e, p->den) / 16, 0, f.x1, f.x2);
    return (struct exact_bounds){.f = gx * f.from_x + gy * f.from_y, .d = 16 * gx, .e = 16 * gy};
}

/* plane_quadratic() in 32 bits: corner values less their bulges are rounded to Q14, by half a unit; second differences
 * are the high product of a sum that three high products are rounded into (below 2) and of the reciprocal's square
 * (below 2^31), so that 2 units and half of one more go up by the shift. What they add to f, d and e drops less than a
 * unit of each multiple. */
static inline struct exact_bounds exact_quadratic_bounds(const struct exact_triangle *t,
                                                         const struct exact_polynomial *p)
{
    const struct exact_frame f = exact_frame(t);
    const double A = exact_size(p->a, p->den), B = exact_size(p->b, p->den), C = exact_size(p->c, p->den);
    const double slope_x = exact_size(p->d, p->den) / 16 + A * f.from_x / 128 + C * f.from_y / 256,
                 slope_y = exact_size(p->e, p->den) / 16 + B * f.from_y / 128 + C * f.from_x / 256;
    const double gx = exact_gradient_error(&f, slope_x, .5, f.y1, f.y2),
                 gy = exact_gradient_error(&f, slope_y, .5, f.x1, f.x2);
    const int up = 2 * (f.up - f.scale) - 22;
    const double second = ldexp(2, up) + (up < 0 ? .5 : 0), mixed = ldexp(2, up + 1) + (up + 1 < 0 ? .5 : 0);
    const double a = second + A * 14 * 0x1p-32, b = second + B * 14 * 0x1p-32, c = mixed + C * 14 * 0x1p-32;
    const double x = f.from_x, y = f.from_y;
    return (struct exact_bounds){.f = gx * x + gy * y + (a / 256 + 1) * x * x + (b / 256 + 1) * y * y +
                                      (c / 256 + 1) * x * y,
                                 .d = 16 * gx + (a / 8 + 1) * x + (c / 16 + 1) * y,
                                 .e = 16 * gy + (b / 8 + 1) * y + (c / 16 + 1) * x,
                                 .a = a,
                                 .b = b,
                                 .c = c};
}

/* In 64 bits, Q46 until the end: eq. 32's coefficients of second order drop 3/4 of Q26, 12 of Q30; the coefficients are
 * rounded by half a unit. plane_linear_wide() is the same without second differences. */
static inline struct exact_bounds exact_wide_bounds(const struct exact_triangle *t, const struct exact_polynomial *p)
{
    const struct exact_frame f = exact_frame(t);
    const double A = exact_size(p->a, p->den), B = exact_size(p->b, p->den), C = exact_size(p->c, p->den);
    const double x = f.from_x, y = f.from_y, area2 = f.area * f.area;
    const double slope_x = exact_size(p->d, p->den) / 16 + A * x / 128 + C * y / 256,
                 slope_y = exact_size(p->e, p->den) / 16 + B * y / 128 + C * x / 256;
    const double first = exact_product_error(f.up - 15) * 0x1p-16,
                 second = exact_product_error(2 * f.up - 42) * 0x1p-16;
    const double gx = first + slope_x * 3 * 0x1p-32, gy = first + slope_y * 3 * 0x1p-32;
    const double ax = second + A / 256 * 10 * 0x1p-32 + 12 * (f.y1 * f.y1 + f.y2 * f.y2 + f.y1 * f.y2) / area2,
                 ay = second + B / 256 * 10 * 0x1p-32 + 12 * (f.x1 * f.x1 + f.x2 * f.x2 + f.x1 * f.x2) / area2,
                 axy = second + C / 256 * 10 * 0x1p-32 +
                       12 * (2 * f.x1 * f.y1 + 2 * f.x2 * f.y2 + f.x1 * f.y2 + f.x2 * f.y1) / area2;
    return (struct exact_bounds){.f = gx * x + gy * y + ax * x * x + ay * y * y + axy * x * y + .5,
                                 .d = 16 * (gx + 2 * ax * x + axy * y) + .5,
                                 .e = 16 * (gy + 2 * ay * y + axy * x) + .5,
                                 .a = 256 * ax + .5,
                                 .b = 256 * ay + .5,
                                 .c = 256 * axy + .5};
}

/* A channel without a polynomial: barycentric coordinates in Q16, two too small by less than 1 and too large by less
 * than 2^-14 for the reciprocal, the third what is left, off by up to twice that. `wide`: corner values are in Q30, and
 * they and the bulges lose what a high product drops, 4 units each. */
static inline double exact_corner_bound(const struct exact_quantity *q, int wide)
{
    const double weight = 1 + 0x1p-14;
    double sum = (fabs((double)q->value[1] - q->value[0]) + fabs((double)q->value[2] - q->value[0])) * q->unit / 65536;
    for (int k = 0; k < 3; k++)
        sum += fabs((double)q->bulge[k]) * 4 / 65536 * 2;
    return sum * weight + (wide ? 24 : 0);
}

#endif

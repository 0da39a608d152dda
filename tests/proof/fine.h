/* SPDX-License-Identifier: MIT */
/* What the functions of raster/fine.c ask and give: each is proven by one of fine*.c, and assumed by what calls it. What
 * is no interval in them is shown by the lemmas (.smt2). */
#ifndef PROOF_FINE_H
#define PROOF_FINE_H

#include "fixed/fixed.h"

/*@ requires numerator: -0x40080000 <= num <= 0x40080000;
    requires divisor: 1 <= den <= 0x40000000;
    requires apart: \valid(quotient) && \valid(remainder) && \separated(quotient, remainder);
    assigns *quotient, *remainder \from num, den;
    ensures set: \initialized(quotient) && \initialized(remainder);
    ensures floor: *quotient * den + *remainder == num;
    ensures rest: 0 <= *remainder < den;
    ensures above: num >= 0 ==> 0 <= *quotient <= num;
    ensures below: num < 0 ==> num <= *quotient <= -1; */
static inline void fx_divmod_floor(int32_t num, int32_t den, int32_t *quotient, int32_t *remainder);

#include "firmware/raster/fine.c"

/*@ requires divisor: 1 <= d <= 0x40000000;
    requires numerator: -0x1000 * d <= n <= 0x1000 * d;
    requires there: \valid(rest);
    assigns *rest, \result \from n, d;
    ensures set: \initialized(rest);
    ensures rest: 0 <= *rest < d;
    ensures quotient: \result * d + *rest == n; */
static int32_t divide(int64_t n, int32_t d, int32_t *rest);

/*@ requires ends: -0x40000000 <= x <= 0x40000000 && -0x40000000 <= x + dx <= 0x40000000;
    requires across: -0x40000000 <= dx <= 0x40000000;
    requires falls: 1 <= dy <= 0x40000000;
    requires crossed: 0 <= centre - y <= dy;
    requires there: \valid(e);
    assigns *e \from x, y, dx, dy, centre;
    ensures divisor: e->den == dy;
    ensures rest: 0 <= e->rest < e->den;
    ensures more: 0 <= e->rest_step < e->den;
    ensures further: e->column_step * e->den + e->rest_step == dx;
    ensures least: (e->column - 1) * e->den * 0x80000 < x * dy + (centre - y) * dx;
    ensures first: x * dy + (centre - y) * dx <= e->column * e->den * 0x80000; */
static void edge_setup(struct edge *e, int32_t x, int32_t y, int32_t dx, int32_t dy, int32_t centre);

#endif

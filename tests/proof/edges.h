/* SPDX-License-Identifier: MIT */
/* What the functions of raster/edges.c ask and give, and the division that they are made of: proven by divmod.c and
 * edge.c, and assumed by what calls them. What is no interval in them is shown by the lemmas (.smt2). */
#ifndef PROOF_EDGES_H
#define PROOF_EDGES_H

#include "fixed/fixed.h"

#include "raster/edges.h"

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

/*@ requires numerator: -0x40080000 <= num <= 0x40080000;
    requires divisor: 1 <= den <= 0x40000000;
    requires apart: \valid(quotient) && \valid(remainder) && \separated(quotient, remainder);
    assigns *quotient, *remainder \from num, den;
    ensures set: \initialized(quotient) && \initialized(remainder);
    ensures floor: *quotient * den + *remainder == num;
    ensures rest: 0 <= *remainder < den;
    ensures above: num >= 0 ==> 0 <= *quotient <= num;
    ensures below: num < 0 ==> num <= *quotient <= -1; */
static inline void fx_divmod_floor_narrow(int32_t num, int32_t den, int32_t *quotient, int32_t *remainder);

/*@ requires ends: -0x8000 <= x <= 0x8000 && -0x8000 <= x + dx <= 0x8000;
    requires across: -0x8000 <= dx <= 0x8000;
    requires falls: 1 <= dy <= 0x8000;
    requires crossed: 0 <= centre - y <= dy;
    requires there: \valid(e);
    assigns *e \from x, y, dx, dy, centre;
    ensures divisor: 16 <= e->den <= 0x80000;
    ensures rest: 0 <= e->rest < e->den;
    ensures more: 0 <= e->rest_step < e->den;
    ensures slope: -0x8000 <= e->column_step <= 0x8000;
    ensures crossing: e->column * e->den + e->rest == x * dy + (centre - y) * dx + e->den - 1;
    ensures further: e->column_step * e->den + e->rest_step == 16 * dx; */
static inline void edge_setup(struct edge *e, int32_t x, int32_t y, int32_t dx, int32_t dy, int32_t centre);

/*@ requires divisor: 1 <= e->den <= 0x40000000;
    requires more: 0 <= e->rest_step < e->den;
    requires negative: 0x100000000 - e->den <= *rest;
    requires apart: \valid(column) && \valid(rest) && \separated(column, rest, e);
    assigns *column \from *column, *rest, *e;
    assigns *rest \from *rest, *e;
    ensures negative: 0x100000000 - e->den <= *rest;
    ensures small: 0xc0000000 <= *rest; */
static inline void step(uint32_t *column, uint32_t *rest, const struct edge *e);

#endif

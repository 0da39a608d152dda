/* SPDX-License-Identifier: MIT */
/*
 * Parts of the renderer in other precisions than its own, for host and boards alike.
 *
 * Reciprocals and roots are the series of fixed.c cut off earlier, in its formats: the table alone, with one term, with
 * two... Power tables are fx_power()'s with 2^bits steps, interpolated or the nearest entry.
 */
#ifndef PARTS_H
#define PARTS_H

#include "fixed/fixed.h"

/* Once, before anything below. */
void parts_begin(void);

typedef uint32_t parts_function(uint32_t m);

struct parts_choice {
    const char *name;
    parts_function *run;
};

/* 2^63 / m as fx_recip_norm(), the renderer's own last but one; and the exact one, a bit at a time. */
enum { PARTS_RECIPROCALS = 5, PARTS_RECIPROCAL_OWN = 3 };
extern const struct parts_choice parts_reciprocals[PARTS_RECIPROCALS];

/* 2^46 / sqrt(m) as fx_rsqrt_norm(), the renderer's own last. */
enum { PARTS_ROOTS = 3, PARTS_ROOT_OWN = 2 };
extern const struct parts_choice parts_roots[PARTS_ROOTS];

enum { PARTS_POWER_LEAST = 4, PARTS_POWER_MOST = 10, PARTS_POWER_OWN = 7 }; /* bits */

struct parts_table {
    unsigned octave;
    uint16_t value[(1u << PARTS_POWER_MOST) + 2]; /* Q15, as struct fx_power's */
};

/* The table for n in 1..1023. */
void parts_power_build(struct parts_table *table, unsigned n, unsigned bits);

/* s^n in Q15 of s in Q30. To be called with a constant `bits` where instructions are counted. */
FX_WRAPS static inline __attribute__((always_inline)) uint32_t parts_power(const struct parts_table *table, q30_t s,
                                                                           unsigned bits, int nearest)
{
    const uint32_t one = 1u << 30, span = one >> table->octave;
    uint32_t above = (uint32_t)s - (one - span);
    if (above >= span)
        return s >= (q30_t)one ? 32768u : 0u;
    uint32_t t = above << table->octave; /* < 2^30 */
    if (nearest)
        return table->value[(t + (1u << (29 - bits))) >> (30 - bits)];
    const uint16_t *v = &table->value[t >> (30 - bits)];
    return v[0] + ((uint32_t)(v[1] - v[0]) * (t << (2 + bits) >> 17) >> 15); /* < 2^15 * 2^15 */
}

#endif

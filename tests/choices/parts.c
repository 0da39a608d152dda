/* SPDX-License-Identifier: MIT */
#include "tests/choices/parts.h"

/* fixed.c's tables, by their definitions. */
static uint16_t reciprocal_table[256], root_table[192];

void parts_begin(void)
{
    for (uint32_t i = 0; i < 256; i++) /* round(2^18 / (2 i + 513)) */
        reciprocal_table[i] = (uint16_t)(((1u << 19) / (2 * i + 513) + 1) >> 1);
    for (uint32_t i = 0; i < 192;
         i++) { /* round(sqrt(2^23 / (2 i + 129))): from below the least y above it by a half */
        uint32_t y = 128;
        while ((2 * y + 1) * (2 * y + 1) * (2 * i + 129) < 1u << 25)
            y++;
        root_table[i] = (uint16_t)y;
    }
}

/* fx_recip_norm() with `terms` of e + e^2 + e^3. */
FX_WRAPS static inline __attribute__((always_inline)) uint32_t reciprocal(uint32_t m, int terms)
{
    int32_t x0 = reciprocal_table[m << 1 >> 24];
    if (terms == 0)
        return (uint32_t)x0 << 23;
    int32_t e = (int32_t)(0u - (uint32_t)x0 * (m >> 1)), s = (e + 0x4000) >> 15;
    uint32_t s2 = (uint32_t)s * (uint32_t)s;
    if (terms > 1)
        e += (int32_t)(s2 >> 9);
    if (terms > 2)
        e += ((int32_t)(s2 >> 17) * s) >> 16;
    return ((uint32_t)x0 << 23) + (uint32_t)fx_mulhi_s32(x0 << 16, e);
}

static uint32_t reciprocal_0(uint32_t m)
{
    return reciprocal(m, 0);
}
static uint32_t reciprocal_1(uint32_t m)
{
    return reciprocal(m, 1);
}
static uint32_t reciprocal_2(uint32_t m)
{
    return reciprocal(m, 2);
}
static uint32_t reciprocal_3(uint32_t m)
{
    return reciprocal(m, 3);
}
static uint32_t reciprocal_exact(uint32_t m)
{
    return (uint32_t)fx_divide_u64(INT64_MAX, m);
}

const struct parts_choice parts_reciprocals[PARTS_RECIPROCALS] = {{"table", reciprocal_0},
                                                                  {"1 term", reciprocal_1},
                                                                  {"2 terms", reciprocal_2},
                                                                  {"3 terms", reciprocal_3},
                                                                  {"exact", reciprocal_exact}};

/* fx_rsqrt_norm() with `terms` of h/2 + 3 h^2/8. */
FX_WRAPS static inline __attribute__((always_inline)) uint32_t root(uint32_t m, int terms)
{
    int32_t y0 = root_table[(m >> 24) - 64];
    if (terms == 0)
        return (uint32_t)y0 << 23;
    int32_t h = (int32_t)(0u - (uint32_t)(y0 * y0) * (m >> 9)), s = h >> 16;
    if (terms > 1)
        h += 3 * (s * s) >> 7;
    return ((uint32_t)y0 << 23) + (uint32_t)(y0 * (h >> 8) >> 7);
}

static uint32_t root_0(uint32_t m)
{
    return root(m, 0);
}
static uint32_t root_1(uint32_t m)
{
    return root(m, 1);
}
static uint32_t root_2(uint32_t m)
{
    return root(m, 2);
}

const struct parts_choice parts_roots[PARTS_ROOTS] = {{"table", root_0}, {"1 term", root_1}, {"2 terms", root_2}};

void parts_power_build(struct parts_table *table, unsigned n, unsigned bits)
{
    const uint32_t one = 1u << 30;
    struct fx_power own;
    fx_power_build(&own, n); /* for the octave, which does not depend on the steps */
    table->octave = own.octave;
    for (uint32_t i = 0; i < 1u << bits; i++)
        table->value[i] =
            (uint16_t)fx_power_exact(n, (q30_t)(one - (one >> own.octave) + (i << (30 - bits) >> own.octave)));
    table->value[1u << bits] = table->value[(1u << bits) + 1] = 32768;
}

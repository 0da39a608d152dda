/* SPDX-License-Identifier: MIT */
#include "shade/power.h"

#include "glint.h"

static void run_exact(unsigned n, int32_t *value, int count)
{
    for (int i = 0; i < count; i++)
        value[i] = fx_s32(fx_power_exact(n, value[i]));
}

const struct glint_power glint_power_exact = {run_exact, 0, 0, 0};

/* v > 0 in Q30 to its 2^squarings-th power in Q15; 1 above 1. A square rounded to 16 bits errs by 2^-17, which
 * each later one at most doubles: in all below 2^-12. */
static inline __attribute__((always_inline)) int32_t squared(int32_t v, int squarings)
{
    if (v >= (1 << 30) - (1 << 13))
        return 32768;
    uint32_t p = (fx_u32(v) + (1u << 13)) >> 14; /* at most 0xffff */
    for (int i = 0; i < squarings; i++)
        p = (p * p + (1u << 15)) >> 16; /* p < 2^16: the square and the half below 2^32 */
    return fx_s32((p + 1) >> 1);
}

/* g = 2^squarings. Only 1 - s < min(1, g / n) gives more than 0: then n (1 - s) / g is below 2^30, as reach is a
 * multiple of 16 that n / g takes to 2^30 at most. */
static inline __attribute__((always_inline)) void run_free(unsigned n, int32_t *value, int count, int squarings)
{
    const uint32_t one = 1u << 30, reach = n >> squarings ? (one >> 4) / n << (squarings + 4) : one;
    for (int i = 0; i < count; i++) {
        uint32_t below = value[i] >= fx_s32(one) ? 0 : fx_wrap_sub(one, fx_wrap_u32(value[i]));
        value[i] = below >= reach ? 0 : squared(fx_s32(one - (n * (below >> 4) << (4 - squarings))), squarings);
    }
}

/* n / g 2^-down in Q32, and what stands for N.H = 0. */
static inline int32_t slope_of(unsigned n, unsigned down, unsigned squarings)
{
    return fx_s32(n << (32 - squarings - down));
}
static inline int32_t offset_of(unsigned down, int32_t slope)
{
    return (1 << (30 - down)) - (slope >> 2);
}

/* With |s| <= 1.09 the result is within 1 + 2.09 n / g <= 2^down, so that its format holds it, and n / g 2^-down is
 * below 1/2. */
static inline __attribute__((always_inline)) unsigned fold_free(unsigned n, const int32_t value[3],
                                                                const int32_t bulge[3], int32_t value_out[3],
                                                                int32_t bulge_out[3], unsigned squarings)
{
    unsigned down = 1;
    while ((16u << squarings << down) < (16u << squarings) + 34 * n)
        down++;
    const int32_t slope = slope_of(n, down, squarings), offset = offset_of(down, slope);
    for (int k = 0; k < 3; k++) {
        value_out[k] = fx_mulhi_s32(value[k] * 65536, slope) + offset;
        bulge_out[k] = fx_mulhi_s32(bulge[k], slope);
    }
    return down;
}

static inline __attribute__((always_inline)) void run_folded(unsigned n, unsigned down, int32_t *value, int count,
                                                             unsigned squarings)
{
    const int32_t one = 1 << (30 - down), offset = offset_of(down, slope_of(n, down, squarings));
    const int32_t foot = offset > 0 ? offset : 0; /* n < g: not 0 where N.H is */
    for (int i = 0; i < count; i++)
        value[i] = value[i] >= one ? 32768 : value[i] <= foot ? 0 : squared(value[i] << down, squarings);
}

#define POWER_FREE(gamma, squarings)                                                                               \
    static void run_##gamma(unsigned n, int32_t *value, int count)                                                 \
    {                                                                                                              \
        run_free(n, value, count, squarings);                                                                      \
    }                                                                                                              \
    static unsigned fold_##gamma(unsigned n, const int32_t value[3], const int32_t bulge[3], int32_t value_out[3], \
                                 int32_t bulge_out[3])                                                             \
    {                                                                                                              \
        return fold_free(n, value, bulge, value_out, bulge_out, squarings);                                        \
    }                                                                                                              \
    static void run_folded_##gamma(unsigned n, unsigned down, int32_t *value, int count)                           \
    {                                                                                                              \
        run_folded(n, down, value, count, squarings);                                                              \
    }                                                                                                              \
    const struct glint_power glint_power_##gamma = {run_##gamma, fold_##gamma, run_folded_##gamma, plane_linear_wide};

POWER_FREE(4, 2)
POWER_FREE(8, 3)
POWER_FREE(16, 4)

/* SPDX-License-Identifier: MIT */
#include "fixed/fixed.h"

/* a * b for fractions in Q64, at most 3 units too small: the product of the low words and two carries are left out. */
FX_WRAPS static uint64_t power_mul(uint64_t a, uint64_t b)
{
    uint32_t a1 = fx_u32(a >> 32), a0 = fx_wrap_u32(a), b1 = fx_u32(b >> 32), b0 = fx_wrap_u32(b);
    uint32_t high = fx_mulhi_u32(a1, b1), low = a1 * b1;
    /* no overflow: the sum is <= a * b < 2^64 */
    return (fx_u64(high) << 32 | low) + fx_mulhi_u32(a1, b0) + fx_mulhi_u32(a0, b1);
}

/* s^n, n >= 1: at most 3 * 2n units of 2^-64 too small, which no rounding to Q15 below sees (all are tested). */
static uint64_t power_of(uint64_t s, unsigned n)
{
    uint64_t p = s;
    for (int bit = 30 - fx_s32(fx_clz(n)); bit >= 0; bit--) {
        p = power_mul(p, p);
        if (n >> bit & 1u)
            p = power_mul(p, s);
    }
    return p;
}

uint32_t fx_power_exact(unsigned n, q30_t s)
{
    FX_REQUIRE(n > 0 && n <= FX_POWER_MAX_EXPONENT, n, s);
    if (s <= 0)
        return 0;
    if (s >= 1 << 30)
        return 32768;
    return fx_u32(((power_of(fx_u64(s) << 34, n) >> 48) + 1) >> 1);
}

/* 1 - steps / 2^(7 + octave) in Q64 for steps in 1..128: 0 for 128 at octave 0, by the shift's overflow. */
FX_WRAPS static uint64_t power_base(uint32_t steps, unsigned octave)
{
    return fx_u64(0u - (steps << (25 - octave))) << 32;
}

void fx_power_build(struct fx_power *table, unsigned n)
{
    FX_REQUIRE(n > 0 && n <= FX_POWER_MAX_EXPONENT, n, 0);
    unsigned octave = 0;
    while (octave < FX_POWER_MAX_OCTAVE && power_of(power_base(FX_POWER_STEPS, octave + 1), n) < fx_u64(1) << 55)
        octave++;
    table->exponent = fx_u16(n);
    table->octave = fx_u16(octave);
    for (unsigned i = 0; i < FX_POWER_STEPS; i++) {
        uint64_t p = power_of(power_base(FX_POWER_STEPS - i, octave), n);
        /* p <= 1 - 2^-14: the half does not overflow */
        table->value[i] = fx_u16((p + (fx_u64(1) << 48)) >> 49);
    }
    table->value[FX_POWER_STEPS] = table->value[FX_POWER_STEPS + 1] = 32768u;
}

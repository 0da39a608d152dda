/* SPDX-License-Identifier: MIT */
#include "fixed/fixed.h"

/* 2^-f = 1 - f / 2 - f (1 - f) (c0 - c1 f) on [0, 1], exact at its ends, within 2^-13.7 between. */
uint32_t fx_exp2_minus(uint32_t x)
{
    const uint32_t one = 1u << 16, whole = x >> 16, f = x & (one - 1);
    if (whole > 17)
        return 0;
    const uint32_t bow = f * (one - f) >> 16;                    /* at most 2^30 */
    const uint32_t slope = 12562u - (2597u * f >> 16);           /* Q16; above 9964 */
    const uint32_t value = one - (f >> 1) - (bow * slope >> 16); /* 2^15..2^16 */
    return (value + (1u << whole >> 1)) >> whole;
}

/* SPDX-License-Identifier: MIT */
#include "fixed/fixed.h"

uint64_t fx_divide_u64(uint64_t n, uint64_t d)
{
    FX_REQUIRE(d > 0, n, d);
    uint64_t quotient = 0, bit = 1;
    for (; d < n && !(d >> 63); d <<= 1)
        bit <<= 1;
    for (; bit; bit >>= 1, d >>= 1)
        if (n >= d) {
            n -= d;
            quotient |= bit;
        }
    return quotient;
}

int64_t fx_divide_s64(int64_t n, int64_t d)
{
    FX_REQUIRE(n >= -INT64_MAX && d >= -INT64_MAX && d != 0, n, d);
    /* -INT64_MAX at least, on both sides: the magnitudes and the quotient's fit */
    int64_t size = fx_s64(fx_divide_u64(fx_u64(n < 0 ? -n : n), fx_u64(d < 0 ? -d : d)));
    return (n < 0) != (d < 0) ? -size : size;
}

uint32_t fx_root(uint32_t x)
{
    uint32_t r = 0;
    for (uint32_t bit = 1u << 15; bit; bit >>= 1)
        if ((r | bit) * (r | bit) <= x)
            r |= bit;
    return r;
}

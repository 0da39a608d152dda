/* SPDX-License-Identifier: MIT */
/*
 * raster/fine.c: every quotient up to 2^12 of a divisor up to 2^30, by a division of 18 bits.
 *
 *   proves: divide
 *   assumes: fx_divmod_floor
 *   lemmas: fine_divide
 *   options: -eva-precision 0 -eva-split-return full
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "fine.h"

volatile int32_t sink;

void prove(void)
{
    int32_t rest;
    //@ loop unroll 31;
    for (int bits = 0; bits <= 30; bits++) {
        const int32_t most = bits == 30 ? 1 << 30 : (2 << bits) - 1;
        sink = divide(any_s64(-((int64_t)most << 12), (int64_t)most << 12), any_s32(1 << bits, most), &rest);
    }
}

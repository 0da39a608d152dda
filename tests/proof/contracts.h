/* SPDX-License-Identifier: MIT */
/* What functions of firmware/fixed ask and give, proven by fixed.c and assumed by the proofs of what calls them. */
#ifndef CONTRACTS_H
#define CONTRACTS_H

#include "fixed/fixed.h"

/*@ requires m >= 0x80000000;
    assigns \result \from m;
    ensures \result >= 0x80000000; */
uint32_t fx_recip_norm(uint32_t m);

/*@ requires m >= 0x40000000;
    assigns \result \from m;
    ensures 0x40000000 < \result <= 0x80000000; */
uint32_t fx_rsqrt_norm(uint32_t m);

/*@ requires d > 0;
    assigns \result \from n, d;
    ensures quotient: \result == n / d; */
uint64_t fx_divide_u64(uint64_t n, uint64_t d);

/*@ assigns \result \from x_q16;
    ensures \result <= 65536; */
uint32_t fx_exp2_minus(uint32_t x_q16);

/*@ requires 1 <= bits && bits + down < 32;
    assigns \result \from x, bits, down;
    ensures \result < (1 << bits); */
static inline uint32_t fx_saturated(uint32_t x, unsigned bits, unsigned down);

#endif

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

#endif

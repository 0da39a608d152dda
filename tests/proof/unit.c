/* SPDX-License-Identifier: MIT */
/*
 * geometry/object.c: a unit vector of any vector, by the size of its largest component.
 *
 *   proves: object_unit
 *   assumes: fx_rsqrt_norm
 *   lemmas: unit
 *   options: -eva-precision 0 -eva-slevel 100 -eva-min-loop-unroll 3 -eva-split-return full -eva-subdivide-non-linear 4
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"
#include "objects.h"

#include "firmware/geometry/object.c"

/* The largest component is one of `bits` bits. */
static void vectors(int largest, int bits)
{
    const int32_t most = bits < 31 ? (1 << bits) - 1 : INT32_MAX, least = 1 << (bits - 1);
    q14_t out[3];
    //@ loop unroll 2;
    for (int negative = 0; negative < 2; negative++) {
        int32_t v[3] = {any_s32(-most, most), any_s32(-most, most), any_s32(-most, most)};
        v[largest] = negative ? any_s32(-most, -least) : any_s32(least, most);
        object_unit(v, out);
    }
}

void prove(void)
{
    const int32_t none[3] = {0, 0, 0};
    q14_t out[3];
    object_unit(none, out);
    //@ loop unroll 31;
    for (int bits = 1; bits <= 31; bits++) {
        vectors(0, bits);
        vectors(1, bits);
        vectors(2, bits);
    }
}

/* SPDX-License-Identifier: MIT */
/*
 * plan/curve.h: what six is off at most, of any dot products and bends within each band. That it is not below 0 where
 * it becomes a number without sign is the lemma's.
 *
 *   proves: curve_six
 *   lemmas: curve
 *   options: -eva-precision 0 -eva-slevel 50 -warn-unsigned-downcast -warn-signed-downcast -warn-unsigned-overflow
 */
#include "proof.h"

#include "firmware/plan/curve.c"

#define MOST 16388 /* a normal's length and a light's may be 2^-12 over 1 */

void prove(void)
{
    const struct curve_values v = {.high = any_s32(1, MOST), .low = any_s32(-MOST, MOST)};
    //@ loop unroll 4;
    for (int i = 0; i < CURVE_BANDS; i++) {
        const struct curve curve = {.bend = any_u32(i ? curve_bands[i - 1].most + 1 : 0, curve_bands[i].most),
                                    .lines = curve_bands[i].line};
        if (v.low <= v.high) {
            const int32_t six = curve_six(&curve, &v);
            //@ assert 2 <= six <= 16384;
        }
    }
}

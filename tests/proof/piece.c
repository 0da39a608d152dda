/* SPDX-License-Identifier: MIT */
/*
 * shade/piece.c: values and bulges of any piece, of weights that sum to 2^15 (shade/piece.h), which the lemma has.
 *
 *   proves: piece_linear piece_quadratic
 *   lemmas: piece
 *   options: -eva-precision 0 -eva-min-loop-unroll 3
 */
#include "proof.h"

#include "pieces.h"

#include "firmware/shade/piece.c"

void prove(void)
{
    uint16_t weight[3][3];
    int32_t value[3], bulge[3];
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            weight[k][i] = any_u32(0, 1 << 15);
        value[k] = any_s32(-32768, 32767);
    }
    piece_linear(weight, value);
    for (int k = 0; k < 3; k++) {
        value[k] = any_s32(-32768, 32767);
        bulge[k] = any_s32(-INT32_MAX, INT32_MAX);
    }
    piece_quadratic(weight, value, bulge);
}

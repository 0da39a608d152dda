/* SPDX-License-Identifier: MIT */
/* Pieces of what is quadratic by six samples: any values that piece.c shows, less what six_samples.smt2 does. */
#ifndef SIX_SAMPLES_H
#define SIX_SAMPLES_H

#include "pieces.h"

#include "proof.h"

/* In place of shade/piece.c: as piece.c shows, and what is asserted. */
void piece_quadratic(const uint16_t (*w)[3], int32_t value[3], int32_t bulge[3])
{
    //@ loop unroll 3;
    for (int k = 0; k < 3; k++) {
        value[k] = any_s32(-(1 << 20), 1 << 20);
        bulge[k] = any_s32(-INT32_MAX, INT32_MAX);
    }
    //@ assert short3(value);
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * shade/part.c: shapes and heights of parts at any three places, those without an area and those of one place too.
 *
 *   proves: shape_of height_of part_height
 *   assumes: scaled
 *   lemmas: part_shape
 *   options: -eva-precision 0 -eva-min-loop-unroll 3
 */
#include "proof.h"

#include "parts.h"

volatile int32_t sink;

void prove(void)
{
    struct part_place p[3];
    for (int k = 0; k < 3; k++) {
        p[k].x = any_s32(-(1 << 29), 1 << 29);
        p[k].y = any_s32(-(1 << 29), 1 << 29);
    }
    sink = part_height(p);
}

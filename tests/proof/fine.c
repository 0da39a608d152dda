/* SPDX-License-Identifier: MIT */
/*
 * raster/fine.c: any part of any triangle in any picture, from any row to any.
 *
 *   proves: fine_setup side centre_after fine_row
 *   assumes: edge_setup
 *   lemmas: fine
 *   options: -eva-precision 0 -eva-min-loop-unroll 3
 */
#include "proof.h"

#include "fine.h"

volatile int32_t sink;

void prove(void)
{
    struct edges e;
    struct part_place p[3];
    for (int k = 0; k < 3; k++) {
        p[k].x = any_s32(-(1 << 29), 1 << 29);
        p[k].y = any_s32(-(1 << 29), 1 << 29);
    }
    sink = fine_setup(&e, p, any_u32(1, 2048), any_u32(1, 2048), any_s32(0, 2048), any_s32(1, 2048));
    sink = fine_row(p[0].y, any_u32(1, 2048));
}

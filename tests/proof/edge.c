/* SPDX-License-Identifier: MIT */
/*
 * raster/edges.c: one edge, every start, direction and row that it crosses; the step from a row to the next, of
 * parts' edges (fine.c) too. Of `y` and `centre` the difference alone is used, which the contract bounds; so y is 0.
 *
 *   proves: edge_setup step
 *   assumes: fx_divmod_floor
 *   lemmas: edge
 *   options: -eva-precision 0
 */
#include "proof.h"

#include "edges.h"

#include "firmware/raster/edges.c"

void prove(void)
{
    struct edge e;
    uint32_t column = ANY_U32, rest = any_u32(0xc0000000u, UINT32_MAX);
    edge_setup(&e, any_s32(-0x8000, 0x8000), 0, any_s32(-0x8000, -1), any_s32(1, 0x8000), any_s32(0, 0x8000));
    edge_setup(&e, any_s32(-0x8000, 0x8000), 0, any_s32(0, 0x8000), any_s32(1, 0x8000), any_s32(0, 0x8000));
    e.den = any_s32(1, 1 << 30);
    e.rest_step = any_s32(0, (1 << 30) - 1);
    e.column_step = any_s32(-(1 << 30), 1 << 30);
    step(&column, &rest, &e);
}

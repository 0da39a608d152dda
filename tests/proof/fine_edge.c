/* SPDX-License-Identifier: MIT */
/*
 * raster/fine.c: one edge between places of 28.19, every start, direction and row that it crosses. Of `y` and `centre`
 * the difference alone is used, which the contract bounds; so y is 0.
 *
 *   proves: edge_setup
 *   assumes: divide fx_divmod_floor
 *   lemmas: fine_edge
 *   options: -eva-precision 0
 */
#include "proof.h"

#include "fine.h"

void prove(void)
{
    struct edge e;
    const int32_t most = 1 << 30;
    edge_setup(&e, any_s32(-most, most), 0, any_s32(-most, most), any_s32(1, most), any_s32(0, most));
}

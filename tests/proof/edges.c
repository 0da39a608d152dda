/* SPDX-License-Identifier: MIT */
/*
 * raster/edges.c: every triangle within the guard band, every picture and band; spans of up to four rows at a time,
 * every place of the turn and of the end, into memory that they fill.
 *
 *   proves: edges_setup rows edges_spans
 *   assumes: edge_setup step
 *   lemmas: edges
 *   options: -eva-precision 0 -eva-slevel 100
 */
#include "proof.h"

#include "edges.h"

#include "firmware/raster/edges.c"
#include "geometry/transform.h"

#define REACH (GUARD + 1) /* a corner that was cut may be rounded out */
#define ROWS  4

static void any_edge(struct edge *e)
{
    e->column = ANY_S32;
    e->column_step = any_s32(-(1 << 30), 1 << 30);
    e->den = any_s32(1, 1 << 30);
    e->rest = any_s32(0, (1 << 30) - 1);
    e->rest_step = any_s32(0, (1 << 30) - 1);
}

static void spans(int last, int middle, int turned)
{
    struct edges e = {.row = 0, .last = last, .middle = middle, .turned = turned};
    struct span out[ROWS];
    any_edge(&e.left);
    any_edge(&e.right);
    e.lower_is_left = any_flag();
    e.cut = any_flag();
    e.lower_x = any_s32(-0x8000, 0x8000);
    e.lower_y = any_s32(-0x8000, 0x8000);
    e.lower_dx = any_s32(-0x8000, 0x8000);
    e.lower_dy = any_s32(0, 0x8000);
    int count = edges_spans(&e, any_s32(1, 2048), out, ROWS);
    //@ assert count == (last < ROWS ? last : ROWS);
}

void prove(void)
{
    struct edges e;
    int16_t place[3][2];
    const int16_t *const p[3] = {place[0], place[1], place[2]};
    for (int i = 0; i < 3; i++) {
        place[i][0] = any_s32(-REACH, REACH);
        place[i][1] = any_s32(-REACH, REACH);
    }
    edges_setup(&e, p, any_u32(1, 2048), any_u32(1, 2048), any_s32(0, 2047), any_s32(1, 2048));
    //@ loop unroll 6;
    for (int last = 1; last <= ROWS + 2; last++)
        //@ loop unroll 9;
        for (int middle = -1; middle <= last + 1; middle++) {
            //@ loop unroll 2;
            for (int turned = 0; turned < 2; turned++)
                spans(last, middle, turned);
        }
}

/* SPDX-License-Identifier: MIT */
/*
 * shade/part.c: places, weights and lengths of any part, the way to any other origin, and what is rounded on it.
 *
 *   proves: part_place part_weights size_of scaled length_of nearest move scale_up shifted_down scale_down rounded
 *   lemmas: part
 *   options: -eva-precision 0 -eva-slevel 70 -eva-min-loop-unroll 3
 */
#include "proof.h"

#include "parts.h"

volatile int32_t sink;

static void moves(void)
{
    struct polynomial p = {ANY_U32, ANY_U32, ANY_U32, ANY_U32, ANY_U32, ANY_U32};
    struct frame frame;
    frame.i = any_s32(-2048, 2048);
    frame.j = any_s32(-2048, 2048);
    frame.rest_x = any_s32(-(1 << 14), 1 << 14);
    frame.rest_y = any_s32(-(1 << 14), 1 << 14);
    move(&frame, &p);
    scale_up(&p, any_s32(0, 31));
    scale_down(&p, any_s32(1, 8));
}

void prove(void)
{
    int32_t pixel, sub, rest;
    int16_t place[3][3];
    uint16_t weight[3][3], out[3];
    struct shade_input in = {.place = {place[0], place[1], place[2]}};
    struct part_corner corner = {.weight = {any_u32(0, PART_ONE), any_u32(0, PART_ONE)}};
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            place[k][i] = any_s32(-16384, 16384);
            weight[k][i] = any_u32(0, PART_ONE);
        }
    sink = part_place(&in, &corner).x;
    part_weights(&in, &corner, out);
    in.weight = weight;
    part_weights(&in, &corner, out);
    moves();
    //@ loop unroll 14;
    for (int up = 0; up < 14; up++)
        sink = scaled(any_s32(1 - (1 << (14 - up)), (1 << (14 - up)) - 1), up, 0);
    //@ loop unroll 18;
    for (int down = 1; down <= 17; down++)
        sink = scaled(any_s32(-(1 << 30), 1 << 30), 0, down);
    sink = size_of(any_s32(-(1 << 30), 1 << 30));
    sink = length_of(any_s32(-32768, 32768), any_s32(-32768, 32768));
    sink = rounded(any_u32(0, 65535), any_s32(4, 8));
    //@ loop unroll 64;
    for (int32_t i = -32; i < 32; i++) /* places up to 2^30 on either side */
        nearest(any_s32(i * (1 << 25), i * (1 << 25) + (1 << 25) - 1), &pixel, &sub, &rest);
    nearest(1 << 30, &pixel, &sub, &rest);
}

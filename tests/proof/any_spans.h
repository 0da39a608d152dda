/* SPDX-License-Identifier: MIT */
/*
 * Any triangle that a loop of raster/spans.h may be given: any polynomials, any table, in a band of 5 x 3 pixels that
 * fills its memory. Every span of its rows is a case of its own, as the loops end by comparing addresses. Pixels stand
 * right behind depths: both are counted by one index, so that one too many of either leaves the memory at one end.
 */
#ifndef PROOF_SPANS_H
#define PROOF_SPANS_H

#include "proof.h"

/* It hides an addition from compilers, and is empty. */
#define __asm__(...)

#include "raster/spans.h"

#define SPANS_WIDTH 5
#define SPANS_ROWS  3
#define SPANS_FIRST 2 /* row of the picture */
#define SPANS_BASE  0x20000000u

static struct raster raster;
static uint32_t table[(sizeof(struct table) + 2 * TABLE_HIGHLIGHT * TABLE_DIFFUSE) / 4];
static struct fx_power power;
static struct span next;

/* In place of raster/edges.c: the row that is asked about. */
int edges_spans(struct edges *e, int width, struct span *out, int most)
{
    //@ assert width == SPANS_WIDTH && most == SPANS;
    out[0] = next;
    e->row++;
    return 1;
}

static struct object_state object;

static void any_raster(void)
{
    struct raster *r = &raster;
    r->width = SPANS_WIDTH;
    r->y0 = SPANS_FIRST;
    r->depth = (uint16_t *)SPANS_BASE;
    r->pixels = (uint8_t *)(SPANS_BASE + 2 * SPANS_WIDTH * SPANS_ROWS);
    r->palette.channels = 3;
    for (int i = 0; i < 3; i++)
        r->palette.top[i] = any_u32(1, 255);
    any_bytes(&r->setup.channel, sizeof r->setup.channel);
    any_bytes(&r->setup.depth, sizeof r->setup.depth);
    r->surface_table = 0;
    r->setup.plane.ox = any_s32(0, 2047);
    r->setup.plane.oy = any_s32(0, 2047);
    r->setup.diffuse_lights = any_flag();
    r->setup.specular_lights = any_flag();
    r->setup.quadratic = any_flag();
    r->setup.wide = any_flag();
    r->setup.plain = any_flag();
    for (int i = 0; i < 3; i++) {
        r->surface.base[i] = any_u32(0, 255u << 15);
        r->surface.light[0].diffuse[i] = any_u32(0, 255u << 8);
        r->surface.light[0].specular[i] = any_u32(0, 255u << 8);
    }
    r->input.object = &object;
    r->surface.highlights = any_flag();
    r->surface.ambient = any_u32(0, (255u << 7) + 64);
    r->surface.power = &power;
    power.exponent = any_u32(1, 1023);
    power.octave = any_u32(0, 7);
    for (unsigned i = 0; i < FX_POWER_STEPS + 2; i++)
        power.value[i] = any_u32(0, 32768);
    any_bytes(table, sizeof table);
}

/* Each row, each span. */
static void every_span(uint32_t (*draw)(struct raster *, struct edges *))
{
    //@ loop unroll 3;
    for (int row = SPANS_FIRST; row < SPANS_FIRST + SPANS_ROWS; row++)
        //@ loop unroll 6;
        for (int x0 = 0; x0 <= SPANS_WIDTH; x0++)
            //@ loop unroll 6;
            for (int x1 = 0; x1 <= SPANS_WIDTH; x1++) {
                struct edges e = {.row = row, .last = row + 1};
                any_raster();
                next = (struct span){x0, x1};
                draw(&raster, &e);
            }
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Loops of spans.h by hand for ARMv6-M, whose compilers keep four of a loop's words in memory: with every register in
 * use and the clamps' rare cases apart, an RGB565 pixel with diffuse light and highlight takes 29 cycles instead of 45
 * on a Cortex-M0+. The bits are the same. spans_thumb.c knows these offsets.
 */
#ifndef GLINT_SPANS_HAND_H
#define GLINT_SPANS_HAND_H

#include "raster/spans.h"

#if FX_NARROW && defined(__thumb__)
#define SPANS_BY_HAND 1
#else
#define SPANS_BY_HAND 0
#endif

struct spans_hand {
    const struct channel *channel; /* depth, N.L, N.H, one behind the other */
    const struct span *span, *last;
    uint8_t *row;             /* of the depth, its column 0 */
    uint32_t stride, j;       /* bytes a row; the row from the origin */
    uint32_t ox;              /* the origin's column */
    const uint16_t *table;    /* struct table's entries */
    uintptr_t to_pixels;      /* from a depth's address, in grey from half of it, to the pixel's */
    uint32_t covered, hidden; /* pixels, added to */
};
void spans_hand_diffuse(struct spans_hand *rows);
void spans_hand_both(struct spans_hand *rows);
void spans_hand_diffuse_quadratic(struct spans_hand *rows);
void spans_hand_both_quadratic(struct spans_hand *rows);
void spans_hand_grey(struct spans_hand *rows);
void spans_hand_grey_quadratic(struct spans_hand *rows);

static inline uint32_t spans_by_hand(struct raster *r, struct edges *e, const struct spans_look *look, int grey,
                                     void (*draw)(struct spans_hand *))
{
    const struct plane *plane = &r->setup.plane;
    const uint32_t stride = 2u * r->width;
    struct spans_hand rows = {.channel = &r->setup.depth,
                              .row = (uint8_t *)r->depth + (uint32_t)(e->row - r->y0) * stride,
                              .stride = stride,
                              .j = (uint32_t)(e->row - plane->oy),
                              .ox = (uint32_t)plane->ox,
                              .table = look->table,
                              .to_pixels = (uintptr_t)r->pixels - (uintptr_t)r->depth / (grey ? 2 : 1)};
    do {
        rows.span = r->span;
        rows.last = r->span + raster_spans(r, e);
        draw(&rows);
    } while (e->row < e->last);
    return rows.covered - rows.hidden;
}

#endif

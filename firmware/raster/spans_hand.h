/* SPDX-License-Identifier: MIT */
/*
 * Loops of spans.h by hand. For ARMv6-M, whose compilers keep four of a loop's words in memory: with every register in
 * use and the clamps' rare cases apart, an RGB565 pixel with diffuse light and highlight takes 29 cycles instead of 45
 * on a Cortex-M0+. For ARMv7-M those of grey, of which Duff's takes 27 instructions instead of 39. The bits are the
 * same. spans_thumb.c and spans_thumb2.c know these offsets.
 */
#ifndef GLINT_SPANS_HAND_H
#define GLINT_SPANS_HAND_H

#include "raster/spans.h"

/* The text: of ARMv6-M, of ARMv7-M, none. */
#if FX_NARROW && defined(__thumb__)
#define SPANS_BY_HAND 1
#elif defined(__ARM_ARCH_7M__) || defined(__ARM_ARCH_7EM__)
#define SPANS_BY_HAND 2
#else
#define SPANS_BY_HAND 0
#endif

struct spans_hand {
    const struct channel *channel; /* depth, N.L, N.H, one behind the other */
    const struct span *span, *last;
    uint8_t *row;          /* of the depth, on ARMv7-M of the pixels: its column 0 */
    uint32_t stride, j;    /* bytes a row; the row from the origin */
    uint32_t ox;           /* the origin's column */
    const uint16_t *table; /* struct table's entries */
    uintptr_t to_other;    /* from a depth's address, in grey from half of it, to the pixel's; on ARMv7-M from twice the
                              pixel's to the depth's */
    uint32_t covered, hidden; /* pixels, added to */
    uint32_t second;          /* lengths: twice the square's a; and as in struct spans_look, the foot negated */
    const uint16_t *inverse;
    uint32_t down, foot;
};
void spans_hand_diffuse(struct spans_hand *rows);
void spans_hand_both(struct spans_hand *rows);
void spans_hand_diffuse_quadratic(struct spans_hand *rows);
void spans_hand_both_quadratic(struct spans_hand *rows);
void spans_hand_grey(struct spans_hand *rows);
void spans_hand_grey_quadratic(struct spans_hand *rows);
void spans_hand_grey_lengths(struct spans_hand *rows);

/* `grey`, `lengths`: which of them `draw` is; constants. */
static inline uint32_t spans_by_hand(struct raster *r, struct edges *e, const struct spans_look *look, int grey,
                                     int lengths, void (*draw)(struct spans_hand *))
{
    const struct shade_setup *setup = &r->setup;
    const uintptr_t pixels = (uintptr_t)r->pixels, depth = (uintptr_t)r->depth;
    const int by_pixels = SPANS_BY_HAND == 2;
    const uint32_t stride = by_pixels ? r->width : 2u * r->width;
    struct spans_hand rows; /* not all of it 0 first, which compilers call memset() for, a triangle each */
    rows.channel = &setup->depth;
    rows.row = (uint8_t *)(by_pixels ? pixels : depth) + fx_u32(e->row - r->y0) * stride;
    rows.stride = stride;
    rows.j = fx_wrap_u32(e->row - setup->plane.oy);
    rows.ox = fx_u32(setup->plane.ox);
    rows.table = look->table;
    rows.to_other = by_pixels ? fx_wrap_sub(depth, 2 * pixels) : fx_wrap_sub(pixels, grey ? depth / 2 : depth);
    rows.covered = rows.hidden = 0;
    if (lengths) {
        rows.second = fx_wrap_shl(setup->channel[SHADE_SQUARE].p.a, 1);
        rows.inverse = spans_length;
        rows.down = look->down;
        rows.foot = fx_wrap_sub(0, look->foot);
    }
    do {
        rows.span = r->span;
        rows.last = r->span + raster_spans(r, e);
        draw(&rows);
    } while (e->row < e->last);
    return rows.covered - rows.hidden;
}

#endif

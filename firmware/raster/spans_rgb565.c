/* SPDX-License-Identifier: MIT */
/* Spans of RGB565: dot products through the colour table of the material. */
#include "raster/spans.h"
#include "raster/spans_hand.h"

#define BOTH (SPANS_DIFFUSE | SPANS_HIGHLIGHT)
SPANS_CASE(constant, 0)
SPANS_CASE(colours, SPANS_COLOUR)
SPANS_CASE(both_wide, BOTH | SPANS_QUADRATIC | SPANS_WIDE)
#if SPANS_BY_HAND == 1
#define diffuse(r, e, look)           spans_by_hand(r, e, look, 0, 0, spans_hand_diffuse)
#define diffuse_quadratic(r, e, look) spans_by_hand(r, e, look, 0, 0, spans_hand_diffuse_quadratic)
#define both(r, e, look)              spans_by_hand(r, e, look, 0, 0, spans_hand_both)
#define both_quadratic(r, e, look)    spans_by_hand(r, e, look, 0, 0, spans_hand_both_quadratic)
#else
SPANS_CASE(diffuse, SPANS_DIFFUSE)
SPANS_CASE(diffuse_quadratic, SPANS_DIFFUSE | SPANS_QUADRATIC)
SPANS_CASE(both, BOTH)
SPANS_CASE(both_quadratic, BOTH | SPANS_QUADRATIC)
#endif

uint32_t spans_rgb565_constant(struct raster *r, struct edges *e, uint32_t colour)
{
    const struct spans_look look = {.colour = colour};
    return constant(r, e, &look);
}

/* Fields of at most 6 bits: a Q24 step count and the rounding half stay below 2^30. */
uint32_t spans_rgb565_colours(struct raster *r, struct edges *e)
{
    const struct spans_look look = {0};
    return colours(r, e, &look);
}

uint32_t spans_rgb565_dots(struct raster *r, struct edges *e)
{
    struct shade_setup *setup = &r->setup;
    struct spans_look look = {.table = r->surface_table->entry};
    fx_wrap_inc(&setup->channel[0].p.f, 1u << 23); /* N.L rounded to the table's steps: half a step more */
    if (!shade_specular(setup)) {
        if (!setup->diffuse_lights)
            return spans_rgb565_constant(r, e, look.table[0]);
        return setup->quadratic ? diffuse_quadratic(r, e, &look) : diffuse(r, e, &look);
    }
    spans_highlight(r);
    if (setup->wide) {
        look.down = 23u - r->surface.power->octave;
        return both_wide(r, e, &look);
    }
    return setup->quadratic ? both_quadratic(r, e, &look) : both(r, e, &look);
}

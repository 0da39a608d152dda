/* SPDX-License-Identifier: MIT */
/* Spans of RGB888: N.L times each channel's diffuse light, and each channel's part of the table. */
#include "raster/spans.h"

#define BOTH (SPANS_RGB888 | SPANS_DIFFUSE | SPANS_HIGHLIGHT)
SPANS_CASE(constant, SPANS_RGB888)
SPANS_CASE(colours, SPANS_RGB888 | SPANS_COLOUR)
SPANS_CASE(diffuse, SPANS_RGB888 | SPANS_DIFFUSE | SPANS_QUADRATIC)
SPANS_CASE(both, BOTH | SPANS_QUADRATIC)
SPANS_CASE(both_wide, BOTH | SPANS_QUADRATIC | SPANS_WIDE)

uint32_t spans_rgb888_constant(struct raster *r, struct edges *e, uint32_t colour)
{
    const struct spans_look look = {.colour = colour};
    return constant(r, e, &look);
}

uint32_t spans_rgb888_colours(struct raster *r, struct edges *e)
{
    const struct spans_look look = {0};
    return colours(r, e, &look);
}

uint32_t spans_rgb888_dots(struct raster *r, struct edges *e)
{
    const struct shade_setup *setup = &r->setup;
    const struct spans_look look = {.table = r->surface_table->entry,
                                    .diffuse = r->surface.light[0].diffuse,
                                    .down = 30u - TABLE_BITS - r->surface.power->octave};
    if (!shade_specular(setup))
        return setup->diffuse_lights ? diffuse(r, e, &look)
                                     : spans_rgb888_constant(r, e, raster_colour(r, r->surface.base));
    spans_highlight(r);
    return setup->wide ? both_wide(r, e, &look) : both(r, e, &look);
}

/* SPDX-License-Identifier: MIT */
/* Finished colours at points, for the methods that interpolate them. */
#ifndef GLINT_COLOUR_H
#define GLINT_COLOUR_H

#include "shade/shade.h"

/* Dot products of all lights (a vertex record's) to a colour, Q8 steps, at most 255 * 2^8. */
void colour_finished(const struct surface *surface, const int16_t *lights_q14, uint16_t out[3]);

/* That of a source corner: made once a vertex and material, and kept with the vertex, unless in->colours is given. */
const uint16_t *colour_corner(const struct shade_input *in, int k);

/* Bits of the largest colour, Q8: 12, 14 or 16. */
static inline unsigned colour_bits(const struct surface *surface)
{
    uint32_t top = surface->top[0];
    if (surface_channels(surface) == 3)
        top |= surface->top[1] | surface->top[2];
    return 32u - 7u - fx_clz(top); /* Q15 there */
}

#endif

/* SPDX-License-Identifier: MIT */
#include "shade/colour.h"

void colour_finished(const struct surface *surface, const int16_t *lights_q14, uint16_t out[3])
{
    uint32_t colour[3];
    surface_shade(surface, lights_q14, colour);
    for (unsigned c = 0; c < surface_channels(surface); c++)
        out[c] = fx_u16(colour[c] >> 7);
}

const uint16_t *colour_corner(const struct shade_input *in, int k)
{
    const struct surface *s = in->surface;
    if (in->colours) {
        colour_finished(s, in->lights[k], in->colours[k]);
        return in->colours[k];
    }
    uint16_t *kept = (uint16_t *)in->lights[k] + 2 * surface_lights(s);
    const uint16_t tag = fx_u16(in->triangle->material + 1u);
    if (kept[3] != tag) {
        colour_finished(s, in->lights[k], kept);
        kept[3] = tag;
    }
    return kept;
}

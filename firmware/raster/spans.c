/* SPDX-License-Identifier: MIT */
#include "raster/spans.h"

FX_WRAPS void spans_highlight(struct raster *r)
{
    struct shade_setup *setup = &r->setup;
    struct polynomial *p = &setup->channel[1].p;
    const unsigned octave = r->surface.power->octave;
    if (!setup->diffuse_lights)
        setup->channel[0].p = (struct polynomial){0}; /* a highlight alone: the loops read both */
    p->f += (1u << (30 - octave)) - (1u << 30);
    if (setup->wide || !r->surface_table)
        return;
    p->f <<= octave;
    p->d <<= octave;
    p->e <<= octave;
    if (!setup->quadratic)
        return;
    p->a <<= octave;
    p->b <<= octave;
    p->c <<= octave;
}

/* SPDX-License-Identifier: MIT */
#include "raster/spans.h"

void spans_highlight(struct raster *r)
{
    struct shade_setup *setup = &r->setup;
    struct polynomial *p = &setup->channel[1].p;
    const unsigned octave = r->surface.power->octave;
    if (!setup->diffuse_lights)
        setup->channel[0].p = (struct polynomial){0}; /* a highlight alone: the loops read both */
    fx_wrap_inc(&p->f, fx_wrap_sub(1u << (30 - octave), 1u << 30));
    if (setup->wide || !r->surface_table)
        return;
    p->f = fx_wrap_shl(p->f, octave);
    p->d = fx_wrap_shl(p->d, octave);
    p->e = fx_wrap_shl(p->e, octave);
    if (!setup->quadratic)
        return;
    p->a = fx_wrap_shl(p->a, octave);
    p->b = fx_wrap_shl(p->b, octave);
    p->c = fx_wrap_shl(p->c, octave);
}

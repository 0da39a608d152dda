/* SPDX-License-Identifier: MIT */
/*
 * Colour tables: for RGB565 under one light, the finished colour of every pair (N.L, N.H) in steps fine enough not to
 * be seen, so that clamp, power, sum and packing of a pixel are one load.
 *
 * N.L is in steps of 1/64, entry i for [i - 1/2, i + 1/2) / 64; N.H in steps of 2^-(7 + octave) over the part of [0, 1]
 * where the power shows, entry j likewise, entry 0 for everything below.
 */
#include "raster/raster.h"

static int same_surface(const struct surface *a, const struct surface *b)
{
    if (a->power->exponent != b->power->exponent)
        return 0;
    for (int c = 0; c < 3; c++)
        if (a->base[c] != b->base[c] || a->light[0].diffuse[c] != b->light[0].diffuse[c] ||
            a->light[0].specular[c] != b->light[0].specular[c])
            return 0;
    return 1;
}

static void make(struct raster *r, struct colour_table *table)
{
    const struct surface *s = &r->surface;
    table->surface = *s;
    for (uint32_t j = 0; j < TABLE_HIGHLIGHT; j++) {
        /* N.H = 1 - 2^-octave (128 - j) / 128 */
        uint32_t power = j ? fx_power(s->power, (q30_t)((1u << 30) - ((128u - j) << (23 - s->power->octave)))) : 0;
        for (uint32_t i = 0; i < TABLE_DIFFUSE; i++) {
            uint32_t sum[3];
            for (int c = 0; c < 3; c++)
                sum[c] = s->base[c] + surface_diffuse(i << 9, s->light[0].diffuse[c]) +
                         surface_diffuse(power, s->light[0].specular[c]);
            table->colour[j][i] = (uint16_t)raster_colour(r, sum);
        }
    }
    table->ready = 1;
}

void raster_find_table(struct raster *r)
{
    struct colour_table *table = r->table;
    r->surface_table = 0;
    if (r->format != GLINT_RGB565 || r->dither || r->surface.lights != 1)
        return;
    for (unsigned i = 0; i < r->tables && !r->surface_table; i++, table++) {
        if (!table->ready)
            make(r, table);
        if (same_surface(&table->surface, &r->surface))
            r->surface_table = table;
    }
}

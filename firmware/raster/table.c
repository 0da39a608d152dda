/* SPDX-License-Identifier: MIT */
/*
 * Colour tables: for RGB565 under one light, the finished colour of every pair (N.L, N.H) in steps fine enough not to
 * be seen, so that clamp, power, sum and packing of a pixel are one load.
 *
 * N.L is in steps of 1/64, entry i for [i - 1/2, i + 1/2) / 64; N.H in steps of 2^-(7 + octave) over the part of [0, 1]
 * where the power shows, each entry standing for its middle, entry 0 for nothing. Both clamps are to powers of 2 less
 * 1, which ARMv7-M does in an instruction.
 */
#include "raster/raster.h"

static int made_for(const struct colour_table *table, const struct surface *s)
{
    int same = table->exponent == s->power->exponent;
    for (int c = 0; c < 3; c++)
        same &= table->base[c] == s->base[c] && table->diffuse[c] == s->light[0].diffuse[c] &&
                table->specular[c] == s->light[0].specular[c];
    return same;
}

/* N.L of an entry in Q15; the last stands for all from its lower bound to 1, and takes their middle. */
static uint32_t diffuse_of(uint32_t i)
{
    return i < TABLE_DIFFUSE - 1 ? i << 9 : (i << 9) + (1u << 7);
}

static void make(struct raster *r, struct colour_table *table)
{
    const struct surface *s = &r->surface;
    for (int c = 0; c < 3; c++) {
        table->base[c] = s->base[c];
        table->diffuse[c] = s->light[0].diffuse[c];
        table->specular[c] = s->light[0].specular[c];
    }
    table->exponent = s->power->exponent;
    for (uint32_t j = 0; j < TABLE_HIGHLIGHT; j++) {
        /* N.H in the middle of its step: 1 - 2^-octave (128 - j - 1/2) / 128 */
        uint32_t power = j ? surface_power(s, (q30_t)((1u << 30) - ((255u - 2 * j) << (22 - s->power->octave)))) : 0;
        for (uint32_t i = 0; i < TABLE_DIFFUSE; i++) {
            uint32_t sum[3];
            for (int c = 0; c < 3; c++)
                sum[c] = s->base[c] + surface_diffuse(diffuse_of(i), s->light[0].diffuse[c]) +
                         surface_diffuse(power, s->light[0].specular[c]);
            table->colour[j][i] = (uint16_t)raster_colour(r, sum);
        }
    }
}

void raster_find_table(struct raster *r)
{
    struct colour_table *table = r->table + r->surface_material;
    r->surface_table = 0;
    if (r->surface_material >= r->tables || !raster_is(r, GLINT_RGB565) || raster_dithers(r) ||
        surface_lights(&r->surface) != 1)
        return;
    if (!made_for(table, &r->surface))
        make(r, table);
    r->surface_table = table;
}

/* SPDX-License-Identifier: MIT */
/*
 * Tables of one material under the scene's first light, made once; of triangles that no other light reaches.
 *
 * RGB565: the finished colour of every pair (N.L, N.H) in steps fine enough not to be seen, so that clamp, power, sum
 * and packing of a pixel are one load. N.L is in steps of 1/64, entry i for [i - 1/2, i + 1/2) / 64; N.H in steps of
 * 2^-(7 + octave) over the part of [0, 1] where the power shows, each entry standing for its middle, entry 0 for
 * nothing. Both clamps are to powers of 2 less 1, which ARMv7-M does in an instruction.
 *
 * GREY8 and RGB888: the ambient part with the rounding half, and the highlight, in Q7 steps, by N.H alone, in steps of
 * 2^-(TABLE_BITS + octave).
 *
 * What a table costs in accuracy, in 1/255 before rounding, for the largest kd and ks times colours and light: N.L errs
 * by half a step, at most 1/128 (at the end, where the last entry takes the middle of [63/64 - 1/128, 1], by 1/85.3),
 * N.H by half a step times the power's steepest slope, n. As octave is the largest with (1 - 2^-octave)^n < 2^-9, n
 * 2^-octave < 12.5 (n = 1: 1; n <= 1023: 8 and more at octave 7), and entry 0 leaves out less than 2^-9 and a step:
 *     RGB565   255 (kd / 85 + ks n 2^-octave / 256) < 3 kd + 12.5 ks
 *     others   255 ks n 2^-octave / 2048            < 1.56 ks
 */
#include "raster/raster.h"

static int made_for(const struct table *table, const struct surface *s)
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

static void make_colours(struct raster *r, uint16_t *entry)
{
    const struct surface *s = &r->surface;
    for (uint32_t j = 0; j < TABLE_HIGHLIGHT; j++) {
        /* N.H in the middle of its step: 1 - 2^-octave (128 - j - 1/2) / 128 */
        uint32_t power = j ? surface_power(s, fx_s32((1u << 30) - ((255u - 2 * j) << (22 - s->power->octave)))) : 0;
        for (uint32_t i = 0; i < TABLE_DIFFUSE; i++) {
            uint32_t sum[3];
            for (int c = 0; c < 3; c++)
                sum[c] = s->base[c] + surface_diffuse(diffuse_of(i), s->light[0].diffuse[c]) +
                         surface_diffuse(power, s->light[0].specular[c]);
            *entry++ = fx_u16(raster_colour(r, sum));
        }
    }
}

/* Entries of channel c, `apart` numbers from one to the next: each in the middle of its step, linear between the
 * power's own steps. Ambient part and highlight are at most 255 steps each: in Q7 with the rounding half below 2^16. */
static void make_highlights(const struct surface *s, unsigned c, uint16_t *entry, unsigned apart)
{
    const unsigned bits = TABLE_BITS - 7; /* FX_POWER_STEPS are 2^7 */
    const uint32_t specular = s->light[0].specular[c], ambient = (s->base[c] >> 8) + (1 << 6);
    uint16_t *const first = entry;
    for (unsigned i = 0; i < FX_POWER_STEPS; i++) {
        const uint32_t low = s->power->value[i] * specular; /* Q23 steps, at most 255 */
        const uint32_t rise = s->power->value[i + 1] * specular - low, step = rise >> bits;
        uint32_t value = low + (step >> 1) + (1u << 15);
        for (unsigned k = 0; k < 1u << bits; k++, entry += apart, value += step)
            *entry = fx_u16(ambient + (value >> 16));
    }
    *first = fx_u16(ambient);
}

static void make(struct raster *r, struct table *table)
{
    const struct surface *s = &r->surface;
    for (int c = 0; c < 3; c++) {
        table->base[c] = s->base[c];
        table->diffuse[c] = s->light[0].diffuse[c];
        table->specular[c] = s->light[0].specular[c];
    }
    table->exponent = s->power->exponent;
    if (raster_is(r, GLINT_RGB565)) {
        make_colours(r, table->entry);
        return;
    }
    const unsigned channels = surface_channels(s);
    for (unsigned c = 0; c < channels; c++)
        make_highlights(s, c, table->entry + c, channels == 1 ? 1 : 4);
}

uint32_t table_bytes(unsigned format)
{
    const uint32_t head = sizeof(struct table);
    if (uses_format(format, GLINT_RGB565))
        return head + 2 * TABLE_HIGHLIGHT * TABLE_DIFFUSE;
    if (uses_format(format, GLINT_GREY8))
        return head + (2 << TABLE_BITS);
    return uses_format(format, GLINT_RGB888) ? head + (8 << TABLE_BITS) : 0;
}

static struct table *table_at(const struct raster *r, unsigned material)
{
    return (struct table *)(void *)((uint8_t *)r->table + material * table_bytes(r->format));
}

void table_clear(struct raster *r)
{
    for (unsigned i = 0; i < r->tables; i++)
        table_at(r, i)->exponent = 0;
}

void table_find(struct raster *r)
{
    r->surface_table = 0;
    if (r->surface_material >= r->tables || raster_dithers(r) || !surface_lights(&r->surface) || raster_effects(r) ||
        (!raster_is(r, GLINT_RGB565) && surface_form(&r->surface)))
        return;
    struct table *table = table_at(r, r->surface_material);
    if (!made_for(table, &r->surface))
        make(r, table);
    r->surface_table = table;
}

uint16_t table_error(const struct raster *r)
{
    const struct surface *s = &r->surface;
    const unsigned colours = raster_is(r, GLINT_RGB565), down = s->power->octave + (colours ? 8u : TABLE_BITS + 1u);
    uint32_t most = 0;
    for (unsigned c = 0; r->surface_table && c < surface_channels(s); c++) {
        /* at most 2^8 each of what is over top; n < 2^10: below 2^26, and n 2^-octave < 12.5: below 2^12 in all */
        const uint32_t top = r->palette.top[c];
        const uint32_t error = (colours ? 3u * s->light[0].diffuse[c] / top : 0) +
                               ((255u * s->light[0].specular[c] / top * s->power->exponent) >> down) + 1;
        most = error > most ? error : most;
    }
    return fx_u16(most);
}

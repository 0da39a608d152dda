/* SPDX-License-Identifier: MIT */
/*
 * A finished pixel by definition, given a triangle's set-up (channels, what shows) and its surface: each channel's
 * value from its whole polynomial, then clamp, power, sum and format as spans.h, table.c, steps.h and surface.h have
 * them, in 64 bits, a pixel at a time. No spans, runs, masks or differences.
 */
#ifndef EXACT_PIXEL_H
#define EXACT_PIXEL_H

#include "exact.h"
#include "raster/spans.h"

struct exact_pixel {
    uint16_t depth;
    uint32_t level[3];
};

static inline int64_t exact_between(int64_t v, int64_t low, int64_t high)
{
    return v < low ? low : v > high ? high : v;
}

/* floor(v / 2^down) */
static inline int64_t exact_floor(int64_t v, int down)
{
    const int64_t unit = INT64_C(1) << down;
    return v >= 0 ? v / unit : -((unit - 1 - v) / unit);
}

static inline int32_t exact_channel(const struct shade_setup *s, const struct channel *channel, int x, int y)
{
    int32_t value;
    if (!channel->exact)
        return (int32_t)exact_at(&channel->p, x - s->plane.ox, y - s->plane.oy);
    plane_values(&s->plane, channel, x, y, 1, &value);
    return value;
}

/* s^n in Q15: 0 below the table's foot, linear between its steps, the way from one to the next in 2^15ths. */
static inline int64_t exact_power(const struct fx_power *table, int64_t s)
{
    const int64_t one = 1 << 30, span = one >> table->octave, above = (s - (one - span)) * FX_POWER_STEPS;
    if (s >= one)
        return 32768;
    if (above < 0)
        return 0;
    const uint16_t *v = &table->value[above / span];
    return v[0] + (v[1] - v[0]) * (above % span * 32768 / span) / 32768;
}

/* Q15 steps to a level; without dither the threshold is half a step. */
static inline uint32_t exact_level(int64_t sum, int x, int y, int dither, uint8_t top)
{
    static const int bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    return (uint32_t)exact_between((sum * 32 + (dither ? (2 * bayer[y & 3][x & 3] + 1) << 15 : 1 << 19)) >> 20, 0, top);
}

/* What a pixel has under its lights: N.L and N.H in Q30 (0: does not show) where in_steps is 0; else N.L of the first
 * in Q22 steps. */
struct exact_dots {
    int32_t l[SCENE_MAX_LIGHTS], h[SCENE_MAX_LIGHTS];
    int has_l[SCENE_MAX_LIGHTS], has_h[SCENE_MAX_LIGHTS];
};

static inline struct exact_dots exact_dots(const struct shade_setup *s, int x, int y, unsigned lights)
{
    struct exact_dots d = {.has_l = {0}};
    for (unsigned i = 0; i < lights; i++) {
        d.has_l[i] = s->diffuse_lights >> i & 1;
        d.has_h[i] = s->specular_lights >> i & 1;
        if (d.has_l[i])
            d.l[i] = exact_channel(s, &s->channel[2 * i], x, y);
        if (d.has_h[i])
            d.h[i] = exact_channel(s, &s->channel[2 * i + 1], x, y);
    }
    return d;
}

/* Sums over all lights, Q15 steps. */
static inline void exact_sums(const struct surface *s, const struct exact_dots *d, int64_t sum[3])
{
    for (unsigned c = 0; c < s->channels; c++) {
        sum[c] = s->base[c];
        for (unsigned i = 0; i < s->lights; i++) {
            if (d->has_l[i])
                sum[c] += exact_floor(exact_between(d->l[i], 0, INT32_MAX) / 32768 * s->light[i].diffuse[c], 8);
            if (d->has_h[i])
                sum[c] += exact_floor(exact_power(s->power, d->h[i]) * s->light[i].specular[c], 8);
        }
    }
}

/* N.H's place above the power's foot in 2^bits steps of the way to 1. */
static inline int64_t exact_place(const struct fx_power *power, int64_t h, int bits)
{
    const int64_t foot = (INT64_C(1) << 30) - (INT64_C(1) << (30 - power->octave));
    return exact_between(exact_floor(h - foot, 30 - bits - power->octave), 0, (1 << bits) - 1);
}

/* GREY8 under one light: Q7 steps, the rounding half in the ambient part. */
static inline uint32_t exact_grey(const struct surface *s, const struct table *table, int has_h, int64_t diffuse_q7,
                                  int64_t h)
{
    int64_t sum = s->ambient;
    if (has_h && table)
        sum = table->entry[exact_place(s->power, h, TABLE_BITS)];
    else if (has_h)
        sum += exact_floor(exact_power(s->power, exact_between(h, INT32_MIN, (1 << 30) - 1)) * s->light[0].specular[0],
                           16);
    return (uint32_t)exact_between(exact_floor(sum + diffuse_q7, 7), 0, 255);
}

/* Duff straight into grey: both over the normal's length, of which the table has reciprocals in Q15 by 1 - |N|^2. */
static inline uint32_t exact_grey_length(const struct raster *r, const struct shade_setup *setup,
                                         const struct exact_dots *d, int x, int y)
{
    const struct surface *s = &r->surface;
    const int64_t square = exact_channel(setup, &setup->channel[SHADE_SQUARE], x, y),
                  by = spans_length[exact_between(exact_floor(square, 18), 0, 1023)],
                  diffuse = exact_floor(exact_between(exact_floor(d->l[0], 15), 0, 32767) * by, 15);
    /* N.H is rounded to 15 bits below the span of the power's table, or of 1 */
    const int down = r->surface_table && !setup->wide ? 15 - s->power->octave : 15;
    const int64_t h = exact_floor((int64_t)d->h[0] + (1 << (down - 1)), down) * by >> (15 - down);
    if (d->has_l[0] || d->has_h[0])
        return exact_grey(s, r->surface_table, d->has_h[0], diffuse, h);
    return s->ambient >> 7;
}

/* Duff's dot products over the normal's length, whose square is in Q30: by the reciprocal of its root in Q30 (given: a
 * unit in 2^19.6 off), of which the quotient drops what is below 4 units. */
static inline void exact_divide(const struct shade_setup *setup, struct exact_dots *d, unsigned lights, int x, int y)
{
    int64_t square = exact_channel(setup, &setup->channel[SHADE_SQUARE], x, y);
    int up = 0;
    square = square < 1 << 12 ? 1 << 12 : square;
    while (square << 2 * up < 1 << 30)
        up++;
    const int64_t inverse = fx_rsqrt_norm((uint32_t)(square << 2 * up)) >> 1;
    for (unsigned i = 0; i < lights; i++) {
        d->l[i] = (int32_t)(exact_floor((int64_t)d->l[i] * (1 << up) * inverse, 32) * 4);
        d->h[i] = (int32_t)(exact_floor((int64_t)d->h[i] * (1 << up) * inverse, 32) * 4);
    }
}

static inline void exact_dots_pixel(const struct raster *r, const struct shade_setup *setup, enum glint_method_id id,
                                    int x, int y, uint32_t level[3])
{
    const struct surface *s = &r->surface;
    struct exact_dots d = exact_dots(setup, x, y, s->lights);
    const struct table *table = r->surface_table;
    const int alone = (setup->diffuse_lights | setup->specular_lights) <= 1;
    const int64_t lit = exact_between(d.l[0], 0, INT32_MAX), clamped = exact_between(d.l[0] >> 15, 0, 65535);
    int64_t sum[3];
    if (id == GLINT_DUFF && !setup->length) {
        exact_divide(setup, &d, s->lights, x, y);
        exact_sums(s, &d, sum);
    } else if (alone && s->fold && setup->runs_only &&
               !setup->length) { /* Q15 steps: a sliver's corners, or N.H beyond what loops hold */
        sum[0] = s->base[0] + lit / 128;
        if (d.has_h[0])
            sum[0] += exact_floor(exact_power(s->power, d.h[0]) * s->light[0].specular[0], 8);
    } else if (setup->length) {
        level[0] = exact_grey_length(r, setup, &d, x, y);
        return;
    } else if (alone && s->fold) {
        level[0] = exact_grey(s, table, d.has_h[0], clamped, d.h[0]);
        return;
    } else if (alone && table && r->format == GLINT_RGB565) {
        const int64_t row = d.has_h[0] ? exact_place(s->power, d.h[0], 7) : 0,
                      column = exact_between(exact_floor((int64_t)d.l[0] + (1 << 23), 24), 0, 63);
        const uint16_t colour = table->entry[row * TABLE_DIFFUSE + column];
        level[0] = colour >> 11;
        level[1] = colour >> 5 & 63;
        level[2] = colour & 31;
        return;
    } else if (alone && table && r->format == GLINT_RGB888 && !setup->runs_only && (d.has_l[0] || d.has_h[0])) {
        const uint16_t *entry = table->entry + 4 * (d.has_h[0] ? exact_place(s->power, d.h[0], TABLE_BITS) : 0);
        for (int c = 0; c < 3; c++)
            level[c] = (uint32_t)exact_between(
                exact_floor(entry[c] + exact_floor(clamped * s->light[0].diffuse[c], 16), 7), 0, 255);
        return;
    } else {
        exact_sums(s, &d, sum);
    }
    for (unsigned c = 0; c < s->channels; c++)
        level[c] = exact_level(sum[c], x, y, r->dither, r->palette.top[c]);
}

/* flat, gouraud, x, six and duff. */
static inline struct exact_pixel exact_pixel(const struct raster *r, const struct shade_setup *setup,
                                             enum glint_method_id id, int x, int y)
{
    struct exact_pixel pixel = {.depth = (uint16_t)((uint32_t)exact_channel(setup, &setup->depth, x, y) >> 16)};
    if (id != GLINT_FLAT && id != GLINT_GOURAUD) {
        exact_dots_pixel(r, setup, id, x, y, pixel.level);
        return pixel;
    }
    for (unsigned c = 0; c < r->surface.channels; c++) {
        uint32_t steps_q24 = setup->flat[c] << 9;
        if (id == GLINT_GOURAUD) /* a rounding below 0 is 0 */
            steps_q24 = (uint32_t)exact_channel(setup, &setup->channel[c], x, y);
        pixel.level[c] = exact_level(steps_q24 >= 0xff800000u ? 0 : steps_q24 >> 9, x, y, r->dither, r->palette.top[c]);
    }
    return pixel;
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * The spans of a triangle in one pass: depth test, value, store. A template, of which each case is a function of its
 * own: spans_draw() with a constant `kind`, one bit of the output's format and those of what stands at a pixel.
 *
 * Depth and channels are stepped by differences from exact values at each span's first pixel, modulo 2^32, so that a
 * pixel depends on its triangle and place alone. A linear case carries what a row begins with from row to row; for
 * quadratic ones that would cost more than it saves, as half of a dense mesh's rows hold no pixel.
 *
 * What channels count in, where kind has
 *   SPANS_COLOUR     finished colours, Q24 steps
 *   RGB565           N.L in Q30 from half a table's step before 0
 *   GREY8            N.L in Q22 steps of the output (shade/steps.h)
 *   RGB888           N.L in Q30
 *   SPANS_HIGHLIGHT  N.H from the foot of the power, in Q30 of the span from there to 1 within [-2, 2), or with
 *                    SPANS_WIDE in Q30
 *   SPANS_LENGTH     N.L and N.H are to be divided by the normal's length, whose square channel SHADE_SQUARE holds less
 *                    than 1: 1 - |N|^2 in Q30, below 1/4
 *   SPANS_NORMAL     the normal's components in Q30, linear, between normals at most 90 degrees apart
 */
#ifndef GLINT_SPANS_H
#define GLINT_SPANS_H

#include "raster/normals.h"
#include "raster/raster.h"

enum spans_kind {
    /* the format: 565, or */
    SPANS_GREY8 = 1,
    SPANS_RGB888 = 2,
    /* the pixel: one colour, or */
    SPANS_COLOUR = 4,     /* finished colours, stepped */
    SPANS_PLAIN = 8,      /* grey: N.L, ambient part included, nowhere outside the format */
    SPANS_DIFFUSE = 16,   /* N.L, clamped below */
    SPANS_HIGHLIGHT = 32, /* N.H by the material's table */
    SPANS_QUADRATIC = 64, /* any of them bends */
    SPANS_WIDE = 128,     /* see above */
    SPANS_POWER = 256,    /* grey: N.H, in Q30, by the scene's power table: no memory */
    SPANS_LENGTH = 512,   /* grey: both over the length of the normal */
    SPANS_NORMAL = 1024,  /* grey: both of the normal in the channels, made unit: the bits are those of normals_run() */
};

/* Whether channel 1 is stepped, and whether the third (blue, or SHADE_SQUARE). */
#define SPANS_H(kind) \
    (((kind) & (SPANS_HIGHLIGHT | SPANS_NORMAL)) != 0 || (((kind)&SPANS_COLOUR) != 0 && ((kind)&SPANS_GREY8) == 0))
#define SPANS_C(kind) \
    (((kind) & (SPANS_LENGTH | SPANS_NORMAL)) != 0 || (((kind)&SPANS_COLOUR) != 0 && ((kind)&SPANS_GREY8) == 0))

/* What pixels are made of besides channels. */
struct spans_look {
    const uint16_t *table;   /* struct table's entries; SPANS_POWER: the power's */
    const uint16_t *diffuse; /* RGB888: Q8 steps of each channel */
    uint32_t colour;         /* one colour; else grey: the ambient part with the rounding half, Q7 steps */
    uint32_t specular;       /* SPANS_POWER: Q8 steps */
    uint32_t foot;           /* SPANS_LENGTH: of the power, Q30; times 2^octave unless wide or by the power */
    unsigned down;           /* of N.H in Q30 to steps of the table; SPANS_LENGTH in its place: to Q15 times 2^octave */
    const struct spans_light *light; /* SPANS_NORMAL */
};

/* The light in the object's axes, and what the surface makes of it: Q15 steps and Q8 steps. */
struct spans_light {
    q14_t towards[3], half[3];
    int32_t shortness; /* normals_shortness(half) */
    uint32_t base;
    uint16_t diffuse, specular;
    const struct fx_power *power;
};

/* Values at the first pixel, first differences, and second ones (0 where linear). c: blue, or 1 - |N|^2. */
struct spans_values {
    uint32_t z, l, h, c, dz, dl, dh, dc, al, ah, ac;
};

/* 1 / sqrt(1 - s) in Q15 in the middle of each of 2^10 steps of s in [0, 1/4). */
#define SPANS_LENGTH_BITS 10
extern const uint16_t spans_length[1 << SPANS_LENGTH_BITS];

static inline __attribute__((always_inline)) uint32_t spans_normal(const struct spans_values *v,
                                                                   const struct spans_light *light)
{
    /* Q15; |N|^2 in [1/3, 1 + 2^-12] */
    const int32_t x = fx_wrap_s32(v->l) >> 15, y = fx_wrap_s32(v->h) >> 15, z = fx_wrap_s32(v->c) >> 15;
    const struct normals_vector normal = normals_vector(x, y, z, fx_u32(x * x + y * y + z * z));
    const q30_t l = normals_dot(&normal, light->towards), h = normals_dot(&normal, light->half);
    uint32_t sum = light->base;
    if (l > 0)
        sum += surface_diffuse(fx_u32(l) >> 15, light->diffuse);
    if (h > 0)
        sum += surface_diffuse(fx_power(light->power, normals_lengthened(h, light->shortness)), light->specular);
    sum = (sum + (1u << 14)) >> 15;
    return sum < 255 ? sum : 255;
}

static inline __attribute__((always_inline)) uint32_t spans_grey(const struct spans_values *v,
                                                                 const struct spans_look *look, unsigned kind)
{
    if (kind & SPANS_COLOUR)
        return v->l >> 24;
    if (kind & SPANS_PLAIN)
        return v->l >> 22;
    if (kind & SPANS_NORMAL)
        return spans_normal(v, look->light);
    uint32_t sum = look->colour;
    if (!(kind & (SPANS_DIFFUSE | SPANS_HIGHLIGHT)))
        return sum;
    uint32_t h = v->h, by = 0;
    if (kind & SPANS_LENGTH) {
        by = spans_length[fx_saturated(v->c, SPANS_LENGTH_BITS, 28 - SPANS_LENGTH_BITS)];
        if (kind &
            (SPANS_WIDE | SPANS_POWER)) /* the quotient is at least -1, the foot below 1: within [-2, 2) in Q30 */
            h = fx_wrap_sub(fx_wrap_mul(fx_wrap_u32(fx_wrap_s32(h) >> 15), by), look->foot);
        else if (kind & SPANS_HIGHLIGHT) /* modulo 2^32 */
            h = fx_wrap_sub(fx_wrap_mul(fx_wrap_u32(fx_wrap_s32(h) >> look->down), by), look->foot);
    }
    if (kind & SPANS_POWER) { /* powers are at most 2^15, the step's light below 2^16; the product in Q7 steps */
        const uint32_t t = fx_saturated(fx_wrap_u32(fx_wrap_s32(h) >> look->down), 22, 0);
        const uint16_t *p = &look->table[t >> 15];
        const uint32_t power = p[0] + (fx_u32(p[1] - p[0]) * (t & 0x7fff) >> 15);
        sum += (power * look->specular >> 16) & ~fx_wrap_u32(fx_wrap_s32(h) >> 31); /* none below the foot */
    } else if (kind & SPANS_WIDE) {
        sum = look->table[fx_saturated(fx_wrap_u32(fx_wrap_s32(h) >> look->down), TABLE_BITS, 0)];
    } else if (kind & SPANS_HIGHLIGHT) {
        sum = look->table[fx_saturated(h, TABLE_BITS, 30 - TABLE_BITS)];
    }
    if (kind & SPANS_LENGTH) /* below 2^15 * 2^15.3 */
        sum += fx_saturated(v->l, 15, 15) * by >> 15;
    else if (kind & SPANS_DIFFUSE)
        sum += fx_saturated(v->l, 16, 15);
    return fx_saturated(sum, 8, 7);
}

static inline __attribute__((always_inline)) uint32_t spans_rgb565(const struct spans_values *v,
                                                                   const struct spans_look *look, unsigned kind)
{
    if (kind & SPANS_COLOUR)
        return v->l >> 24 << 11 | v->h >> 24 << 5 | v->c >> 24;
    if (!(kind & SPANS_DIFFUSE))
        return look->colour;
    const uint16_t *entry = look->table;
    if (kind & SPANS_WIDE)
        entry += fx_saturated(fx_wrap_u32(fx_wrap_s32(v->h) >> look->down), 7, 0) * TABLE_DIFFUSE;
    else if (kind & SPANS_HIGHLIGHT)
        entry += fx_saturated(v->h, 7, 23) * TABLE_DIFFUSE;
    return entry[fx_saturated(v->l, 6, 24)];
}

static inline __attribute__((always_inline)) void spans_rgb888(uint8_t *pixel, const struct spans_values *v,
                                                               const struct spans_look *look, unsigned kind)
{
    if (kind & SPANS_COLOUR) {
        pixel[0] = fx_u8(v->l >> 24);
        pixel[1] = fx_u8(v->h >> 24);
        pixel[2] = fx_u8(v->c >> 24);
    } else if (kind & SPANS_DIFFUSE) {
        const uint16_t *entry = look->table;
        if (kind & SPANS_WIDE)
            entry += 4 * fx_saturated(fx_wrap_u32(fx_wrap_s32(v->h) >> look->down), TABLE_BITS, 0);
        else if (kind & SPANS_HIGHLIGHT)
            entry += 4 * fx_saturated(v->h, TABLE_BITS, 30 - TABLE_BITS);
        const uint32_t l = fx_saturated(v->l, 16, 15); /* times Q8 steps: below 2^32 */
        for (int c = 0; c < 3; c++)
            pixel[c] = fx_u8(fx_saturated(entry[c] + (l * look->diffuse[c] >> 16), 8, 7));
    } else {
        pixel[0] = fx_wrap_u8(look->colour >> 16);
        pixel[1] = fx_wrap_u8(look->colour >> 8);
        pixel[2] = fx_wrap_u8(look->colour);
    }
}

static inline __attribute__((always_inline)) void spans_step(uint32_t *value, uint32_t *step, uint32_t second,
                                                             int quadratic)
{
    fx_step(value, *step);
    if (quadratic)
        fx_step(step, second);
}

/* Where pixels are: `base` and `step` of what is counted from (grey: the pixels, else depths), and of RGB888's pixels;
 * from one to the other where they have one pointer between them, as their steps are powers of 2. */
struct spans_place {
    uintptr_t base, to_other, pixels;
};

static inline struct spans_place spans_find(const struct raster *r, unsigned kind)
{
    const uintptr_t pixels = (uintptr_t)r->pixels, depth = (uintptr_t)r->depth;
    if (kind & SPANS_GREY8)
        return (struct spans_place){pixels, fx_wrap_sub(depth, 2 * pixels), 0};
    return (struct spans_place){depth, fx_wrap_sub(pixels, depth), pixels};
}

/* Pixels [at, end) of the band. *hidden counts those that are not the nearest; it stays in memory, as the loops need
 * the registers. */
static inline __attribute__((always_inline)) void spans_pixels(struct spans_place place, struct spans_values v,
                                                               uint32_t at, uint32_t end, const struct spans_look *look,
                                                               volatile uint32_t *hidden, unsigned kind)
{
    const unsigned step = kind & SPANS_GREY8 ? 1 : 2;
    uintptr_t p = place.base + step * (uintptr_t)at;
    const uintptr_t last = place.base + step * (uintptr_t)end;
    uintptr_t other = kind & SPANS_RGB888 ? place.pixels + 3 * (uintptr_t)at : place.to_other;
    const int quadratic = (kind & SPANS_QUADRATIC) != 0;
    do {
        if (kind & SPANS_GREY8)
            __asm__("" : "+r"(other)); /* or compilers step the depth's address too */
        uint16_t *depth = (uint16_t *)(kind & SPANS_GREY8 ? fx_wrap_add(other, 2 * p) : p);
        const uint32_t nearer = v.z >> 16;
        if (nearer > *depth) {
            *depth = fx_u16(nearer);
            if (kind & SPANS_GREY8)
                *(uint8_t *)p = fx_u8(spans_grey(&v, look, kind));
            else if (kind & SPANS_RGB888)
                spans_rgb888((uint8_t *)other, &v, look, kind);
            else
                *(uint16_t *)fx_wrap_add(p, other) = fx_u16(spans_rgb565(&v, look, kind));
        } else {
            *hidden = *hidden + 1;
        }
        fx_step(&v.z, v.dz);
        if (kind & (SPANS_DIFFUSE | SPANS_PLAIN | SPANS_COLOUR | SPANS_NORMAL))
            spans_step(&v.l, &v.dl, v.al, quadratic && !(kind & SPANS_LENGTH));
        if (SPANS_H(kind))
            spans_step(&v.h, &v.dh, v.ah, quadratic && !(kind & SPANS_LENGTH));
        if (SPANS_C(kind))
            spans_step(&v.c, &v.dc, v.ac, quadratic);
        if (kind & SPANS_RGB888)
            other += 3;
        p += step;
    } while (p != last);
}

/* A channel's value and first difference at column i, row j of its origin. */
FX_WRAPS static inline __attribute__((always_inline)) uint32_t spans_start(const struct polynomial *p, uint32_t i,
                                                                           uint32_t j, uint32_t *step, int quadratic)
{
    if (!quadratic) {
        *step = p->d;
        return p->f + p->e * j + p->d * i;
    }
    const uint32_t d = p->d + p->c * j, ai = p->a * i;
    *step = d + 2 * ai + p->a;
    return p->f + (p->e + p->b * j) * j + (d + ai) * i;
}

/* The values at column i, row j. */
static inline __attribute__((always_inline)) struct spans_values spans_at(const struct shade_setup *setup, uint32_t i,
                                                                          uint32_t j, unsigned kind)
{
    const struct polynomial *pl = &setup->channel[0].p, *ph = &setup->channel[1].p,
                            *pc = &setup->channel[kind & SPANS_LENGTH ? SHADE_SQUARE : 2].p;
    const int quadratic = (kind & SPANS_QUADRATIC) != 0, bends = quadratic && !(kind & SPANS_LENGTH);
    struct spans_values v = {.al = fx_wrap_shl(pl->a, 1), .ah = fx_wrap_shl(ph->a, 1), .ac = fx_wrap_shl(pc->a, 1)};
    v.z = spans_start(&setup->depth.p, i, j, &v.dz, 0);
    if (kind & (SPANS_DIFFUSE | SPANS_PLAIN | SPANS_COLOUR | SPANS_NORMAL))
        v.l = spans_start(pl, i, j, &v.dl, bends);
    if (SPANS_H(kind))
        v.h = spans_start(ph, i, j, &v.dh, bends);
    if (SPANS_C(kind))
        v.c = spans_start(pc, i, j, &v.dc, quadratic);
    return v;
}

/* Draws the set-up triangle over the band; returns the pixels that passed the depth test. */
static inline __attribute__((always_inline)) uint32_t spans_draw(struct raster *r, struct edges *e,
                                                                 struct spans_look look, unsigned kind)
{
    const struct shade_setup *setup = &r->setup;
    const int quadratic = (kind & SPANS_QUADRATIC) != 0;
    const uint32_t width = r->width, ox = fx_u32(setup->plane.ox);
    volatile uint32_t hidden = 0;
    uint32_t j = fx_wrap_u32(e->row - setup->plane.oy), row = fx_u32(e->row - r->y0) * width, covered = 0;
    const struct spans_place place = spans_find(r, kind);
    struct spans_values v = spans_at(setup, fx_wrap_sub(0, ox), j, kind); /* linear: at the row's column 0 */
    if (kind & SPANS_COLOUR) {                                            /* to the nearest step */
        fx_wrap_inc(&v.l, 1u << 23);
        fx_wrap_inc(&v.h, 1u << 23);
        fx_wrap_inc(&v.c, 1u << 23);
    }
    const uint32_t ez = setup->depth.p.e, el = setup->channel[0].p.e, eh = setup->channel[1].p.e,
                   ec = setup->channel[2].p.e;
    do {
        const struct span *span = r->span, *last = span + raster_spans(r, e);
        for (; span != last; span++, row += width) {
            const int32_t x = span->x0, n = span->x1 - x;
            if (n > 0) {
                struct spans_values first = v;
                if (quadratic) {
                    first = spans_at(setup, fx_wrap_sub(fx_u32(x), ox), j, kind);
                } else {
                    fx_wrap_inc(&first.z, fx_wrap_mul(v.dz, fx_u32(x)));
                    fx_wrap_inc(&first.l, fx_wrap_mul(v.dl, fx_u32(x)));
                    fx_wrap_inc(&first.h, fx_wrap_mul(v.dh, fx_u32(x)));
                    fx_wrap_inc(&first.c, fx_wrap_mul(v.dc, fx_u32(x)));
                }
                const uint32_t at = row + fx_u32(x);
                covered += fx_u32(n);
                spans_pixels(place, first, at, at + fx_u32(n), &look, &hidden, kind);
            }
            if (quadratic) {
                fx_wrap_inc(&j, 1);
            } else {
                fx_wrap_inc(&v.z, ez);
                fx_wrap_inc(&v.l, el);
                fx_wrap_inc(&v.h, eh);
                fx_wrap_inc(&v.c, ec);
            }
        }
    } while (e->row < e->last);
    return covered - hidden;
}

/* Before a highlight's channel is drawn: N.H from the foot of the power, and unless it is wide, of the span to 1. */
void spans_highlight(struct raster *r);

/*
 * What draws with these loops. Each draws a set-up triangle without exact channels, of its format, without dither, and
 * returns the pixels that passed the depth test. _constant: one colour, as raster_colour() has it; _colours: finished
 * colours (shade_gouraud()); _dots: N.L and N.H of one light, as raster_draw_dots() finds them.
 */
uint32_t spans_rgb565_constant(struct raster *r, struct edges *e, uint32_t colour);
uint32_t spans_rgb565_colours(struct raster *r, struct edges *e);
uint32_t spans_rgb565_dots(struct raster *r, struct edges *e);
uint32_t spans_grey8_constant(struct raster *r, struct edges *e, uint32_t colour);
uint32_t spans_grey8_colours(struct raster *r, struct edges *e);
uint32_t spans_grey8_dots(struct raster *r, struct edges *e);
uint32_t spans_grey8_lengths(struct raster *r, struct edges *e); /* Duff's: setup->length */
uint32_t spans_grey8_normals(struct raster *r, struct edges *e); /* Phong's, between normals at most 90 degrees apart */
uint32_t spans_rgb888_constant(struct raster *r, struct edges *e, uint32_t colour);
uint32_t spans_rgb888_colours(struct raster *r, struct edges *e);
uint32_t spans_rgb888_dots(struct raster *r, struct edges *e);

/* A case: none is inlined into another, so that each has all registers to itself. */
#define SPANS_CASE(name, kind)                                                                                       \
    static __attribute__((noinline)) uint32_t name(struct raster *r, struct edges *e, const struct spans_look *look) \
    {                                                                                                                \
        return spans_draw(r, e, *look, kind);                                                                        \
    }

#endif

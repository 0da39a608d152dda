/* SPDX-License-Identifier: MIT */
/* The pixels of X-shading and of the six-sample quadratic. */
#include "raster/dots.h"
#include "raster/pixels.h"
#include "raster/runs.h"

/* A channel's value and first difference at column i, row j of its origin, for the loops below. Nothing is carried from
 * row to row: half of a dense mesh's rows hold no pixel, and would pay for it. */
FX_WRAPS static inline uint32_t start_value(const struct polynomial *p, uint32_t i, uint32_t j, int quadratic,
                                            uint32_t *step)
{
    if (!quadratic) {
        *step = p->d;
        return p->f + p->e * j + p->d * i;
    }
    uint32_t d = p->d + p->c * j, ai = p->a * i;
    *step = d + 2 * ai + p->a;
    return p->f + (p->e + p->b * j) * j + (d + ai) * i;
}

/* Grey under one light: both dot products stepped, and summed at once. A template; the bits are those of dots_shade().
 */
FX_WRAPS static inline __attribute__((always_inline)) void shade_grey(struct raster *r, int x, int y, int n,
                                                                      int highlight)
{
    const struct surface *s = &r->surface;
    const struct shade_setup *setup = &r->setup;
    const struct polynomial *pl = &setup->channel[0].p, *ph = &setup->channel[1].p;
    const uint32_t i = (uint32_t)(x - setup->plane.ox), j = (uint32_t)(y - setup->plane.oy);
    const uint32_t al = 2 * pl->a, ah = 2 * ph->a, base = s->base[0];
    uint32_t dl, dh = 0, vl = start_value(pl, i, j, 1, &dl), vh = 0, *sum = r->sum[0];
    const uint16_t diffuse = s->light[0].diffuse[0], specular = s->light[0].specular[0];
    if (highlight)
        vh = start_value(ph, i, j, 1, &dh);
    for (const uint32_t *end = sum + 3 * n; sum != end; sum += 3) {
        uint32_t value = base;
        if ((int32_t)vl > 0)
            value += surface_diffuse(vl >> 15, diffuse);
        if (highlight) {
            uint32_t power = fx_power(s->power, (q30_t)vh);
            if (power)
                value += surface_diffuse(power, specular);
            vh += dh;
            dh += ah;
        }
        *sum = value;
        vl += dl;
        dl += al;
    }
}

RUNS_APART static void shade_run(struct raster *r, int x, int y, int n)
{
    const struct shade_setup *setup = &r->setup;
    if (surface_channels(&r->surface) != 1 || surface_lights(&r->surface) != 1 || setup->runs_only ||
        surface_form(&r->surface) || !setup->diffuse_lights)
        dots_shade(r, x, y, n, 0);
    else if (shade_specular(setup))
        shade_grey(r, x, y, n, 1);
    else
        shade_grey(r, x, y, n, 0);
}

/* The spans of a case into 565 through a table. A template: always called with a constant. */
FX_WRAPS static inline __attribute__((always_inline)) uint32_t spans(struct raster *r, struct edges *e,
                                                                     const uint16_t *colours, unsigned kind)
{
    const struct shade_setup *setup = &r->setup;
    const int quadratic = (kind & PIXELS_QUADRATIC) != 0;
    /* A linear case's few coefficients are copied near the stack pointer, where ARMv6-M reaches them in one load. */
    const struct polynomial copy_z = setup->depth.p, copy_l = setup->channel[0].p, copy_h = setup->channel[1].p;
    const struct polynomial *pz = quadratic ? &setup->depth.p : &copy_z,
                            *pl = quadratic ? &setup->channel[0].p : &copy_l,
                            *ph = quadratic ? &setup->channel[1].p : &copy_h;
    const uint32_t al = 2 * pl->a, ah = 2 * ph->a, dz = pz->d, width = r->width;
    const int down = 23 - r->surface.power->octave, ox = setup->plane.ox;
    const uintptr_t to_pixels = (uintptr_t)r->pixels - (uintptr_t)r->depth;
    volatile uint32_t hidden = 0; /* few: kept out of the registers, which the loop needs */
    uint32_t j = (uint32_t)(e->row - setup->plane.oy), covered = 0;
    uint16_t *row = r->depth + (uint32_t)(e->row - r->y0) * width;
    do {
        const struct span *span = r->span, *last = span + raster_spans(r, e);
        for (; span != last; span++, j++, row += width) {
            int32_t n = span->x1 - span->x0;
            if (n <= 0)
                continue;
            uint32_t i = (uint32_t)(span->x0 - ox);
            struct pixels_values v = {.z = pz->f + pz->e * j + dz * i, .dz = dz, .al = al, .ah = ah};
            if (kind & PIXELS_DIFFUSE)
                v.l = start_value(pl, i, j, quadratic, &v.dl);
            if (kind & PIXELS_HIGHLIGHT)
                v.h = start_value(ph, i, j, quadratic, &v.dh);
            covered += (uint32_t)n;
            pixels_plain(v, row + span->x0, row + span->x1, to_pixels, colours, down, &hidden, kind);
        }
    } while (e->row < e->last);
    return covered - hidden;
}

/* One function a case, none inlined into another, so that each has all registers to itself. */
#define CASE(name, kind)                                                                       \
    FX_WRAPS static __attribute__((noinline)) uint32_t name(struct raster *r, struct edges *e, \
                                                            const uint16_t *colours)           \
    {                                                                                          \
        return spans(r, e, colours, kind);                                                     \
    }
#define BOTH (PIXELS_DIFFUSE | PIXELS_HIGHLIGHT)
CASE(spans_dark, 0)
#if PIXELS_BY_HAND
CASE(spans_wide, BOTH | PIXELS_QUADRATIC)

static uint32_t spans_by_hand(struct raster *r, struct edges *e, const uint16_t *colours,
                              void (*draw)(struct pixels_rows *))
{
    const struct plane *plane = &r->setup.plane;
    const uint32_t stride = 2u * r->width;
    struct pixels_rows rows = {.channel = &r->setup.depth,
                               .row = (uint8_t *)r->depth + (uint32_t)(e->row - r->y0) * stride,
                               .stride = stride,
                               .j = (uint32_t)(e->row - plane->oy),
                               .ox = (uint32_t)plane->ox,
                               .table = colours,
                               .to_pixels = (uintptr_t)r->pixels - (uintptr_t)r->depth};
    do {
        rows.span = r->span;
        rows.last = r->span + raster_spans(r, e);
        draw(&rows);
    } while (e->row < e->last);
    return rows.covered - rows.hidden;
}
#define spans_diffuse(r, e, colours)           spans_by_hand(r, e, colours, pixels_rows_diffuse)
#define spans_diffuse_quadratic(r, e, colours) spans_by_hand(r, e, colours, pixels_rows_diffuse_quadratic)
#define spans_both(r, e, colours)              spans_by_hand(r, e, colours, pixels_rows_both)
#define spans_both_quadratic(r, e, colours)    spans_by_hand(r, e, colours, pixels_rows_both_quadratic)

/* N.H from Q30 / 2^octave to Q30. */
FX_WRAPS static void scale_up(struct polynomial *p, unsigned octave)
{
    p->f <<= octave;
    p->d <<= octave;
    p->e <<= octave;
    p->a <<= octave;
    p->b <<= octave;
    p->c <<= octave;
}
#else
CASE(spans_diffuse, PIXELS_DIFFUSE)
CASE(spans_diffuse_quadratic, PIXELS_DIFFUSE | PIXELS_QUADRATIC)
CASE(spans_both, BOTH)
CASE(spans_both_quadratic, BOTH | PIXELS_QUADRATIC)
#endif

/* What no polynomial holds, from a table too: N.L and N.H of a run, and its colours. */
RUNS_APART static void table_values(struct raster *r, int x, int y, int n)
{
    const struct shade_setup *setup = &r->setup;
    for (int which = 0; which < 2; which++) {
        if ((which ? shade_specular(setup) : setup->diffuse_lights) != 0)
            plane_values(&setup->plane, &setup->channel[which], x, y, n, r->value[which]);
        else
            for (int i = 0; i < n; i++)
                r->value[which][i] = 0;
    }
}

RUNS_APART static void table_write(struct raster *r, int x, int y, uint32_t mask)
{
    const int octave = r->surface.power->octave;
    const int32_t half = 1 << 23, foot = (1 << 30) - (1 << (30 - octave)), *value = r->value[0];
    uint16_t *pixel = (uint16_t *)(void *)(r->pixels + (uint32_t)(y - r->y0) * r->stride) + x;
    for (; mask; mask >>= 1, value++, pixel++) {
        if (!(mask & 1))
            continue;
        int32_t l = (value[0] + half) >> 24, h = value[RUN] < foot ? 0 : (value[RUN] - foot) >> (23 - octave);
        *pixel = r->surface_table->colour[pixels_clamped(h, TABLE_HIGHLIGHT - 1)][pixels_clamped(l, TABLE_DIFFUSE - 1)];
    }
}

RUNS_APART static uint32_t draw_table_runs(struct raster *r, struct edges *e)
{
    return runs_draw_by(r, e, table_values, table_write);
}

RUNS_APART static uint32_t draw_runs(struct raster *r, struct edges *e)
{
    return runs_draw(r, e, shade_run);
}

FX_WRAPS uint32_t raster_draw_dots(struct raster *r, struct edges *e)
{
    struct shade_setup *setup = &r->setup;
    const struct colour_table *table = USES(USES_RGB565) ? r->surface_table : 0;
    if (!table)
        return draw_runs(r, e);
    if (setup->runs_only)
        return draw_table_runs(r, e);
    const uint16_t *colours = table->colour[0];
    /* N.L rounded to the table's steps: half a step more. N.H counts from the foot of the power. */
    const uint32_t half = 1u << 23;
    if (shade_specular(setup)) {
        if (!setup->diffuse_lights)
            setup->channel[0].p = (struct polynomial){0}; /* a highlight alone: the loops read both */
        setup->channel[0].p.f += half;
        setup->channel[1].p.f += (1u << (30 - r->surface.power->octave)) - (1u << 30);
#if PIXELS_BY_HAND
        if (setup->wide)
            return spans_wide(r, e, colours);
        scale_up(&setup->channel[1].p, r->surface.power->octave);
#endif
        return setup->quadratic ? spans_both_quadratic(r, e, colours) : spans_both(r, e, colours);
    }
    setup->channel[0].p.f += half;
    if (setup->diffuse_lights)
        return setup->quadratic ? spans_diffuse_quadratic(r, e, colours) : spans_diffuse(r, e, colours);
    return spans_dark(r, e, colours);
}

const struct glint_method glint_x = {GLINT_X, 1, 0, shade_x, raster_draw_dots, 0, 0};
const struct glint_method glint_six = {GLINT_SIX, 1, 0, shade_six, raster_draw_dots, 0, 0};

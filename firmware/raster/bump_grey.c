/* SPDX-License-Identifier: MIT */
/*
 * Bump mapping straight into 8-bit grey, under one light, from a material's table (raster/table.c): depth test, texel,
 * N'.L' and N'.H', store, all stepped by differences from exact values at a span's first pixel. A template, of which
 * each case is a function of its own.
 *
 * The set-up has multiplied L' by the material's diffuse light, so that N'.L' counts in Q22 steps of the output (Q30 of
 * 256), and x and y of L' and H' by the map's steepness, so that a texel multiplies them as it lies there.
 */
#include "raster/bump.h"
#include "raster/spans.h"
#include "shade/bump.h"

enum bump_kind { BUMP_GLOSSY = 1, BUMP_BENT = 2, BUMP_UNIT = 4 };

/* A vector's components, their first differences, and second ones (0 where linear); s: 1 - its squared length. */
struct vector {
    uint32_t x, y, z, dx, dy, dz, ax, ay, az, s, ds, as;
};

struct look {
    const int8_t (*texel)[2];
    const uint16_t *rise, *table;
    uint32_t colour; /* the ambient part with the rounding half, Q7 steps */
    uint32_t columns, rows,
        clear;     /* of texels: a coordinate's shift to its column; to its row in place; the bits below */
    uint32_t down; /* of N'.H' in Q30 to steps of the table */
    uint32_t foot; /* of the power, such steps */
};

/* N'.V in Q30, less than 2 in size: a texel's component is below 2^7 and the vector's in Q23, z's Q14 and Q16. */
static inline __attribute__((always_inline)) int32_t dot(const struct vector *v, int32_t x, int32_t y, int32_t z)
{
    return x * ((int32_t)v->x >> 7) + y * ((int32_t)v->y >> 7) + z * ((int32_t)v->z >> 14);
}

/* 1 / |V| in Q15. */
static inline __attribute__((always_inline)) uint32_t inverse(const struct vector *v)
{
    return spans_length[fx_saturated(v->s, SPANS_LENGTH_BITS, 28 - SPANS_LENGTH_BITS)];
}

FX_WRAPS static inline __attribute__((always_inline)) void step(struct vector *v, unsigned kind)
{
    v->x += v->dx;
    v->y += v->dy;
    v->z += v->dz;
    if (kind & BUMP_BENT) {
        v->dx += v->ax;
        v->dy += v->ay;
        v->dz += v->az;
    }
    if (kind & BUMP_UNIT) {
        v->s += v->ds;
        v->ds += v->as;
    }
}

/* The vector at column i, row j, and 1 less its square. */
static inline __attribute__((always_inline)) void start(const struct channel *c, const struct channel *square,
                                                        uint32_t i, uint32_t j, unsigned kind, struct vector *v)
{
    const int bent = (kind & BUMP_BENT) != 0;
    v->x = spans_start(&c[0].p, i, j, &v->dx, bent);
    v->y = spans_start(&c[1].p, i, j, &v->dy, bent);
    v->z = spans_start(&c[2].p, i, j, &v->dz, bent);
    v->ax = 2 * c[0].p.a;
    v->ay = 2 * c[1].p.a;
    v->az = 2 * c[2].p.a;
    v->s = v->ds = v->as = 0;
    if (kind & BUMP_UNIT) {
        v->s = spans_start(&square->p, i, j, &v->ds, 1);
        v->as = 2 * square->p.a;
    }
}

/* The colour under a texel. */
FX_WRAPS static inline __attribute__((always_inline)) uint32_t
grey(const struct vector *light, const struct vector *half, const struct look *look, const int8_t *texel, unsigned kind)
{
    const int32_t x = texel[0], y = texel[1], z = bump_rise(look->rise, x, y);
    const int32_t l = dot(light, x, y, z);
    uint32_t sum = look->colour;
    if (kind & BUMP_GLOSSY) {
        int32_t h = dot(half, x, y, z);
        if (kind & BUMP_UNIT)
            h = (h >> 15) * (int32_t)inverse(half);
        sum = look->table[fx_saturated((uint32_t)(h >> look->down) - look->foot, TABLE_BITS, 0)];
    }
    if (kind & BUMP_UNIT) /* below 2^15.7 * 2^15.3 */
        sum += fx_saturated((uint32_t)l, 16, 15) * inverse(light) >> 15;
    else
        sum += fx_saturated((uint32_t)l, 16, 15);
    return fx_saturated(sum, 8, 7);
}

FX_WRAPS static inline __attribute__((always_inline)) uint32_t draw(struct raster *r, struct edges *e,
                                                                    const struct look *look, unsigned kind)
{
    const struct shade_setup *setup = &r->setup;
    const uint32_t width = r->width, ox = (uint32_t)setup->plane.ox;
    uint32_t j = (uint32_t)(e->row - setup->plane.oy), row = (uint32_t)(e->row - r->y0) * width, drawn = 0;
    do {
        const struct span *span = r->span, *last = span + raster_spans(r, e);
        for (; span != last; span++, row += width, j++) {
            if (span->x1 <= span->x0)
                continue;
            const uint32_t i = (uint32_t)span->x0 - ox, at = row + (uint32_t)span->x0;
            uint32_t dz, du, dv, z = spans_start(&setup->depth.p, i, j, &dz, 0);
            uint32_t u = spans_start(&setup->uv[0].p, i, j, &du, 0), v = spans_start(&setup->uv[1].p, i, j, &dv, 0);
            struct vector light, half;
            start(setup->bump, setup->bump + BUMP_SQUARE, i, j, kind, &light);
            if (kind & BUMP_GLOSSY)
                start(setup->bump + BUMP_HALF, setup->bump + BUMP_SQUARE + 1, i, j, kind, &half);
            u <<= 4; /* whole turns are of no account */
            v <<= 4;
            du <<= 4;
            dv <<= 4;
            uint8_t *pixel = r->pixels + at, *end = pixel + (span->x1 - span->x0);
            uint16_t *depth = r->depth + at;
            do {
                if (z >> 16 > *depth) {
                    const uint32_t texel = ((v >> look->rows) & look->clear) | u >> look->columns;
                    *depth = (uint16_t)(z >> 16);
                    *pixel = (uint8_t)grey(&light, &half, look, look->texel[texel], kind);
                    drawn++;
                }
                z += dz;
                u += du;
                v += dv;
                step(&light, kind);
                if (kind & BUMP_GLOSSY)
                    step(&half, kind);
                depth++;
            } while (++pixel != end);
        }
    } while (e->row < e->last);
    return drawn;
}

#define CASE(name, kind)                                                                       \
    FX_WRAPS static __attribute__((noinline)) uint32_t name(struct raster *r, struct edges *e, \
                                                            const struct look *look)           \
    {                                                                                          \
        return draw(r, e, look, kind);                                                         \
    }
CASE(linear, 0)
CASE(linear_glossy, BUMP_GLOSSY)
CASE(bent, BUMP_BENT)
CASE(bent_glossy, BUMP_BENT | BUMP_GLOSSY)
CASE(unit, BUMP_UNIT)
CASE(unit_glossy, BUMP_UNIT | BUMP_GLOSSY)

/* Which lights' channels there are is one light's: the lit side's is always there. */
uint32_t bump_grey(struct raster *r, struct edges *e)
{
    const struct shade_setup *setup = &r->setup;
    const struct surface_bump *map = &r->surface.bump;
    const unsigned octave = r->surface.power->octave, glossy = shade_specular(setup) != 0;
    const struct look look = {.texel = map->texel,
                              .rise = map->rise,
                              .table = r->surface_table->entry,
                              .colour = r->surface.ambient,
                              .columns = 32u - map->log2_width,
                              .rows = 32u - map->log2_width - map->log2_height,
                              .clear = ~0u << map->log2_width,
                              .down = 30u - TABLE_BITS - octave,
                              .foot = (1u << (TABLE_BITS + octave)) - (1u << TABLE_BITS)};
    if (setup->length)
        return glossy ? unit_glossy(r, e, &look) : unit(r, e, &look);
    if (setup->quadratic)
        return glossy ? bent_glossy(r, e, &look) : bent(r, e, &look);
    return glossy ? linear_glossy(r, e, &look) : linear(r, e, &look);
}

/* SPDX-License-Identifier: MIT */
/*
 * Bump mapping into 8-bit grey under one light, from a material's table (raster/table.c), in runs of stages that each
 * keep what they step in registers: depth mask, texels to normals, N'.L', N'.H', pixels.
 *
 * The set-up has multiplied L' by the material's diffuse light, so that N'.L' counts in Q22 steps of the output (Q30 of
 * 256), and x and y of L' and H' by the map's steepness, so that a texel multiplies them as it lies there.
 */
#include "raster/bump.h"
#include "raster/runs.h"
#include "raster/spans.h"
#include "shade/bump.h"

enum bump_kind { BUMP_BENT = 1, BUMP_UNIT = 2 };

/* The map's normals under a run: x and y as the texel has them in bits 0-7 and 8-15, z in Q14 above. */
RUNS_APART static void find_normals(struct raster *r, uint32_t i, uint32_t j, int n)
{
    const struct surface_bump *map = &r->surface.bump;
    const unsigned columns = 32u - map->log2_width, rows = 32u - map->log2_width - map->log2_height;
    const uint32_t clear = fx_wrap_shl(~0u, map->log2_width);
    const uint16_t *rise = map->rise;
    const int8_t(*texel)[2] = map->texel;
    uint32_t du, dv, u = spans_start(&r->setup.uv[0].p, i, j, &du, 0), v = spans_start(&r->setup.uv[1].p, i, j, &dv, 0);
    int32_t *out = r->value[3];
    u = fx_wrap_shl(u, 4); /* whole turns are of no account */
    v = fx_wrap_shl(v, 4);
    du = fx_wrap_shl(du, 4);
    dv = fx_wrap_shl(dv, 4);
    for (const int32_t *end = out + n; out != end; out++) {
        const int8_t *at = texel[((v >> rows) & clear) | u >> columns];
        const int32_t x = at[0], y = at[1];
        *out = fx_s32(fx_u32(bump_rise(rise, x, y)) << 16 | fx_u32(fx_wrap_u8(y)) << 8 | fx_wrap_u8(x));
        fx_wrap_inc(&u, du);
        fx_wrap_inc(&v, dv);
    }
}

/* N'.V in Q30, at which `normal` lies in r->value[3] and the sum goes to r->value[where]. A texel's components are
 * below 2^7 and the vector's in Q23, z's Q14 and Q16: below 2^31, as |N'| < 3/2 and |V| <= 7/6. A template. */
static inline __attribute__((always_inline)) void find_dots(int32_t *normal, const struct channel *c,
                                                            const struct channel *square, uint32_t i, uint32_t j, int n,
                                                            int out, unsigned kind)
{
    const int bent = (kind & BUMP_BENT) != 0;
    uint32_t dx, dy, dz, ds = 0, s = 0, x = spans_start(&c[0].p, i, j, &dx, bent);
    uint32_t y = spans_start(&c[1].p, i, j, &dy, bent), z = spans_start(&c[2].p, i, j, &dz, bent);
    const uint32_t ax = fx_wrap_shl(c[0].p.a, 1), ay = fx_wrap_shl(c[1].p.a, 1), az = fx_wrap_shl(c[2].p.a, 1),
                   as = fx_wrap_shl(square->p.a, 1);
    if (kind & BUMP_UNIT)
        s = spans_start(&square->p, i, j, &ds, 1);
    for (const int32_t *end = normal + n; normal != end; normal++) {
        const uint32_t at = fx_u32(*normal);
        int32_t dot = fx_wrap_s8(at) * (fx_wrap_s32(x) >> 7) + fx_wrap_s8(at >> 8) * (fx_wrap_s32(y) >> 7) +
                      fx_s32(at >> 16) * (fx_wrap_s32(z) >> 14);
        if (kind & BUMP_UNIT) { /* 1 / |V| in Q15: the quotient is below 3/2 again */
            const uint32_t by = spans_length[fx_saturated(s, SPANS_LENGTH_BITS, 28 - SPANS_LENGTH_BITS)];
            dot = (dot >> 15) * fx_s32(by);
            fx_wrap_inc(&s, ds);
            fx_wrap_inc(&ds, as);
        }
        normal[out] = dot;
        fx_wrap_inc(&x, dx);
        fx_wrap_inc(&y, dy);
        fx_wrap_inc(&z, dz);
        if (bent) {
            fx_wrap_inc(&dx, ax);
            fx_wrap_inc(&dy, ay);
            fx_wrap_inc(&dz, az);
        }
    }
}

#define CASE(name, out, kind)                                                                                       \
    RUNS_APART static void name(int32_t *normal, const struct channel *c, const struct channel *square, uint32_t i, \
                                uint32_t j, int n)                                                                  \
    {                                                                                                               \
        find_dots(normal, c, square, i, j, n, out, kind);                                                           \
    }
#define TO_LIGHT (-3 * RUN) /* r->value[0] from r->value[3] */
#define TO_HALF  (-2 * RUN)
CASE(light_linear, TO_LIGHT, 0)
CASE(light_bent, TO_LIGHT, BUMP_BENT)
CASE(light_unit, TO_LIGHT, BUMP_UNIT)
CASE(half_linear, TO_HALF, 0)
CASE(half_bent, TO_HALF, BUMP_BENT)
CASE(half_unit, TO_HALF, BUMP_UNIT)

/* The pixels of a mask. */
static void write_glossy(struct raster *r, int x, int y, uint32_t mask)
{
    uint8_t *pixel = r->pixels + fx_u32(y - r->y0) * r->width + x;
    const unsigned octave = r->surface.power->octave;
    const int down = 30 - TABLE_BITS - fx_s32(octave); /* of N'.H' in Q30 to steps of the table */
    const uint32_t foot = (1u << (TABLE_BITS + octave)) - (1u << TABLE_BITS);
    const uint16_t *table = r->surface_table->entry;
    for (const int32_t *value = r->value[0]; mask; mask >>= 1, value++, pixel++)
        if (mask & 1) {
            const uint32_t h = fx_wrap_sub(fx_wrap_u32(value[RUN] >> down), foot);
            const uint32_t sum = table[fx_saturated(h, TABLE_BITS, 0)] + fx_saturated(fx_wrap_u32(value[0]), 16, 15);
            *pixel = fx_u8(fx_saturated(sum, 8, 7));
        }
}

static void write_matt(struct raster *r, int x, int y, uint32_t mask)
{
    uint8_t *pixel = r->pixels + fx_u32(y - r->y0) * r->width + x;
    const uint32_t ambient = r->surface.ambient;
    for (const int32_t *value = r->value[0]; mask; mask >>= 1, value++, pixel++)
        if (mask & 1)
            *pixel = fx_u8(fx_saturated(ambient + fx_saturated(fx_wrap_u32(*value), 16, 15), 8, 7));
}

static void shade(struct raster *r, int x, int y, int n)
{
    const struct shade_setup *setup = &r->setup;
    const struct channel *light = setup->bump, *half = setup->bump + BUMP_HALF, *square = setup->bump + BUMP_SQUARE;
    const uint32_t i = fx_wrap_u32(x - setup->plane.ox), j = fx_wrap_u32(y - setup->plane.oy);
    const int glossy = shade_specular(setup) != 0;
    int32_t *normal = r->value[3];
    find_normals(r, i, j, n);
    if (setup->length) {
        light_unit(normal, light, square, i, j, n);
        if (glossy)
            half_unit(normal, half, square + 1, i, j, n);
    } else if (setup->quadratic) {
        light_bent(normal, light, square, i, j, n);
        if (glossy)
            half_bent(normal, half, square, i, j, n);
    } else {
        light_linear(normal, light, square, i, j, n);
        if (glossy)
            half_linear(normal, half, square, i, j, n);
    }
}

uint32_t bump_grey(struct raster *r, struct edges *e)
{
    return runs_draw_by(r, e, shade, shade_specular(&r->setup) ? write_glossy : write_matt);
}

/* SPDX-License-Identifier: MIT */
#include "raster/runs.h"
#include "shade/colour.h"

/* Channels are Q24 steps between 0 and 255, so unsigned 32 bits; a rounding below 0 is taken for 0. */
static void shade_run(struct raster *r, int x, int y, int n)
{
    for (unsigned c = 0; c < raster_channels(r); c++) {
        plane_values(&r->setup.plane, &r->setup.channel[c], x, y, n, r->value[0]);
        for (int i = 0; i < n; i++) {
            uint32_t value = (uint32_t)r->value[0][i];
            r->sum[i][c] = value >= 0xff800000u ? 0 : value >> 9;
        }
    }
}

/* 565: fields of at most 6 bits, so a Q24 step count plus the rounding half stays below 2^30 and its sign shows. */
FX_WRAPS static __attribute__((noinline)) uint32_t spans(struct raster *r, struct edges *e)
{
    const struct polynomial *pz = &r->setup.depth.p, *pr = &r->setup.channel[0].p, *pg = &r->setup.channel[1].p,
                            *pb = &r->setup.channel[2].p;
    const uint32_t dz = pz->d, dr = pr->d, dg = pg->d, db = pb->d, half = 1u << 23;
    uint32_t j = (uint32_t)(e->row - r->setup.plane.oy), hidden = 0, covered = 0;
    uint32_t z = pz->f + pz->e * j, red = pr->f + pr->e * j + half, green = pg->f + pg->e * j + half,
             blue = pb->f + pb->e * j + half;
    uint32_t row = (uint32_t)(e->row - r->y0) * r->width;
    do {
        const struct span *span = r->span, *last = span + raster_spans(r, e);
        for (; span != last; span++) {
            int n = span->x1 - span->x0;
            if (n > 0) {
                uint32_t i = (uint32_t)(span->x0 - r->setup.plane.ox);
                uint32_t vz = z + dz * i, vr = red + dr * i, vg = green + dg * i, vb = blue + db * i;
                uint16_t *pixel = (uint16_t *)(void *)r->pixels + row + span->x0, *depth = r->depth + row + span->x0;
                uint16_t *end = pixel + n;
                covered += (uint32_t)n;
                do {
                    uint32_t nearer = vz >> 16;
                    if (nearer > *depth) {
                        *depth = (uint16_t)nearer;
                        *pixel = (uint16_t)(vr >> 24 << 11 | vg >> 24 << 5 | vb >> 24);
                    } else {
                        hidden++;
                    }
                    vz += dz;
                    vr += dr;
                    vg += dg;
                    vb += db;
                    depth++;
                } while (++pixel < end);
            }
            z += pz->e;
            red += pr->e;
            green += pg->e;
            blue += pb->e;
            row += r->width;
        }
    } while (e->row < e->last);
    return covered - hidden;
}

uint32_t draw_gouraud(struct raster *r, struct edges *e)
{
    if (r->setup.plane.sliver || !raster_is(r, GLINT_RGB565) || raster_dithers(r))
        return runs_draw(r, e, shade_run);
    return spans(r, e);
}

const struct glint_method glint_gouraud = {GLINT_GOURAUD, 0, COLOUR_WORDS, shade_gouraud, draw_gouraud, 0, 0};

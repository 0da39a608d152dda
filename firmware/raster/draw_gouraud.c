/* SPDX-License-Identifier: MIT */
#include "raster/raster.h"

/* Channels are Q24 steps between 0 and 255, so unsigned 32 bits; a rounding below 0 is taken for 0. */
static void shade_run(struct raster *r, int x, int y, int n)
{
    for (unsigned c = 0; c < r->palette.channels; c++) {
        plane_values(&r->setup.plane, &r->setup.channel[c], x, y, n, r->value[0]);
        for (int i = 0; i < n; i++) {
            uint32_t value = (uint32_t)r->value[0][i];
            r->sum[i][c] = value >= 0xff800000u ? 0 : value >> 9;
        }
    }
}

FX_WRAPS static inline uint32_t start_value(const struct polynomial *p, uint32_t i, uint32_t j)
{
    return p->f + p->e * j + p->d * i;
}

/* RGB565, as draw_x.c's loops. The fields' half steps are added beforehand, so that taking whole steps rounds. */
FX_WRAPS static uint32_t spans(struct raster *r, struct edges *e)
{
    const struct polynomial pz = r->setup.depth.p, pr = r->setup.channel[0].p, pg = r->setup.channel[1].p,
                            pb = r->setup.channel[2].p;
    const uint32_t half = 1u << 23, width = r->width;
    const int ox = r->setup.plane.ox;
    const uintptr_t to_pixels = (uintptr_t)r->pixels - (uintptr_t)r->depth;
    volatile uint32_t hidden = 0;
    uint32_t j = (uint32_t)(e->row - r->setup.plane.oy), covered = 0;
    uint16_t *row = r->depth + (uint32_t)(e->row - r->y0) * width;
    do {
        const struct span *span = r->span, *last = span + raster_spans(r, e);
        for (; span != last; span++, j++, row += width) {
            int32_t n = span->x1 - span->x0;
            if (n <= 0)
                continue;
            uint32_t i = (uint32_t)(span->x0 - ox);
            uint32_t z = start_value(&pz, i, j), red = start_value(&pr, i, j) + half;
            uint32_t green = start_value(&pg, i, j) + half, blue = start_value(&pb, i, j) + half;
            uint16_t *depth = row + span->x0, *end = row + span->x1;
            covered += (uint32_t)n;
            do {
                uint32_t nearer = z >> 16;
                if (nearer > *depth) {
                    *depth = (uint16_t)nearer;
                    *(uint16_t *)((uintptr_t)depth + to_pixels) =
                        (uint16_t)(red >> 24 << 11 | green >> 24 << 5 | blue >> 24);
                } else {
                    hidden = hidden + 1;
                }
                fx_step(&z, pz.d);
                fx_step(&red, pr.d);
                fx_step(&green, pg.d);
                fx_step(&blue, pb.d);
            } while (++depth != end);
        }
    } while (e->row < e->last);
    return covered - hidden;
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    if (r->setup.plane.sliver || r->format != GLINT_RGB565 || r->dither)
        return raster_runs(r, e, shade_run);
    return spans(r, e);
}

const struct glint_method glint_gouraud = {GLINT_GOURAUD, SHADE_GOURAUD_WORDS, shade_gouraud, draw};

/* SPDX-License-Identifier: MIT */
#include "raster/runs.h"

static void shade_run(struct raster *r, int x, int y, int n)
{
    (void)x;
    (void)y;
    for (int i = 0; i < n; i++)
        for (unsigned c = 0; c < raster_channels(r); c++)
            r->sum[i][c] = r->setup.flat[c];
}

FX_WRAPS static uint32_t spans(struct raster *r, struct edges *e)
{
    const struct polynomial *pz = &r->setup.depth.p;
    const uint16_t colour = (uint16_t)raster_colour(r, r->setup.flat);
    const uint32_t dz = pz->d;
    uint32_t hidden = 0, covered = 0;
    uint32_t z = pz->f + pz->e * (uint32_t)(e->row - r->setup.plane.oy);
    uint32_t row = (uint32_t)(e->row - r->y0) * r->width;
    do {
        const struct span *span = r->span, *last = span + raster_spans(r, e);
        for (; span != last; span++) {
            int n = span->x1 - span->x0;
            if (n > 0) {
                uint32_t vz = z + dz * (uint32_t)(span->x0 - r->setup.plane.ox);
                uint16_t *pixel = (uint16_t *)(void *)r->pixels + row + span->x0, *depth = r->depth + row + span->x0;
                uint16_t *end = pixel + n;
                covered += (uint32_t)n;
                do {
                    uint32_t nearer = vz >> 16;
                    if (nearer > *depth) {
                        *depth = (uint16_t)nearer;
                        *pixel = colour;
                    } else {
                        hidden++;
                    }
                    vz += dz;
                    depth++;
                } while (++pixel < end);
            }
            z += pz->e;
            row += r->width;
        }
    } while (e->row < e->last);
    return covered - hidden;
}

static uint32_t draw(struct raster *r, struct edges *e)
{
    if (r->setup.plane.sliver || !raster_is(r, GLINT_RGB565) || raster_dithers(r))
        return runs_draw(r, e, shade_run);
    return spans(r, e);
}

const struct glint_method glint_flat = {GLINT_FLAT, 0, 0, shade_flat, draw, 0, 0};

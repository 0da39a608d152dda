/* SPDX-License-Identifier: MIT */
/* The general way of drawing: any format, any number of lights, slivers too. */
#include "raster/raster.h"

/* Tests and writes the depth of n pixels: a bit for each that is nearer than what was there. */
static uint32_t test_depth(const int32_t *value, uint16_t *depth, int n)
{
    uint32_t mask = 0;
    for (int i = 0; i < n; i++) {
        uint16_t z = (uint16_t)((uint32_t)value[i] >> 16);
        if (z > depth[i]) {
            depth[i] = z;
            mask |= 1u << i;
        }
    }
    return mask;
}

static uint32_t bit_count(uint32_t mask)
{
    uint32_t n = 0;
    for (; mask; mask &= mask - 1)
        n++;
    return n;
}

uint32_t raster_runs(struct raster *r, struct edges *e, raster_shade *shade)
{
    uint32_t drawn = 0;
    int x0, x1;
    do {
        if (!raster_span(r, e, &x0, &x1))
            continue;
        uint16_t *depth = r->depth + (uint32_t)(e->row - r->y0) * r->width;
        for (int x = x0; x < x1; x += RUN) {
            int n = x1 - x < RUN ? x1 - x : RUN;
            plane_values(&r->setup.plane, &r->setup.depth, 0, x, e->row, n, r->value[0]);
            uint32_t mask = test_depth(r->value[0], depth + x, n);
            if (!mask)
                continue;
            drawn += bit_count(mask);
            shade(r, x, e->row, n);
            raster_write(r, x, e->row, mask);
        }
    } while (edges_next(e));
    return drawn;
}

/* SPDX-License-Identifier: MIT */
/* The general way of drawing: any format, any number of lights, slivers too. */
#include "raster/raster.h"

/* Tests and writes the depth of n pixels: a bit for each that is nearer than what was there, counted in *drawn. */
static inline uint32_t test_depth(const int32_t *value, uint16_t *depth, int n, uint32_t *drawn)
{
    uint32_t mask = 0;
    for (uint32_t bit = 1, end = 1u << n; bit != end; bit <<= 1, depth++) {
        uint32_t z = (uint32_t)*value++ >> 16;
        if (z > *depth) {
            *depth = (uint16_t)z;
            mask |= bit;
            ++*drawn;
        }
    }
    return mask;
}

/* One span; returns the pixels drawn. */
static uint32_t draw_span(struct raster *r, int y, struct span span, raster_shade *shade)
{
    uint16_t *depth = r->depth + (uint32_t)(y - r->y0) * r->width;
    uint32_t drawn = 0;
    for (int x = span.x0; x < span.x1; x += RUN) {
        int n = span.x1 - x < RUN ? span.x1 - x : RUN;
        plane_values(&r->setup.plane, &r->setup.depth, x, y, n, r->value[0]);
        uint32_t mask = test_depth(r->value[0], depth + x, n, &drawn);
        if (!mask)
            continue;
        shade(r, x, y, n);
        raster_write(r, x, y, mask);
    }
    return drawn;
}

uint32_t raster_runs(struct raster *r, struct edges *e, raster_shade *shade)
{
    uint32_t drawn = 0;
    int y = e->row;
    do {
        int rows = raster_spans(r, e);
        for (int i = 0; i < rows; i++, y++)
            drawn += draw_span(r, y, r->span[i], shade);
    } while (e->row < e->last);
    return drawn;
}

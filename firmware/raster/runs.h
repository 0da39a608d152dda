/* SPDX-License-Identifier: MIT */
/*
 * The general way of drawing: any format, any number of lights, slivers too, in runs of up to RUN pixels.
 */
#ifndef GLINT_RUNS_H
#define GLINT_RUNS_H

#include "raster/raster.h"

/* Tests and writes the depths of n pixels from (x, y): a bit for each that is nearer than what was there. */
uint32_t raster_visible(struct raster *r, int x, int y, int n);

/* `shade` fills r->sum, unclamped. */
typedef raster_run runs_shade;

/* Keeps a run's shading, or a way of drawing that is taken seldom, from taking registers of what calls it. */
#define RUNS_APART __attribute__((noinline))

/* Writes the pixels of a mask from what `shade` left. */
typedef void runs_write(struct raster *r, int x, int y, uint32_t mask);

/* Draws the triangle's spans; returns the pixels that passed the depth test. */
uint32_t runs_draw_by(struct raster *r, struct edges *e, runs_shade *shade, runs_write *write);

static inline __attribute__((always_inline)) uint32_t runs_draw(struct raster *r, struct edges *e, runs_shade *shade)
{
    return runs_draw_by(r, e, shade, raster_write);
}

#endif

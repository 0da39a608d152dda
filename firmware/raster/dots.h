/* SPDX-License-Identifier: MIT */
/* A run's colours from channels of N.L and N.H: clamp, power and sum over the lights, per pixel. */
#ifndef GLINT_RASTER_DOTS_H
#define GLINT_RASTER_DOTS_H

#include "raster/raster.h"

/* Turns what the channels hold for n pixels, in r->value[0], into the dot products in Q30; by r->divisor. */
typedef void dots_divide(struct raster *r, int n);

/* Fills r->sum and adds to r->gloss for n pixels from (x, y); `divide` is null where the channels are the dot products.
 */
void dots_shade(struct raster *r, int x, int y, int n, dots_divide *divide);

/* The same without: a method's `run`. */
void dots_run(struct raster *r, int x, int y, int n);

#endif

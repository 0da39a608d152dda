/* SPDX-License-Identifier: MIT */
/* Pixels from interpolated normals, made unit and lit at each, in the object's axes. */
#ifndef GLINT_NORMALS_H
#define GLINT_NORMALS_H

#include "raster/raster.h"

/* Shades n pixels from (x, y): channels 0 to 2 are the normal in Q30, less than 1.2 long, and 3 to 5 the place (where
 * lights need it). Normals shorter than 2^-18 count as none, and such a pixel has ambient light only. */
void normals_run(struct raster *r, int x, int y, int n);

/* The same for numerators of perspective.h, or without setup.perspective for normals of any length: shorter than 2^-18
 * is none. */
void normals_run_perspective(struct raster *r, int x, int y, int n);

/* The same for normals that stand in r->value[0] to [2], in any format: shorter than 2^12 is none. */
void normals_shade(struct raster *r, int x, int y, int n);

#endif

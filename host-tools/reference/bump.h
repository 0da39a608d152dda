/* SPDX-License-Identifier: MIT */
/*
 * Bump mapping in double precision: light and half-way direction in the corners' moving frames, interpolated over the
 * triangle, times the map's normal at the pixel ("Improved Bump Mapping by using Quadratic Vector Interpolation").
 */
#ifndef REFERENCE_BUMP_H
#define REFERENCE_BUMP_H

#include "reference/decode.h"
#include "reference/shading.h"

/* What becomes of L' and H' between the corners. */
enum bump_kind {
    BUMP_NONE,      /* the method takes no notice of maps */
    BUMP_UNIT,      /* linear, unit at each pixel: the truth */
    BUMP_LINEAR,    /* linear as they are */
    BUMP_QUADRATIC, /* through middles that are the ends' average made unit */
    BUMP_FRAMES,    /* through middles in a frame made there of the ends' averages */
    BUMP_UPRIGHT,   /* the same, T turned to a right angle with N (Gram and Schmidt) */
};

/* The map's normal at u, v, as packed: the nearest texel's, or between the middles of four. */
void bump_normal(const struct decode_texture *map, double u, double v, double normal[3]);

/* Fills shading->turned, for a method of some kind. */
void bump_setup(struct shading *shading, enum bump_kind kind);

/* The colour under shading->relief, the map's normal there. */
void bump_pixel(const struct shading *shading, enum bump_kind kind, const double at[3], double colour[3]);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Bump maps: normals N' = (-Fu, -Fv, 1) / |.| of a height over the texture coordinates (Hast et al. 2002, eq. 2), from
 * a height map, from a normal map, or made. Rows run from the top, v = 1, down, as a picture's.
 */
#ifndef RELIEF_H
#define RELIEF_H

#include "scene/model.h"

#define RELIEF_STEEPNESS 0.5 /* the steepest slope of a height, where nothing else is said */

enum relief_kind {
    RELIEF_BUMPS, /* a round hill in the middle of each cell */
    RELIEF_WAVES, /* crests along v, one a cell */
    RELIEF_NOISE, /* Perlin's ("Improving Noise", 2002), four octaves */
    RELIEF_KINDS
};

/* Each gives the texture its size, and normals instead of colours. `heights` is [height][width]; slopes are taken
 * between the texels beside one another, clamped at the borders where the texture is, and scaled so that the steepest
 * is `steepness`; `across` and `down` are the texels of a unit of height in either direction, to some scale. */
void relief_from_heights(struct model_texture *texture, const double *heights, unsigned width, unsigned height,
                         double across, double down, double steepness);

/* A normal map's picture: x, y and z as 0..255 for -1..1, y up. A normal that does not point outwards is taken for
 * straight up. */
void relief_from_normals(struct model_texture *texture, const uint8_t *rgb, unsigned width, unsigned height);

/* cells[0] x cells[1] of a kind on size[0] x size[1] texels; it repeats. */
void relief_make(struct model_texture *texture, enum relief_kind kind, const unsigned size[2], const unsigned cells[2],
                 double steepness);

#endif

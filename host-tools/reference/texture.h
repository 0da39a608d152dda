/* SPDX-License-Identifier: MIT */
/* Texels in double precision. */
#ifndef REFERENCE_TEXTURE_H
#define REFERENCE_TEXTURE_H

#include "reference/decode.h"
#include "reference/method.h"

/* The colour 0..1 of a texture at u, v: of the nearest texel, or linear between the middles of four. */
void texture_sample(const struct decode_texture *texture, double u, double v, double rgb[3]);

/* The texel at column and row, as texel_at() gives it. */
uint32_t texture_nearest(const struct decode_texture *texture, double column, double row);

/* What the material's texture multiplies the diffuse light of a pixel by; 1 without one. `uv` of the pixel. */
void texture_factors(const struct decode_material *material, const double uv[2], unsigned channels, double factor[3]);

/* Whether a method knows finished colours alone, highlights included: a texture multiplies all of it. */
bool texture_multiplies_all(const struct method *method);

#endif

/* SPDX-License-Identifier: MIT */
/* Texture coordinates and texels of a run of pixels. */
#ifndef GLINT_RASTER_TEXTURE_H
#define GLINT_RASTER_TEXTURE_H

#include "raster/raster.h"

/* Fills r->uv for n pixels from (x, y), as uv_setup() has left it; uses r->value[0] and r->divisor. */
void texture_coordinates(struct raster *r, int x, int y, int n);

/* Multiplies r->sum by the texels at r->uv, and adds r->gloss where that is apart. Uses r->value and r->uv. */
void texture_stage(struct raster *r, int n);

#endif

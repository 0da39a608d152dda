/* SPDX-License-Identifier: MIT */
/*
 * Texture coordinates quadratic over parts of a triangle ("Quadratic Interpolation in Hardware Rendering", section 3):
 * it is split into 4 by the middles of its edges while the quadratic errs by more than is allowed. The paper looks at
 * the centre, where the error can be .4 of the largest; here it is the bound of plan/texture.h. Lighting stays the
 * whole triangle's.
 */
#ifndef GLINT_SPLIT_H
#define GLINT_SPLIT_H

#include "raster/runs.h"
#include "shade/uv.h"

#define SPLIT_DEPTH 4 /* times a triangle is split at most */

/* 1 if the triangle in hand can be split, and is ready for it; what is too thin for quadratics cannot. */
int split_begin(struct raster *r, const struct uv_corners *uv);

/* Draws it; `e` is overwritten. Returns the pixels that passed the depth test. */
uint32_t split_draw(struct raster *r, struct edges *e, runs_shade *shade);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Texture coordinates over a triangle, Q28 modulo 16 turns (channels setup->uv[0] and [1]), from Q12 at the vertices.
 * With s_i = 1/w_i and barycentrics l_i on the screen the true ones are sum ui si li / S, S = sum si li.
 *
 *   affine       sum ui li
 *   quadratic    through the corners and the true values at the middles of the edges on the screen, as the hardware
 *                paper has it (section 2): (ui si + uj sj) / (si + sj) there, so that the bulge of the edge is
 *                    aij = -2 (ui - uj) (si - sj) / (si + sj)
 *   split        the same over parts, the triangle halved at the middles of its edges where it errs too much
 *   perspective  P / W at each pixel (perspective.h)
 *
 * With d the largest difference of ui and q = (s - s') / (s + s') of the largest and the smallest si, no pixel errs by
 * more than
 *   affine       d q / (1 + sqrt(1 - q^2))                  (proof in plan/texture.c)
 *   quadratic    d q^2 (.1927 + .1 q + .2 q^2), q <= 3/4    (derived and verified there)
 */
#ifndef GLINT_UV_H
#define GLINT_UV_H

#include "glint.h"
#include "plan/texture.h"
#include "shade/perspective.h"

/* Of the input's corners: Q28, and the si in Q16 by a common factor, the largest at least 2^15. */
struct uv_corners {
    int32_t value[2][3];
    uint16_t s[3];
    uint8_t up;      /* as in struct perspective */
    uint8_t distant; /* all si are taken for one: the true coordinates are linear on the screen */
};

void uv_corners(struct uv_corners *uv, const struct shade_input *in);

/* What the corners' coordinates span, of the surface's texture. */
struct texture_spread uv_spread(const struct uv_corners *uv, const struct surface_texture *texture);

/* (si - sj) / (si + sj) in Q30. */
int32_t uv_ratio(uint32_t si, uint32_t sj);

/* The bulge of an edge, Q26, from the difference ui - uj in Q28 and its ratio. A quarter of it is what the true value
 * in the middle lies below the mean. */
static inline int32_t uv_bulge(int64_t difference, int32_t ratio)
{
    return fx_s32(-((difference * ratio) >> 31)); /* 2^32 * 2^30; at most 2^31 by a little, where it wraps: 16 turns */
}

/* Fills setup->uv and setup->uv_kind. A triangle at one distance becomes affine, whatever is asked for; one that is too
 * thin for a quadratic, and what is left of `split` and of the default, perspective. */
void uv_setup_corners(struct shade_setup *setup, const struct uv_corners *uv, unsigned kind);

/* The same from the input. */
void uv_setup(struct shade_setup *setup, const struct shade_input *in, unsigned kind);

#endif

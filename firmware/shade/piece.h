/* SPDX-License-Identifier: MIT */
/*
 * Quantities over a piece of a triangle that clipping made: what is linear or quadratic over the triangle is so over
 * the piece, from other corner values. w[k] are the barycentric weights of the piece's corner k in the triangle, Q15,
 * of sum 2^15.
 */
#ifndef GLINT_PIECE_H
#define GLINT_PIECE_H

#include "shade/perspective.h"

/* Values at the corners, of any format, |v| <= 2^15: replaced by those at the piece's. */
void piece_linear(const uint16_t (*w)[3], int32_t value[3]);

/* Values in Q14, |v| <= 2^15, and bulges in Q28 of Phi = sum vi li - sum aij li lj: replaced by those of the same
 * polynomial over the piece. A bulge grows by a quarter at most, and is saturated. */
void piece_quadratic(const uint16_t (*w)[3], int32_t value[3], int32_t bulge[3]);

/* Three components, |v| <= 2^15, of the triangle's corners as linear channels, of the piece where in->weight is. */
void piece_vectors(struct shade_setup *setup, const struct shade_input *in, const int16_t *const corner[3],
                   struct channel *out);

/* Where a light or the eye is near, what a pixel must know besides its normal: the place, channels 3 to 5, Q16 position
 * units. */
void piece_place(struct shade_setup *setup, const struct shade_input *in);

/* The same as numerators: of the vectors; of half the place, so that no rounding takes the quotient past 31 bits, and W
 * itself in SHADE_WEIGHT. */
void piece_vectors_perspective(struct shade_setup *setup, const struct shade_input *in,
                               const struct perspective *perspective, const int16_t *const corner[3],
                               struct channel *out);
void piece_place_perspective(struct shade_setup *setup, const struct shade_input *in,
                             const struct perspective *perspective);

#endif

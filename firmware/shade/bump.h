/* SPDX-License-Identifier: MIT */
/*
 * Bump mapping (Hast, Barrera, Bengtsson, "Improved Bump Mapping by using Quadratic Vector Interpolation", 2002). At
 * each corner the light's and the half-way direction are turned into the moving frame T, B, N: L' and H'. These are
 * interpolated over the triangle and multiplied with the map's normals at the pixels:
 *   linear       as they are
 *   quadratic    through six samples (eq. 5-11), so nearly unit that nothing is divided
 *   normalised   linear over their own length, whose square is a quadratic (eq. 33-42), which is the truth
 */
#ifndef GLINT_BUMP_H
#define GLINT_BUMP_H

#include "shade/shade.h"

/* A light's channels from bump[BUMP_CHANNELS * light] on: L' and H', Q30, |.| <= 7/6; numerators in perspective. Where
 * setup.length is set there is one light, and 1 less the squared lengths stand behind. */
#define BUMP_HALF     3
#define BUMP_CHANNELS 6
#define BUMP_SQUARE   (BUMP_CHANNELS * SHADE_BUMP_LIGHTS)

/* Where L' and H' in the middle of an edge come from. */
enum bump_middle {
    BUMP_AVERAGE, /* the ends' average made unit */
    BUMP_FRAME,   /* a new frame there, of the ends' averages made unit: T and N are not at right angles */
    BUMP_UPRIGHT, /* the same after Gram and Schmidt */
};

/* T, B and N of a corner or a middle, Q14, |.| <= 1 + 2^-10 each. */
struct bump_frame {
    q14_t axis[3][3];
};

/* What becomes of v in the frame. */
void bump_turn(const struct bump_frame *frame, const q14_t v[3], int16_t out[3]);

/* The frame from a tangent and a normal, and the tangent's sign. */
void bump_make_frame(const q14_t tangent[3], int sign, const q14_t normal[3], struct bump_frame *out);

/* The bulge in Q28 of each component on the edge from a to b, unit vectors in Q14, whose middle is their average made
 * unit. */
void bump_average(const int16_t a[3], const int16_t b[3], int32_t bulge[3]);

/* What plan/bump.h asks of the triangle in hand: (1 - Vi.Vj) / 2 of L' and H' on its edges, Q16, of each light. */
void bump_bends(const struct shade_input *in, uint16_t bend[SCENE_MAX_LIGHTS][2][3]);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * From a triangle's corners, its vertex normals and a light to the quadratic of N.L on the screen, in the ways that
 * Barrera, Hast and Bengtsson (2006, "X" below) compare in their Table 1, and two of them in other forms.
 *
 * Six samples I1 I2 I3 I12 I23 I13, mid-edge ones by normals of length 1 (X eq. 1-6):
 *   lee-jen        Lee and Jen 2001, share terms after eq. 9; the reciprocal of w3 is taken once
 *   abbas          Abbas and others 2001, section 2, as printed, with E32 D23 - E23 D32 below T4 and T5, where both
 *                  terms are printed alike; divides by Y2, so there is no answer where that is 0
 *   abbas-safe     the same coefficients over the square of the determinant
 *   seiler         a reconstruction: his abstract gives no formulas. Known of it: Lee and Jen have his share terms and
 *                  fewer divisions, and he divides by what can be 0. So c and e follow by substitution, over y1
 *   hast           the ortho-normalised triangle, X eq. 16 and 18-22
 * From the normals alone:
 *   x              X eq. 32 and 18-22
 *   x-k            the same with (Ni.Nj - 1)/2 from the mesh
 *   x-products     that, and sums of products over the determinant as Lee and Jen's in place of eq. 20-22: what the
 *                  renderer does
 *
 * All are relative to corner 0 itself, without a sub-pixel step, and each begins with the three dot products N.L.
 */
#ifndef SETUP_H
#define SETUP_H

#include "shade/plane.h"

#define SETUP_SIZE 1024 /* of the picture, pixels: for plane_setup() */

/* A triangle as integers. Edges are 0-1, 1-2, 2-0. */
struct setup_case {
    int16_t place[3][2];  /* 28.4 from the picture's centre, clockwise with y down */
    int16_t normal[3][3]; /* Q14, length 1, at most 90 degrees apart */
    int16_t light[3];     /* Q14, length 1 */
    uint16_t bend[3];     /* -k = (1 - Ni.Nj) / 2 of the edges, Q16 */
    int16_t lights[3][2]; /* N.L at the corners as a vertex record has it, Q14, for the renderer's own set-up */
};

/* Triangle `n` of an endless list: 8 to 128 pixels high and about as wide, corner 1 a fourth to three fourths down,
 * which the forms that divide by y1 need; normals up to 45 degrees apart. */
void setup_case_make(struct setup_case *c, uint32_t n);

/* What is known of N.L: values in Q14, |v| <= 2^14 + 1; of the edges either the middle samples or the bulges
 * aij = (Ii + Ij) kij, Q28. */
struct setup_samples {
    int32_t value[3];
    int32_t edge[3];
};

/*
 * In integers. Coefficients in Q30 of full intensity (Q22 in display units), powers of a pixel.
 * sample: the samples of a case. solve: the coefficients from them, or 0 where this way has none; `plane` is the
 * triangle's place, with plane_setup_quadratic(), and not thin.
 */
struct setup_integer {
    const char *name;
    void (*sample)(const struct setup_case *c, struct setup_samples *out);
    int (*solve)(const struct plane *plane, const struct setup_samples *s, struct polynomial *out);
    /* both and plane_setup(), which a compiler sees as one: what is measured */
    int (*setup)(const struct setup_case *c, struct polynomial *out);
};
extern const struct setup_integer setup_integers[];
extern const unsigned setup_integer_count;

/* Places of corners 1 and 2 in 28.4, and six samples: Abbas as printed, in numbers with a mantissa and an exponent. */
int setup_abbas_literal(const struct plane *plane, const struct setup_samples *s, struct polynomial *out);

/* What the renderer does of a triangle under one light without a highlight: plane_setup() and shade_x(). The three
 * dot products are done before, once a vertex; the sub-pixel step to the origin's centre is done here. */
int setup_renderer(const struct setup_case *c, struct polynomial *out);

#endif

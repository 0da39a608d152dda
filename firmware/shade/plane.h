/* SPDX-License-Identifier: MIT */
/*
 * Polynomials over a triangle on the screen, in integers.
 *
 * A polynomial is taken at pixel centres, relative to the pixel of the picture nearest to corner 0 (the origin): at
 * column i and row j from there it is f + d i + e j + a i^2 + b j^2 + c i j, exactly, modulo 2^32. As the true value
 * fits 32 bits, every way of stepping gives the same bits.
 *
 * Set-up costs one reciprocal a triangle; a channel costs 2 (linear) or 14 (quadratic) high products and no division.
 * Formulas: X-shading eq. 18-22, here in whole numbers with the corner differences first scaled to 14 bits.
 */
#ifndef GLINT_PLANE_H
#define GLINT_PLANE_H

#include "geometry/transform.h"

struct polynomial {
    uint32_t f, d, e, a, b, c;
};

/* The triangle's place on the screen, common to its channels. */
struct plane {
    int32_t whole_x1, whole_y1, whole_x2, whole_y2; /* corners 1 and 2 from corner 0, sub-pixels, at most 2^15 */
    int32_t x1, y1, x2, y2;                         /* the same times 2^scale: of scale >= 0 below 2^14 */
    int32_t scale;                                  /* -2..13; where negative, low bits are lost */
    uint32_t det;                                   /* whole_x1 whole_y2 - whole_x2 whole_y1, in (0, 2^30] */
    int32_t up;                                     /* its leading zero bits */
    uint32_t r;                                     /* 2^63 / (det << up) */
    int32_t half;                                   /* r / 2 */
    int32_t shift;                                  /* of a gradient's product: up - scale - 14 */
    int32_t r2;                                     /* r^2 / 2^33: set by plane_setup_quadratic() */
    int32_t ox, oy;                                 /* the origin pixel */
    int32_t fx, fy; /* its centre from corner 0, 1/16 pixel: -7..8 with corner 0 in the picture, else up to 2^15 */
    uint8_t sliver; /* no polynomial is accurate enough over it */
    uint8_t slim;   /* no quadratic is; this and what follows are set by plane_setup_quadratic() */
    uint8_t thin;   /* no quadratic in 32 bits is: it takes 64 */
    uint8_t far;    /* the same because of its size or place */
};

enum plane_exact { PLANE_EXACT = 1, PLANE_EXACT_WIDE = 2 }; /* corner values times 2^16, or as they are */

/* One quantity over a triangle: a polynomial, or where that would not do, its corner values, from which it is
 * computed at each pixel by exact barycentric coordinates. */
struct channel {
    int exact; /* enum plane_exact; 0: a polynomial */
    union {
        struct polynomial p;
        struct {
            int32_t value[3];
            int32_t bulge[3];
        } corner;
    };
};

/*
 * From corners p[k] = x, y in 28.4 about the centre of a picture `width` x `height`, |p| <= GUARD, y down, in the
 * order that makes the determinant positive; 0 if it is not.
 */
int plane_setup(struct plane *plane, const int16_t *const p[3], unsigned width, unsigned height);

/* What quadratics need besides; once a triangle, before the first. */
void plane_setup_quadratic(struct plane *plane);

/* A linear channel from corner values, any two of them less than 2^16 apart; the channel's value is 2^16 times that.
 * Inside the triangle within 2^16 + 5 of it, which is 1/64 of a display unit; of more than 1024 pixels, where corner
 * values are rounded, another 2^16 and at 2048 another 2^17; by corner values, 2^17 + 8. */
void plane_linear(const struct plane *plane, const int32_t value[3], struct channel *channel);

/* A linear channel of any 32-bit corner values, in 64 bits. */
void plane_linear_wide(const struct plane *plane, const int32_t value[3], struct channel *channel);

/* A quadratic channel in Q30: corner values in Q14, |v| <= 2^14 + 2^11, and the bulges of the edges 0-1, 1-2, 2-0 in
 * Q28: Phi = sum Ii li - sum aij li lj, so that a mid-edge sample is (Ii + Ij) / 2 - aij / 4; for X-shading (eq. 32,
 * order-free) aij = (Ii + Ij) kij, which for unit normals is below .77. |a| <= PLANE_MOST_BULGE: of alternating signs,
 * 2^28 would make the mixed difference 2.14 * 2^30 at the lowest height; or 2^28 where an edge bends half as much, as
 * colours do. */
#define PLANE_MOST_BULGE ((1u << 28) / 32 * 29)
void plane_quadratic(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                     struct channel *channel);

/* The same for any bulges, as long as |Phi| < 2 over the triangle, in 64 bits; and with corner values in Q30. */
void plane_quadratic_large(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                           struct channel *channel);
void plane_quadratic_wide(const struct plane *plane, const int32_t value_q30[3], const int32_t bulge[3],
                          struct channel *channel);

/* Values of a channel at n pixels from (x, y) rightwards; y down, picture coordinates. */
void plane_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out);

/* Where no polynomial would do: what plane_values() does then, and what a channel keeps for it (`bulge` null: linear).
 */
void plane_keep_corners(struct channel *channel, const int32_t value[3], const int32_t bulge[3]);
void plane_exact_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out);

#endif

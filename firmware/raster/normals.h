/* SPDX-License-Identifier: MIT */
/* Pixels from interpolated normals, made unit and lit at each, in the object's axes. */
#ifndef GLINT_NORMALS_H
#define GLINT_NORMALS_H

#include "raster/raster.h"

/* A normal times a power of 2, |v| in [2^15, 2^16), and 2^45 / |v|: dot products are taken of it as it is, and then
 * divided. So what v was rounded by turns it a little, but leaves its length exact, on which a high power depends. */
struct normals_vector {
    int32_t x, y, z, inverse; /* the inverse is at most 2^30 */
};

/* Of Q15, or any such numbers; `squared` is the sum of the squares, not 0. */
static inline __attribute__((always_inline)) struct normals_vector normals_vector(int32_t x, int32_t y, int32_t z,
                                                                                  uint32_t squared)
{
    const unsigned up = fx_clz(squared) & ~1u; /* to [2^30, 2^32) by a square's factor */
    const int32_t half = 1 << up / 2;
    return (struct normals_vector){x * half, y * half, z * half, fx_s32(fx_rsqrt_norm(squared << up) >> 1)};
}

/* N . u of a unit vector in Q14, in Q30, at most 1 + 2^-12: |v| |u| < 2^30 (1 + 2^-12) and so is every partial sum; the
 * high product is 2^27 of it. */
static inline __attribute__((always_inline)) q30_t normals_dot(const struct normals_vector *v, const q14_t u[3])
{
    return fx_mulhi_s32(v->x * u[0] + v->y * u[1] + v->z * u[2], v->inverse) * 8;
}

/* What 1 / |u| is beyond 1, Q29, of a unit vector in Q14 within 2^-12: below 2^17. */
static inline int32_t normals_shortness(const q14_t u[3])
{
    return (1 << 28) - (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
}

/* N.H > 0 by a vector that is that much too short: 2^13 (1 + 2^-12) * 2^17. */
static inline q30_t normals_lengthened(q30_t highlight, int32_t shortness)
{
    return highlight + ((highlight >> 17) * shortness >> 12);
}

/* Shades n pixels from (x, y): channels 0 to 2 are the normal in Q30, less than 1.2 long, and 3 to 5 the place (where
 * lights need it). Normals shorter than 2^-18 count as none, and such a pixel has ambient light only. */
void normals_run(struct raster *r, int x, int y, int n);

/* The same for numerators of perspective.h, or without setup.perspective for normals of any length: shorter than 2^-18
 * is none. */
void normals_run_perspective(struct raster *r, int x, int y, int n);

/* The same for normals that stand in r->value[0] to [2], in any format: shorter than 2^12 is none. */
void normals_shade(struct raster *r, int x, int y, int n);

#endif

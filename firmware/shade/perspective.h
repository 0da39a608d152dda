/* SPDX-License-Identifier: MIT */
/*
 * Perspective-correct interpolation (Lee and Jen, eq. 10-13). With s_i = 1/w_i and screen barycentrics l_i, those of
 * space are s_i l_i / W, W = sum s_i l_i. So a linear quantity is P / W and a quadratic one Q / W^2, where
 *     P = sum Ii si li
 *     Q = sum Ii si^2 li^2 + sum_{i<j} (Ii + Ij - aij) si sj li lj
 * are linear and quadratic on the screen: the ordinary channels. A direction (a normal) needs no division, as
 * normalising it takes W away. W itself is the depth: closeness is near / w, linear on the screen.
 *
 * What the polynomials err by grows by 1 / W^2: where W spans 1.6 to 1 over a triangle across a 320x240 picture, at
 * most .03 of 1/256 besides; 4 to 1, .12; 17 to 1, 2.
 */
#ifndef GLINT_PERSPECTIVE_H
#define GLINT_PERSPECTIVE_H

#include "shade/shade.h"

/* s_i of the corners in Q16, by a common factor such that the largest lies in [1/2, 1). */
struct perspective {
    uint16_t s[3];
    uint8_t up; /* s is closeness times 2^up */
    /* perspective_quadratic(): by pointer, so that only methods that are correct in perspective link it */
    void (*quadratic)(const struct perspective *p, const struct plane *plane, const int32_t value[3],
                      const int32_t bulge[3], struct channel *channel);
};

/* Returns 0, and perspective makes no difference, for an orthographic view or a triangle at one distance. */
int perspective_setup(struct perspective *p, const struct shade_input *in);

/* The channel of P: corner values in Q14, |v| <= 2^15; P in Q30, at most 2 |v|. */
void perspective_linear(const struct perspective *p, const struct plane *plane, const int32_t value[3],
                        struct channel *channel);

/* Q's own corner values, Q30, and bulges, Q28, of a quadratic's: values in Q14, |v| <= 2^15, bulges in Q28, any. */
void perspective_numerator(const struct perspective *p, const int32_t value[3], const int32_t bulge[3], int32_t v[3],
                           int32_t b[3]);

/* The channel of Q in Q30: corner values in Q14, bulges in Q28, |Phi| < 2. */
void perspective_quadratic(const struct perspective *p, const struct plane *plane, const int32_t value[3],
                           const int32_t bulge[3], struct channel *channel);

/* From the depth channel's value, 1 / W = (reciprocal / 2^31) 2^up' / 2: reciprocal in [2^31, 2^32), up' leading zero
 * bits of W in Q32. */
struct perspective_divisor {
    int32_t half; /* reciprocal / 2, in [2^30, 2^31) */
    uint32_t up;
};

/* From W in Q32 itself, not 0. */
static inline struct perspective_divisor perspective_divisor_of(uint32_t w)
{
    const unsigned zeros = fx_clz(w);
    return (struct perspective_divisor){fx_s32(fx_recip_norm(w << zeros) >> 1), zeros};
}

/* W is at least a unit of the depth, as corners have; so up' <= 15, and twice it can be shifted by. */
static inline struct perspective_divisor perspective_divisor(uint32_t depth, unsigned up)
{
    const uint32_t least = 1u << 16, far = fx_u32(DEPTH_FAR) << 16;
    uint32_t w = depth > far + least ? depth - far : least;
    unsigned zeros = fx_clz(w);
    return (struct perspective_divisor){fx_s32(fx_recip_norm(w << zeros) >> 1), zeros > up ? zeros - up : 0};
}

/* P / W of |P| < |v| W: the result is below 2^31 where |v| is. With W = w 2^-up, w in [1/2, 1): P 2^up is v w, below
 * 2^31, and half / 2^30 is 1 / w. The lowest two bits are lost. */
static inline int32_t perspective_divide(int32_t p, struct perspective_divisor by)
{
    return fx_shl(fx_mulhi_s32(fx_shl(p, by.up), by.half), 2);
}

/* Q / W^2 likewise. */
static inline int32_t perspective_divide_twice(int32_t q, struct perspective_divisor by)
{
    int32_t once = fx_shl(fx_mulhi_s32(fx_shl(q, 2 * by.up), by.half), 2);
    return fx_shl(fx_mulhi_s32(once, by.half), 2);
}

#endif

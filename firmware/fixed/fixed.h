/* SPDX-License-Identifier: MIT */
/*
 * Fixed-point types and operations. A type's name carries its count of fraction bits; a raw integer that holds one
 * carries it as a suffix (`_q14`). Only this folder shifts by a Q constant of its own.
 *
 * Every function gives the same bits on every machine: no floating point, no arithmetic whose width depends on the
 * CPU. Right shifts of negative values are arithmetic (all supported compilers; checked in fixed.c).
 */
#ifndef GLINT_FIXED_H
#define GLINT_FIXED_H

#include "fixed/checked.h"

/*
 * What the instruction set lacks. Narrow: a 32x32->64 multiply and count-leading-zeros (ARMv6-M, ARMv8-M baseline). The
 * functions whose names end in _narrow are what such a CPU runs; they give the same bits and are tested on any machine.
 */
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
#define FX_NARROW 1
#else
#define FX_NARROW 0
#endif
#if defined(__ARM_ARCH_6M__)
#define FX_NO_DIVIDE 1
#else
#define FX_NO_DIVIDE 0
#endif

/* Marks a function that is called a few times a frame or object at most, where its neighbours are not: compiled for
 * size, and kept out of what calls it. */
#define FX_COLD __attribute__((cold, noinline))

typedef int16_t q14_t;   /* unit vectors, +-2 */
typedef int32_t q16_t;   /* lengths, linear intensities, +-32768 */
typedef int32_t q22_t;   /* display units (256 = full intensity), +-512; the same bits are q30_t of full intensity */
typedef int32_t q30_t;   /* full precision unit values, +-2 */
typedef int32_t q28_4_t; /* screen coordinates, 1/16 pixel */

/* A constant num/den in Qn, rounded to nearest, halves away from 0; den > 0. One that does not fit does not compile. */
#define FX_Q_WIDE(n, num, den) \
    (((num)*fx_wrap_s64(2) * (INT64_C(1) << (n)) + (1 - 2 * ((num) < 0)) * fx_wrap_s64(den)) / (2 * fx_wrap_s64(den)))
#define FX_Q_IN(bits, x) \
    (fx_wrap_s32(x) + 0 * fx_wrap_s32(sizeof(char[1 - 2 * (fx_wrap_u64(((x) >> ((bits)-1)) + 1) > 1)])))
#define FX_Q(n, num, den) FX_Q_IN(32, FX_Q_WIDE(n, num, den))
#define Q14(num, den)     fx_wrap_s16(FX_Q_IN(16, FX_Q_WIDE(14, num, den)))
#define Q15(num, den)     FX_Q(15, num, den)
#define Q16(num, den)     FX_Q(16, num, den)
#define Q22(num, den)     FX_Q(22, num, den)
#define Q30(num, den)     FX_Q(30, num, den)

/* The high word of a product from 16-bit halves: 4 multiplies of 32 bits. */
static inline uint32_t fx_mulhi_u32_narrow(uint32_t a, uint32_t b)
{
    uint32_t a0 = a & 0xffffu, a1 = a >> 16, b0 = b & 0xffffu, b1 = b >> 16;
    /* (2^16 - 1)^2 + 2^16 - 1 < 2^32, both times */
    uint32_t mid = a1 * b0 + (a0 * b0 >> 16);
    uint32_t low = a0 * b1 + (mid & 0xffffu);
    return a1 * b1 + (mid >> 16) + (low >> 16);
}
static inline int32_t fx_mulhi_s32_narrow(int32_t a, int32_t b)
{
    uint32_t a0 = fx_wrap_u32(a) & 0xffffu, b0 = fx_wrap_u32(b) & 0xffffu;
    int32_t a1 = a >> 16, b1 = b >> 16;
    /* -2^15 (2^16 - 1) <= each sum <= (2^15 - 1)(2^16 - 1) + 2^16 - 1 = 2^15 (2^16 - 1) */
    int32_t mid = a1 * fx_s32(b0) + fx_s32(a0 * b0 >> 16);
    int32_t low = fx_s32(a0) * b1 + (mid & 0xffff);
    return a1 * b1 + (mid >> 16) + (low >> 16);
}

/* floor(a * b / 2^32), all arguments. */
#if FX_NARROW && defined(__thumb__)
uint32_t fx_mulhi_u32(uint32_t a,
                      uint32_t b); /* calls: inline, they would drive everything else from eight registers */
int32_t fx_mulhi_s32(int32_t a, int32_t b);
#else
static inline uint32_t fx_mulhi_u32(uint32_t a, uint32_t b)
{
#if FX_NARROW
    return fx_mulhi_u32_narrow(a, b);
#else
    return fx_u32(fx_u64(a) * b >> 32);
#endif
}
static inline int32_t fx_mulhi_s32(int32_t a, int32_t b)
{
#if FX_NARROW
    return fx_mulhi_s32_narrow(a, b);
#else
    return fx_s32(fx_s64(a) * b >> 32);
#endif
}
#endif

static inline unsigned fx_clz_narrow(uint32_t x)
{
    unsigned n = 32;
    if (x >> 16)
        x >>= 16, n -= 16;
    if (x >> 8)
        x >>= 8, n -= 8;
    if (x >> 4)
        x >>= 4, n -= 4;
    if (x >> 2)
        x >>= 2, n -= 2;
    return x >> 1 ? n - 2 : n - x;
}

/* *x += step modulo 2^32, for loops that hold more steps than an ARMv6-M has low registers: its compilers would load
 * each step from the stack for every pixel, though an addition reads a high register as well. */
FX_WRAPS static inline __attribute__((always_inline)) void fx_step(uint32_t *x, uint32_t step)
{
#if FX_NARROW && defined(__thumb__)
    __asm__("add %0, %1" : "+l"(*x) : "h"(step));
#else
    *x += step;
#endif
}

/* x >> down, x signed, within [0, 2^bits): bits and down constants, bits + down < 32. An instruction of ARMv7-M, which
 * compilers do not make of the clamp and the shift together. */
#if defined(__ARM_ARCH_7M__) || defined(__ARM_ARCH_7EM__)
#define fx_saturated(x, bits, down)                                                                          \
    (__extension__({                                                                                         \
        uint32_t fx_out;                                                                                     \
        if (down)                                                                                            \
            __asm__("usat %0, %2, %1, asr %3" : "=r"(fx_out) : "r"(x), "I"(bits), "I"((down) ? (down) : 1)); \
        else                                                                                                 \
            __asm__("usat %0, %2, %1" : "=r"(fx_out) : "r"(x), "I"(bits));                                   \
        fx_out;                                                                                              \
    }))
#else
static inline __attribute__((always_inline)) uint32_t fx_saturated(uint32_t x, unsigned bits, unsigned down)
{
    uint32_t y = x >> down;
    FX_REQUIRE(bits > 0 && bits + down < 32, bits, down);
    if (__builtin_expect(y >> bits != 0, 0))
        y = ~fx_wrap_u32(fx_wrap_s32(x) >> 31) >> (32 - bits);
    return y;
}
#endif

/* Leading zero bits of x > 0. */
static inline unsigned fx_clz(uint32_t x)
{
    FX_REQUIRE(x > 0, x, 0);
#if FX_NARROW
    return fx_clz_narrow(x);
#else
    return fx_u32(__builtin_clz(x));
#endif
}

#define FX_DIVMOD_MOST ((1 << 30) + (1 << 19))

/* As fx_divmod_floor(), by a division of unsigned numbers: floor(n / d) = ~floor(~n / d). */
static inline void fx_divmod_floor_narrow(int32_t num, int32_t den, int32_t *quotient, int32_t *remainder)
{
    int32_t sign = num >> 31;
    uint32_t n = fx_u32(num ^ sign), d = fx_u32(den); /* n <= 2^30 + 2^19 */
    FX_REQUIRE(num <= FX_DIVMOD_MOST && num >= -FX_DIVMOD_MOST && den > 0 && den <= 1 << 30, num, den);
    uint32_t q = n / d;
    int32_t r = fx_s32(n - q * d); /* q d <= n */
    *quotient = fx_s32(q) ^ sign;
    *remainder = sign ? den - 1 - r : r;
}

/*
 * quotient = floor(num / den), remainder = num - quotient * den in [0, den), for |num| <= 2^30 + 2^19, 0 < den <= 2^30.
 * On ARMv6-M it is libgcc's __aeabi_uidiv and costs 23 instructions for quotients of -2..1, 66 for 0..319, 11
 * elsewhere: keep the quotient small there.
 */
static inline void fx_divmod_floor(int32_t num, int32_t den, int32_t *quotient, int32_t *remainder)
{
#if FX_NO_DIVIDE
    fx_divmod_floor_narrow(num, den, quotient, remainder);
#else
    FX_REQUIRE(num <= FX_DIVMOD_MOST && num >= -FX_DIVMOD_MOST && den > 0 && den <= 1 << 30, num, den);
    int32_t q = num / den;
    int32_t r = num - q * den; /* |q den| <= |num|, |r| < den */
    int32_t below = r >> 31;   /* -1 where C's quotient, rounded to zero, is above the floor */
    *quotient = q + below;
    *remainder = r + (below & den);
#endif
}

/* n / d for d != 0, rounded towards 0 as the operator does; with sign, |n|, |d| < 2^63. A bit of the quotient at a
 * time: a few a frame, for which libgcc's division by table and halves takes 700 to 1100 bytes more. */
uint64_t fx_divide_u64(uint64_t n, uint64_t d);
int64_t fx_divide_s64(int64_t n, int64_t d);

/* floor(sqrt(x)), a bit at a time. */
uint32_t fx_root(uint32_t x);

/*
 * 2^63 / m for m in [2^31, 2^32): in [2^31, 2^32 - 1], within 2^-30.46 of the true value (worst at 0xf7ffbdd0), which
 * is exceeded by at most 2^-30.72. A 256-byte table, no division: 19 instructions with the call on Cortex-M4, 36 on
 * M0+.
 */
uint32_t fx_recip_norm(uint32_t m);

/*
 * 2^46 / sqrt(m) for m in [2^30, 2^32): in (2^30, 2^31], within 2^-20.64 of the true value. With v = m / 2^30 in [1, 4)
 * that is 1/sqrt(v) in Q31. A 192-byte table: 16 instructions with the call on Cortex-M4, 25 on M0+.
 */
uint32_t fx_rsqrt_norm(uint32_t m);

/*
 * Sine and cosine in Q30 of an angle of turn / 2^32 turns, within 1.19 * 2^-30 and never beyond +-1; odd and even as
 * they should be; exact at multiples of a quarter turn.
 */
q30_t fx_sin(uint32_t turn);
FX_WRAPS static inline q30_t fx_cos(uint32_t turn)
{
    return fx_sin(turn + 0x40000000u);
}

/* 2^-x in Q16 of x in Q16: within 7.5 * 2^-16, 65536 at 0, and 0 from 18 on. */
uint32_t fx_exp2_minus(uint32_t x_q16);

/*
 * s^n over the part of [0, 1] where it shows: FX_POWER_STEPS equal steps over [1 - 2^-octave, 1], octave the largest
 * for which (1 - 2^-octave)^n < 2^-9; below that the power counts as 0.
 */
#define FX_POWER_STEPS        128u
#define FX_POWER_MAX_EXPONENT 1023u
#define FX_POWER_MAX_OCTAVE   7u
struct fx_power {
    uint16_t exponent;                  /* n, 1..1023 */
    uint16_t octave;                    /* 0..7 */
    uint16_t value[FX_POWER_STEPS + 2]; /* Q15, 0..32768, at each step; the last repeats the one before */
};

/* Fills the table for n in 1..1023; every value is the true power rounded to nearest, halves up. */
void fx_power_build(struct fx_power *table, unsigned n);

/*
 * s^n in Q15 for any s in Q30, linear between the table's steps; 0 below the table's range, 32768 for s >= 1. Never
 * falls as s rises. Off by at most .29/255 over all exponents in the range (n = 20: .18, 50: .07, 200: .07, 1023: .12)
 * and by less than .5/255 just below it.
 */
FX_WRAPS static inline uint32_t fx_power(const struct fx_power *table, q30_t s)
{
    const uint32_t one = 1u << 30;
    uint32_t span = one >> table->octave;
    FX_REQUIRE(table->octave <= FX_POWER_MAX_OCTAVE, table->octave, table->exponent);
    uint32_t above = fx_wrap_u32(s) - (one - span); /* modulo 2^32 at least 2^30 for any s below the range */
    if (above >= span)
        return s >= fx_s32(one) ? 32768u : 0u;
    uint32_t t = above << table->octave; /* < 2^30: 7 bits of step, 23 of position in it */
    const uint16_t *v = &table->value[t >> 23];
    /* values never fall, a step rises by at most 2^15, the position has 15 bits: < 2^30 */
    return v[0] + (fx_u32(v[1] - v[0]) * (t << 9 >> 17) >> 15);
}

/* s^n in Q15 rounded to nearest, for n in 1..1023 and any s: 0 below 0, 1 above 1. Up to 18 64-bit products. */
uint32_t fx_power_exact(unsigned n, q30_t s);

#endif

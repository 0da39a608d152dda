/* SPDX-License-Identifier: MIT */
/*
 * firmware/fixed: all arguments, or those that fixed.h allows.
 *
 *   proves: fx_mulhi_u32_narrow fx_mulhi_s32_narrow fx_mulhi_u32 fx_mulhi_s32 fx_clz_narrow fx_clz fx_step fx_saturated
 *           fx_divide_u64 fx_divide_s64 fx_root fx_recip_norm fx_rsqrt_norm fx_sin fx_cos fx_exp2_minus
 *   lemmas: divide
 *   options: -eva-precision 3 -eva-min-loop-unroll 64 -eva-slevel 200
 *            -eva-subdivide-non-linear-function fx_recip_norm:1100
 */
#include "proof.h"

#include "contracts.h"

#include "firmware/fixed/divide.c"
#include "firmware/fixed/exponential.c"
#include "firmware/fixed/fixed.c"

volatile uint32_t sink;

/* The function over [first, last], in pieces that end before each of `cuts`, which rise: what is signed in between has
 * one sign in each. */
static void pieces(uint32_t (*function)(uint32_t), uint32_t first, uint32_t last, const uint64_t *cuts, int count)
{
    //@ loop unroll 4;
    for (int i = 0; i < count; i++)
        if (first < cuts[i] && cuts[i] <= last) {
            sink = function(any_u32(first, (uint32_t)cuts[i] - 1));
            first = (uint32_t)cuts[i];
        }
    sink = function(any_u32(first, last));
}

/* The 2^22 arguments up from `first`, or down from `last`, where results are near their bounds: ever larger pieces. */
static void ends(uint32_t (*function)(uint32_t), uint32_t first, uint32_t last, uint32_t unit)
{
    //@ loop unroll 16;
    for (uint32_t i = 0; i < 16; i++) {
        sink = function(any_u32(first + i * unit, first + i * unit + unit - 1));
        sink = function(any_u32(last - i * unit - unit + 1, last - i * unit));
    }
    //@ loop unroll 64;
    for (uint32_t i = 16 * unit; i < 1u << 22; i *= 2) {
        const uint32_t half = i / 2;
        sink = function(any_u32(first + i, first + i + half - 1));
        sink = function(any_u32(first + i + half, first + 2 * i - 1));
        sink = function(any_u32(last - i - half + 1, last - i));
        sink = function(any_u32(last - 2 * i + 1, last - i - half));
    }
}

/* An entry x0 of the table serves 2^23 arguments. What it errs by, e = 2^39 - x0 (m >> 1), changes its sign, its
 * rounded s after it, and last what e^2 adds is less than e for sure. */
static void recip(void)
{
    ends(fx_recip_norm, 0x80000000u, UINT32_MAX, 1);
    //@ loop unroll 256;
    for (uint32_t i = 0; i < 256; i++) {
        const uint32_t first = 0x80000000u + (i << 23) + (i ? 0 : 1u << 22), x0 = 256u + recip_table[i];
        const uint32_t last = 0x807fffffu + (i << 23) - (i < 255 ? 0 : 1u << 22);
        const uint64_t one = (uint64_t)1 << 39;
        const uint64_t cuts[3] = {one / x0 * 2 + 2, (one + 0x4000) / x0 * 2 + 2, (one + (1u << 24)) / x0 * 2 + 2};
        pieces(fx_recip_norm, first, last, cuts, 3);
    }
}

/* The same of 2^24 arguments and h = 2^37 - y0^2 (m >> 9). */
static void rsqrt(void)
{
    ends(fx_rsqrt_norm, 0x40000000u, UINT32_MAX, 512);
    //@ loop unroll 192;
    for (uint32_t i = 0; i < 192; i++) {
        const uint32_t first = 0x40000000u + (i << 24) + (i ? 0 : 1u << 22),
                       y2 = (uint32_t)rsqrt_table[i] * rsqrt_table[i];
        const uint32_t last = 0x40ffffffu + (i << 24) - (i < 191 ? 0 : 1u << 22);
        const uint64_t one = (uint64_t)1 << 37;
        const uint64_t cuts[3] = {(one / y2 + 1) << 9, ((one + 0x10000) / y2 + 1) << 9,
                                  ((one + (1u << 26)) / y2 + 1) << 9};
        pieces(fx_rsqrt_norm, first, last, cuts, 3);
    }
}

/* Each quarter for itself: in all of them the sign of x is known. */
static void sines(void)
{
    //@ loop unroll 4;
    for (uint32_t quarter = 0; quarter < 4; quarter++)
        sink = (uint32_t)fx_sin(any_u32(quarter << 30, (quarter << 30) + 0x3fffffffu));
}

/* One, by which a quotient may be as large as the number, and more. */
static void divide(void)
{
    sink = (uint32_t)fx_divide_u64(any_u64(0, UINT64_MAX), any_u64(1, UINT64_MAX));
    sink = (uint32_t)fx_divide_s64(any_s64(-INT64_MAX, INT64_MAX), any_s64(-INT64_MAX, -2));
    sink = (uint32_t)fx_divide_s64(any_s64(-INT64_MAX, INT64_MAX), -1);
    sink = (uint32_t)fx_divide_s64(any_s64(-INT64_MAX, INT64_MAX), 1);
    sink = (uint32_t)fx_divide_s64(any_s64(-INT64_MAX, INT64_MAX), any_s64(2, INT64_MAX));
}

/* What fits, what is above, what is negative. */
static void saturated(void)
{
    //@ loop unroll 31;
    for (unsigned bits = 1; bits < 32; bits++)
        //@ loop unroll 31;
        for (unsigned down = 0; bits + down < 32; down++) {
            const uint32_t past = 1u << (bits + down - 1) << 1;
            sink = fx_saturated(any_u32(0, past - 1), bits, down);
            if (past && past < 0x80000000u)
                sink = fx_saturated(any_u32(past, 0x7fffffffu), bits, down);
            sink = fx_saturated(any_u32(0x80000000u, UINT32_MAX), bits, down);
        }
}

void prove(void)
{
    uint32_t x = ANY_U32;
    recip();
    rsqrt();
    sines();
    divide();
    sink = (uint32_t)fx_cos(any_u32(0, 0x3fffffffu));
    sink = fx_root(ANY_U32);
    sink = fx_exp2_minus(ANY_U32);
    sink = fx_clz(any_u32(1, UINT32_MAX));
    sink = fx_clz_narrow(any_u32(1, UINT32_MAX));
    sink = fx_mulhi_u32(ANY_U32, ANY_U32);
    sink = (uint32_t)fx_mulhi_s32(ANY_S32, ANY_S32);
    sink = fx_mulhi_u32_narrow(ANY_U32, ANY_U32);
    sink = (uint32_t)fx_mulhi_s32_narrow(ANY_S32, ANY_S32);
    fx_step(&x, ANY_U32);
    saturated();
}

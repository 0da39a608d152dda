/* SPDX-License-Identifier: MIT */
/*
 * How far each of the renderer's functions of one number is from the truth, over its whole domain; of those of two
 * numbers, over as many as a word of both can count. tests/unit/test_exhausted.c walks what takes less than 2 seconds,
 * exhaustive_fixed.c all.
 */
#ifndef UNARY_H
#define UNARY_H

#include "fixed_truth.h"
#include "sweep.h"

#include "glint.h"
#include "plan/texture.h"
#include "raster/spans.h"
#include "scene/texel.h"
#include "shade/dots.h"
#include "shade/perspective.h"
#include "shade/power.h"

static double unary_clz(uint32_t x)
{
    return (double)fx_clz_narrow(x) - (x ? __builtin_clz(x) : 32);
}

static double unary_root(uint32_t x)
{
    const uint64_t r = fx_root(x);
    return r * r <= x && x < (r + 1) * (r + 1) ? 0 : INFINITY;
}

static double unary_exp2(uint32_t x)
{
    return fx_exp2_minus(x) - 65536 * exp2(-(double)x / 65536);
}

/* The argument's bits are scattered over both factors, so that each half takes every value. */
FX_WRAPS static double unary_mulhi(uint32_t x)
{
    uint32_t a = x * 0x9e3779b1u, b = (x ^ x >> 15) * 0x85ebca77u;
    uint32_t u = (uint32_t)((uint64_t)a * b >> 32);
    int32_t s = (int32_t)((int64_t)(int32_t)a * (int32_t)b >> 32);
    return fx_mulhi_u32_narrow(a, b) == u && fx_mulhi_s32_narrow((int32_t)a, (int32_t)b) == s &&
                   fx_mulhi_u32(a, b) == u && fx_mulhi_s32((int32_t)a, (int32_t)b) == s
               ? 0
               : INFINITY;
}

FX_WRAPS static double unary_divmod(uint32_t x)
{
    int32_t num = (int32_t)(x * 0x9e3779b1u) >> 1 >> (x >> 8 & 15),
            den = 1 + (int32_t)((x & 0x7ffffu) >> (x >> 20 & 15));
    int32_t q, r, nq, nr;
    fx_divmod_floor(num, den, &q, &r);
    fx_divmod_floor_narrow(num, den, &nq, &nr);
    return q == nq && r == nr && r >= 0 && r < den && (int64_t)q * den + r == num ? 0 : INFINITY;
}

/* Below 2^16 powers of 2 and their neighbours, of both numbers; from there on any, of every length. */
FX_WRAPS static uint64_t unary_wide(uint32_t x, uint32_t key)
{
    if (x < 256)
        return ((uint64_t)1 << (x >> 2)) + (x & 3) - 1;
    const uint64_t bits = x * (0x9e3779b97f4a7c15u + key) ^ (uint64_t)x << 29;
    return bits >> (bits & 63);
}
FX_WRAPS static double unary_divide(uint32_t x)
{
    const uint64_t n = unary_wide(x < 65536 ? x & 255 : x, 0), d = unary_wide(x < 65536 ? x >> 8 : x, 2) | (x > 65535);
    if (d == 0)
        return 0;
    const int64_t sn = (int64_t)(n >> 1), sd = (int64_t)(d >> 1) | 1;
    return fx_divide_u64(n, d) == n / d && fx_divide_s64(-sn, sd) == -sn / sd && fx_divide_s64(sn, -sd) == sn / -sd
               ? 0
               : INFINITY;
}

/* Every clamp that pixels make. */
static double unary_saturated(uint32_t x)
{
    static const uint8_t form[][2] = {{8, 7},  {15, 15}, {16, 15}, {7, 23}, {6, 24},
                                      {22, 0}, {10, 20}, {10, 18}, {7, 0}};
    double worst = 0;
    for (unsigned i = 0; i < sizeof form / sizeof *form; i++) {
        const int64_t at = (int64_t)(int32_t)x >> form[i][1], most = (1 << form[i][0]) - 1;
        const double e = fx_saturated(x, form[i][0], form[i][1]) - (double)(at < 0 ? 0 : at > most ? most : at);
        worst = e ? e : worst;
    }
    return worst;
}

/* 10 bits of exponent, 20 of s between -1/16 and 17/16. */
static q30_t unary_base(uint32_t x)
{
    return (q30_t)((x & 0xfffffu) * 1152u) - (1 << 26);
}
static double unary_clamped(q30_t s)
{
    return s <= 0 ? 0 : s >= 1 << 30 ? 1 : s * 0x1p-30;
}

static _Thread_local struct fx_power unary_table;
static double unary_power(uint32_t x)
{
    const unsigned n = x >> 20;
    if (n == 0)
        return 0;
    if (unary_table.exponent != n)
        fx_power_build(&unary_table, n);
    return truth_power(&unary_table, unary_base(x));
}

static double unary_power_exact(uint32_t x)
{
    const unsigned n = x >> 20;
    return n ? fx_power_exact(n, unary_base(x)) - 32768 * pow(unary_clamped(unary_base(x)), n) : 0;
}

/* Each of the powers without powers: max(0, 1 - n / g (1 - s))^g, g = 2^squarings. */
static double unary_free(uint32_t x, const struct glint_power *form, int squarings)
{
    const unsigned n = x >> 20;
    int32_t value = unary_base(x);
    double exact = 1 - ldexp(n, -squarings) * (1 - unary_clamped(value));
    if (n == 0)
        return 0;
    exact = exact > 0 && value > 0 ? exact : 0;
    for (int i = 0; i < squarings; i++)
        exact *= exact;
    form->run(n, &value, 1);
    return value - 32768 * exact;
}
static double unary_free4(uint32_t x)
{
    return unary_free(x, &glint_power_4, 2);
}
static double unary_free8(uint32_t x)
{
    return unary_free(x, &glint_power_8, 3);
}
static double unary_free16(uint32_t x)
{
    return unary_free(x, &glint_power_16, 4);
}

static double unary_length_factor(uint32_t bend)
{
    return dots_length_factor(bend) - 65536 / sqrt(1 - fmin(bend, 65280) / 65536.);
}

/* Both ends of each step of 1 - |N|^2: between them the truth only rises. */
static double unary_length(uint32_t x)
{
    const uint32_t s = (x >> 1) << 18 | (x & 1 ? (1u << 18) - 1 : 0);
    const double exact = 32768 / sqrt(1 - s * 0x1p-30);
    return (spans_length[fx_saturated(s, SPANS_LENGTH_BITS, 28 - SPANS_LENGTH_BITS)] - exact) / exact;
}

/* 1 / W of a depth channel's value, and where its point is. */
static double unary_divisor(uint32_t depth)
{
    const struct perspective_divisor by = perspective_divisor(depth, 0);
    const double w = fmax(depth - DEPTH_FAR * 65536., 65536), exact = ldexp(0x1p62 / w, -(int)by.up);
    return by.half < 1 << 30 ? INFINITY : (by.half - exact) / exact;
}

/* A texel's three channels in 1/255; the worst. */
static double unary_expand(uint32_t texel)
{
    const uint32_t rgb = texel_expand(texel);
    const double e[3] = {(rgb >> 16) - (texel >> 11) * 255 / 31., (rgb >> 8 & 255) - (texel >> 5 & 63) * 255 / 63.,
                         (rgb & 255) - (texel & 31) * 255 / 31.};
    double worst = 0;
    for (int c = 0; c < 3; c++)
        worst = fabs(e[c]) > fabs(worst) ? e[c] : worst;
    return worst;
}

/* Every steepness, 1 of them at most, and every step of x^2 + y^2. */
static double unary_rise(uint32_t x)
{
    const uint32_t steepness = x % (TEXTURE_UNIT + 1), i = x / (TEXTURE_UNIT + 1);
    const double slope = steepness * 0x1p-14, square = (128. * i + 64) * 0x1p-14;
    return texel_rise((uint16_t)steepness, i) - 16384 * sqrt(fmax(0, 1 - square * slope * slope));
}

/* A sum in Q15 steps to a pixel's channel, and the others' beside it. */
static double unary_pixel(uint32_t sum, enum glint_format format, const uint8_t top[3], const uint8_t shift[3])
{
    static _Thread_local struct raster r;
    const unsigned channels = top[1] ? 3 : 1;
    const uint32_t sums[3] = {sum, sum / 2, sum / 3};
    double worst = 0;
    r.format = (uint8_t)format;
    r.palette = (struct palette){(uint8_t)channels, {top[0], top[1], top[2]}};
    const uint32_t pixel = raster_colour(&r, sums);
    for (unsigned c = 0; c < channels; c++) {
        const double e = (pixel >> shift[c] & top[c]) - fmin(top[c], sums[c] * 0x1p-15);
        worst = fabs(e) > fabs(worst) ? e : worst;
    }
    return worst;
}
static double unary_pixel_565(uint32_t sum)
{
    return unary_pixel(sum, GLINT_RGB565, (const uint8_t[3]){31, 63, 31}, (const uint8_t[3]){11, 5, 0});
}
static double unary_pixel_888(uint32_t sum)
{
    return unary_pixel(sum, GLINT_RGB888, (const uint8_t[3]){255, 255, 255}, (const uint8_t[3]){16, 8, 0});
}
static double unary_pixel_grey8(uint32_t sum)
{
    return unary_pixel(sum, GLINT_GREY8, (const uint8_t[3]){255, 0, 0}, (const uint8_t[3]){0, 0, 0});
}
static double unary_pixel_grey4(uint32_t sum)
{
    return unary_pixel(sum, GLINT_GREY4, (const uint8_t[3]){15, 0, 0}, (const uint8_t[3]){0, 0, 0});
}

/* Bounds, in Q16: never below what they bound, and little above their own formula. */
static double unary_affine(uint32_t q)
{
    const double x = q / 32768., got = texture_affine((int32_t)q);
    return got < 65536 * x / (1 + sqrt(1 - x * x)) ? INFINITY : got - 65536 * x / (2 - x * x);
}
static double unary_quadratic(uint32_t q)
{
    const double x = q / 32768., exact = 65536 * x * x * (.1927 + .1 * x + .2 * x * x),
                 got = texture_quadratic((int32_t)q);
    return got < exact ? INFINITY : got - exact;
}

#define UNARY_SUMS  (256u << 15)
#define UNARY_RISES ((TEXTURE_UNIT + 1) * TEXTURE_RISES)
static const struct sweep unary_sweeps[] = {
    {"fx_recip_norm", "of the value", truth_recip, 1ull << 31, 1ull << 32, 0, TRUTH_RECIP_BOUND},
    {"fx_rsqrt_norm", "of the value", truth_rsqrt, 1ull << 30, 1ull << 32, 0, TRUTH_RSQRT_BOUND},
    {"fx_sin, fx_cos", "x 2^-30", truth_sin, 0, 1ull << 32, 0, TRUTH_SIN_BOUND},
    {"fx_exp2_minus", "x 2^-16", unary_exp2, 0, 1ull << 32, 19u << 16, 7.5},
    {"fx_root", "", unary_root, 0, 1ull << 32, 0, 0},
    {"fx_clz_narrow", "", unary_clz, 0, 1ull << 32, 0, 0},
    {"fx_mulhi", "", unary_mulhi, 0, 1ull << 32, 0, 0},
    {"fx_divmod_floor", "", unary_divmod, 0, 1ull << 32, 0, 0},
    {"fx_divide", "", unary_divide, 0, 1ull << 26, 1u << 18, 0},
    {"fx_saturated", "", unary_saturated, 0, 1ull << 32, 0, 0},
    {"fx_power", "x 1/255", unary_power, 0, 1ull << 30, 0, TRUTH_POWER_BOUND},
    {"fx_power_exact", "x 2^-15", unary_power_exact, 0, 1ull << 30, 0, .5 + 1e-6},
    {"glint_power_4", "x 2^-15", unary_free4, 0, 1ull << 30, 0, 8},
    {"glint_power_8", "x 2^-15", unary_free8, 0, 1ull << 30, 0, 8},
    {"glint_power_16", "x 2^-15", unary_free16, 0, 1ull << 30, 0, 8},
    {"perspective_divisor", "of the value", unary_divisor, 0, 1ull << 32, 0, 0x1.6p-30},
    {"dots_length_factor", "x 2^-16", unary_length_factor, 0, 65537, 65537, 1.51},
    {"spans_length", "of the value", unary_length, 0, 2048, 2048, 9.73e-5},
    {"texel_expand", "x 1/255", unary_expand, 0, 65536, 65536, .5},
    {"texel_rise", "x 2^-14", unary_rise, 0, UNARY_RISES, UNARY_RISES, 1},
    {"texture_affine", "x 2^-16", unary_affine, 0, 32769, 32769, 4},
    {"texture_quadratic", "x 2^-16", unary_quadratic, 0, 24577, 24577, 8},
    {"raster_colour, RGB565", "steps", unary_pixel_565, 0, UNARY_SUMS, UNARY_SUMS, .5},
    {"raster_colour, RGB888", "steps", unary_pixel_888, 0, UNARY_SUMS, UNARY_SUMS, .5},
    {"raster_colour, GREY8", "steps", unary_pixel_grey8, 0, UNARY_SUMS, UNARY_SUMS, .5},
    {"raster_colour, GREY4", "steps", unary_pixel_grey4, 0, UNARY_SUMS, UNARY_SUMS, .5},
};
#define UNARY_SWEEPS (sizeof unary_sweeps / sizeof *unary_sweeps)

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Conversions and sums that say whether they may lose anything, in place of casts.
 *
 *   fx_u16(x) ...         x as this type, which holds its value: a plain cast, unless GLINT_CHECKED is defined; then a
 *                         value that does not fit goes to fx_trap()
 *   fx_wrap_u16(x) ...    x modulo 2^16 (8, 32, 64), on purpose: a sign taken for a bit, or bits cut off
 *   fx_wrap_add(a, b) ... sums, differences, products and shifts modulo 2^32 or 2^64, on purpose
 *   FX_WRAPS              the same of a whole function, a small one
 *   FX_REQUIRE(c, a, b)   c holds, or fx_trap() is told so and the values of a and b
 *
 * All else is exact: the checked build, by clang, also traps any other operator that overflows and any implicit
 * conversion that changes a value. tests/tools/check_source.sh allows no other cast to an integer type of fixed width
 * in the renderer, and no large function under FX_WRAPS.
 */
#ifndef GLINT_CHECKED_H
#define GLINT_CHECKED_H

#include <stdint.h>

/* Marks a function whose unsigned sums and products are meant modulo 2^32 or 2^64, for clang's integer sanitizer. */
#if defined(__clang__)
#define FX_WRAPS __attribute__((no_sanitize("unsigned-integer-overflow", "unsigned-shift-base")))
#else
#define FX_WRAPS
#endif

#ifdef GLINT_CHECKED
/* The test's: `broken` is what does not hold, with the values concerned. Where it returns, the program goes on as it
 * would unchecked. */
void fx_trap(const char *file, int line, const char *broken, int64_t a, int64_t b);

#define FX_REQUIRE(condition, a, b) \
    ((condition) ? (void)0 : fx_trap(__FILE__, __LINE__, #condition, (int64_t)(a), (int64_t)(b)))

/* Of any integer: 64-bit unsigned ones apart, as int64_t holds all others. */
static inline int64_t fx_fit_signed(int64_t x, int64_t least, uint64_t most, const char *file, int line,
                                    const char *broken)
{
    if (x < least || (x > 0 && (uint64_t)x > most))
        fx_trap(file, line, broken, x, least);
    return x;
}
static inline uint64_t fx_fit_unsigned(uint64_t x, int64_t least, uint64_t most, const char *file, int line,
                                       const char *broken)
{
    if (x > most)
        fx_trap(file, line, broken, (int64_t)x, least);
    return x;
}
#define FX_FIT(type, x, text, least, most)                 \
    ((type) _Generic((x), unsigned long                    \
                     : fx_fit_unsigned, unsigned long long \
                     : fx_fit_unsigned, default            \
                     : fx_fit_signed)((x), (least), (most), __FILE__, __LINE__, #type " holds " text))
#else
#define FX_REQUIRE(condition, a, b)        ((void)0)
#define FX_FIT(type, x, text, least, most) ((type)(x))
#endif

#define fx_s8(x)  FX_FIT(int8_t, x, #x, INT8_MIN, INT8_MAX)
#define fx_u8(x)  FX_FIT(uint8_t, x, #x, 0, UINT8_MAX)
#define fx_s16(x) FX_FIT(int16_t, x, #x, INT16_MIN, INT16_MAX)
#define fx_u16(x) FX_FIT(uint16_t, x, #x, 0, UINT16_MAX)
#define fx_s32(x) FX_FIT(int32_t, x, #x, INT32_MIN, INT32_MAX)
#define fx_u32(x) FX_FIT(uint32_t, x, #x, 0, UINT32_MAX)
#define fx_s64(x) FX_FIT(int64_t, x, #x, INT64_MIN, INT64_MAX)
#define fx_u64(x) FX_FIT(uint64_t, x, #x, 0, UINT64_MAX)

#define fx_wrap_s8(x)  ((int8_t)(x))
#define fx_wrap_u8(x)  ((uint8_t)(x))
#define fx_wrap_s16(x) ((int16_t)(x))
#define fx_wrap_u16(x) ((uint16_t)(x))
#define fx_wrap_s32(x) ((int32_t)(x))
#define fx_wrap_u32(x) ((uint32_t)(x))
#define fx_wrap_s64(x) ((int64_t)(x))
#define fx_wrap_u64(x) ((uint64_t)(x))

/* Of numbers without sign, of 32 or 64 bits: a + b, a - b, a * b, *x += step, and x * 2^up with up below their bits. */
#ifdef GLINT_CHECKED
#define FX_WRAP(bits)                                                                            \
    FX_WRAPS static inline uint##bits##_t fx_wrap_add_##bits(uint##bits##_t a, uint##bits##_t b) \
    {                                                                                            \
        return a + b;                                                                            \
    }                                                                                            \
    FX_WRAPS static inline uint##bits##_t fx_wrap_sub_##bits(uint##bits##_t a, uint##bits##_t b) \
    {                                                                                            \
        return a - b;                                                                            \
    }                                                                                            \
    FX_WRAPS static inline uint##bits##_t fx_wrap_mul_##bits(uint##bits##_t a, uint##bits##_t b) \
    {                                                                                            \
        return a * b;                                                                            \
    }                                                                                            \
    FX_WRAPS static inline uint##bits##_t fx_wrap_shl_##bits(uint##bits##_t a, unsigned up)      \
    {                                                                                            \
        return a << up;                                                                          \
    }
FX_WRAP(32)
FX_WRAP(64)
#define FX_WIDTH(name, a, b) __builtin_choose_expr(sizeof((a) + (b)) == 8, name##_64, name##_32)(a, b)
#define fx_wrap_add(a, b)    FX_WIDTH(fx_wrap_add, a, b)
#define fx_wrap_sub(a, b)    FX_WIDTH(fx_wrap_sub, a, b)
#define fx_wrap_mul(a, b)    FX_WIDTH(fx_wrap_mul, a, b)
#define fx_wrap_inc(x, step) (*(x) = fx_wrap_add(*(x), step))
#define fx_wrap_shl(x, up)   FX_WIDTH(fx_wrap_shl, x, up)
#else
#define fx_wrap_add(a, b)    ((a) + (b))
#define fx_wrap_sub(a, b)    ((a) - (b))
#define fx_wrap_mul(a, b)    ((a) * (b))
#define fx_wrap_inc(x, step) (*(x) += (step))
#define fx_wrap_shl(x, up)   ((x) << (up))
#endif

/* x * 2^up, which fits, up < 32: of a signed x, whose shift C leaves undefined. */
#ifdef GLINT_CHECKED
#define fx_shl(x, up) fx_shl_checked((x), (up), __FILE__, __LINE__)
static inline int32_t fx_shl_checked(int32_t x, unsigned up, const char *file, int line)
{
    if (up > 31)
        fx_trap(file, line, "a shift by less than 32", x, up);
    return (int32_t)fx_fit_signed(x * ((int64_t)1 << (up & 31)), INT32_MIN, INT32_MAX, file, line,
                                  "int32_t holds x * 2^up");
}
#else
#define fx_shl(x, up) ((int32_t)((uint32_t)(x) << (up)))
#endif

/* Whether |x| <= reach < 2^31, by one comparison. */
#define fx_within(x, reach) (fx_wrap_add(fx_wrap_u32(x), fx_u32(reach)) <= 2 * fx_u32(reach))

#endif

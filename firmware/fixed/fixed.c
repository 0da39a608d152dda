/* SPDX-License-Identifier: MIT */
#include "fixed/fixed.h"

_Static_assert((-3 >> 1) == -2, "the right shift of a negative value must be arithmetic");

#if FX_NARROW && defined(__thumb__)
/* fx_mulhi_..._narrow() in the four registers that a call may change, and r12: 18 cycles, where compilers save two more
 * and take 35. `shift` is asrs, or lsrs for unsigned factors. */
#define MULHI(name, type, shift)                              \
    __attribute__((naked)) type name(type a, type b)          \
    {                                                         \
        (void)a, (void)b;                                     \
        __asm__(".syntax unified\n"                           \
                "uxth r2, r0\n"        /* a0 */               \
                shift " r0, r0, #16\n" /* a1 */               \
                "uxth r3, r1\n"        /* b0 */               \
                shift " r1, r1, #16\n" /* b1 */               \
                "mov r12, r2\n"                               \
                "muls r2, r3\n"                               \
                "muls r3, r0\n"                               \
                "lsrs r2, r2, #16\n"                          \
                "adds r2, r2, r3\n" /* mid */                 \
                "mov r3, r12\n"                               \
                "muls r3, r1\n"                               \
                "muls r0, r1\n"                               \
                "uxth r1, r2\n"                               \
                "adds r3, r3, r1\n" /* low */                 \
                shift " r2, r2, #16\n" shift " r3, r3, #16\n" \
                "adds r0, r0, r2\n"                           \
                "adds r0, r0, r3\n"                           \
                "bx lr\n");                                   \
    }
MULHI(fx_mulhi_s32, int32_t, "asrs")
MULHI(fx_mulhi_u32, uint32_t, "lsrs")
#endif

/* round(2^18 / (2 i + 513)) - 256: 2^-23 of the function at the middle of the i-th 256th of
 * [2^31, 2^32). */
static const uint8_t recip_table[256] = {
    255, 253, 251, 249, 247, 245, 243, 241, 240, 238, 236, 234, 232, 230, 229, 227, 225, 223, 221, 220, 218, 216,
    215, 213, 211, 210, 208, 206, 205, 203, 201, 200, 198, 197, 195, 194, 192, 191, 189, 188, 186, 185, 183, 182,
    180, 179, 177, 176, 174, 173, 172, 170, 169, 167, 166, 165, 163, 162, 161, 159, 158, 157, 156, 154, 153, 152,
    150, 149, 148, 147, 145, 144, 143, 142, 141, 139, 138, 137, 136, 135, 134, 132, 131, 130, 129, 128, 127, 126,
    124, 123, 122, 121, 120, 119, 118, 117, 116, 115, 114, 113, 112, 111, 110, 109, 108, 107, 106, 105, 104, 103,
    102, 101, 100, 99,  98,  97,  96,  95,  94,  93,  92,  91,  90,  89,  88,  88,  87,  86,  85,  84,  83,  82,
    81,  81,  80,  79,  78,  77,  76,  75,  75,  74,  73,  72,  71,  70,  70,  69,  68,  67,  66,  66,  65,  64,
    63,  63,  62,  61,  60,  59,  59,  58,  57,  56,  56,  55,  54,  53,  53,  52,  51,  51,  50,  49,  48,  48,
    47,  46,  46,  45,  44,  44,  43,  42,  42,  41,  40,  40,  39,  38,  38,  37,  36,  36,  35,  34,  34,  33,
    32,  32,  31,  30,  30,  29,  29,  28,  27,  27,  26,  26,  25,  24,  24,  23,  23,  22,  21,  21,  20,  20,
    19,  18,  18,  17,  17,  16,  16,  15,  15,  14,  13,  13,  12,  12,  11,  11,  10,  10,  9,   9,   8,   7,
    7,   6,   6,   5,   5,   4,   4,   3,   3,   2,   2,   1,   1,   0,
};

/*
 * x = 2^23 x0 estimates X = 2^63 / m with 1 - x m / 2^63 = e, |e| < 1.47 * 2^-9, and X = x (1 + e + e^2 + e^3 + ...).
 * x0 has so few bits that the low 32 of x0 * m hold e exactly: the first product need not be wider.
 */
FX_WRAPS uint32_t fx_recip_norm(uint32_t m)
{
    FX_REQUIRE(m >> 31, m, 0);
    int32_t x0 = 256 + recip_table[m << 1 >> 24];
    /* 2^39 (1 - x0 m / 2^40) modulo 2^32, |e| < .74 * 2^31; what m >> 1 leaves out and what the last line rounds off
     * cancel on average */
    int32_t e = fx_wrap_s32(0u - fx_u32(x0) * (m >> 1));
    int32_t s = (e + 0x4000) >> 15;                /* e in Q24: |s| < .74 * 2^16 */
    uint32_t s2 = fx_wrap_u32(s) * fx_wrap_u32(s); /* e^2 in Q48, < .55 * 2^32 */
    int32_t s3 = fx_s32(s2 >> 17) * s;             /* e^3 in Q55: < .55 * 2^15 * .74 * 2^16 < 2^31 */
    e += fx_s32(s2 >> 9) + (s3 >> 16);             /* < .74 * 2^31 + .55 * 2^23 + 2^14 */
    /* at most 2^32 - 1: tested for all m */
    return (fx_u32(x0) << 23) + fx_wrap_u32(fx_mulhi_s32(x0 << 16, e));
}

/* round(sqrt(2^23 / (2 i + 129))): 2^-23 of the function at the middle of the i-th 192nd of [2^30, 2^32). */
static const uint8_t rsqrt_table[192] = {
    255, 253, 251, 249, 247, 246, 244, 242, 241, 239, 237, 236, 234, 233, 231, 230, 228, 227, 225, 224, 223, 221,
    220, 219, 218, 216, 215, 214, 213, 212, 211, 210, 208, 207, 206, 205, 204, 203, 202, 201, 200, 199, 198, 198,
    197, 196, 195, 194, 193, 192, 191, 191, 190, 189, 188, 187, 187, 186, 185, 184, 184, 183, 182, 181, 181, 180,
    179, 179, 178, 177, 177, 176, 175, 175, 174, 173, 173, 172, 172, 171, 170, 170, 169, 169, 168, 167, 167, 166,
    166, 165, 165, 164, 164, 163, 163, 162, 162, 161, 161, 160, 160, 159, 159, 158, 158, 157, 157, 156, 156, 155,
    155, 155, 154, 154, 153, 153, 152, 152, 152, 151, 151, 150, 150, 150, 149, 149, 148, 148, 148, 147, 147, 146,
    146, 146, 145, 145, 145, 144, 144, 144, 143, 143, 143, 142, 142, 141, 141, 141, 140, 140, 140, 140, 139, 139,
    139, 138, 138, 138, 137, 137, 137, 136, 136, 136, 135, 135, 135, 135, 134, 134, 134, 133, 133, 133, 133, 132,
    132, 132, 132, 131, 131, 131, 130, 130, 130, 130, 129, 129, 129, 129, 128, 128,
};

/* y = 2^23 y0 estimates Y = 2^46 / sqrt(m) with h = 1 - y^2 m / 2^92, and Y = y (1 + h/2 + 3h^2/8 + ...). */
FX_WRAPS uint32_t fx_rsqrt_norm(uint32_t m)
{
    FX_REQUIRE(m >> 30, m, 0);
    int32_t y0 = rsqrt_table[(m >> 24) - 64];
    /* 2^37 (1 - y0^2 m / 2^46) modulo 2^32, |h| < 1.4 * 2^30 */
    int32_t h = fx_wrap_s32(0u - fx_u32(y0 * y0) * (m >> 9));
    int32_t s = h >> 16;                                         /* |s| < 1.4 * 2^14 */
    h += 3 * (s * s) >> 7;                                       /* 3 s^2 < 1.5 * 2^30 */
    return (fx_u32(y0) << 23) + fx_wrap_u32(y0 * (h >> 8) >> 7); /* |h| < 1.5 * 2^30: y0 (h >> 8) < 1.5 * 2^30 */
}

/*
 * sin(pi/2 x) = x (c0 - c1 z + c2 z^2 - ...), z = x^2, on [0, 1]: exact at x = cos(pi j / 11), j = 0..5, which leaves
 * 2^-35.1. ck is in Q(31 + k): p in Q(32 + k) by z in Q31 gives a fx_mulhi in Q(31 + k), where the next one is.
 */
#define SIN_TERMS 6
static const uint32_t sin_coefficient[SIN_TERMS] = {3373259426u, 2774394659u, 684554162u, 80429755u, 5505136u, 234895u};

FX_WRAPS q30_t fx_sin(uint32_t turn)
{
    uint32_t x = turn << 1; /* quarter turns in Q31, of the half turn: the other differs by the sign */
    if (x >> 31)
        x = 0u - x; /* <= 2^31 from here on */
    uint32_t z = fx_mulhi_u32(x, x) << 1;
    uint32_t p = sin_coefficient[SIN_TERMS - 1];
    for (int k = SIN_TERMS - 2; k >= 0; k--)
        p = sin_coefficient[k] - fx_mulhi_u32(p, z); /* 0 < p <= ck: the next term is smaller */
    q30_t sine = fx_s32(fx_mulhi_u32(p, x));
    return turn >> 31 ? -sine : sine;
}

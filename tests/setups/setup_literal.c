/* SPDX-License-Identifier: MIT */
/*
 * Abbas and others 2001, section 2, as printed. Its denominators are of the sixth degree in the coordinates, so no
 * fixed point holds them: numbers are a mantissa of 31 bits, sign included, and an exponent.
 */
#include "tests/setups/setup.h"

struct block {
    int32_t m; /* 0, or |m| in [2^30, 2^31) */
    int32_t e; /* the number is m 2^e */
};

static inline struct block make(int32_t m, int32_t e)
{
    if (m == 0)
        return (struct block){0, 0};
    const uint32_t size = m < 0 ? 0u - (uint32_t)m : (uint32_t)m;
    const int32_t up = (int32_t)fx_clz(size) - 1;
    return (struct block){m * (1 << up), e - up};
}

/* The high product of two mantissas is in [2^28, 2^30). */
static struct block mul(struct block a, struct block b)
{
    return make(fx_mulhi_s32(a.m, b.m), a.e + b.e + 32);
}

/* The one with the smaller exponent is shifted to the other; both by one more, so that the sum fits. */
static struct block add(struct block a, struct block b)
{
    if (a.m == 0)
        return b;
    if (b.m == 0)
        return a;
    const int32_t apart = a.e - b.e;
    if (apart >= 0)
        return apart > 30 ? a : make((a.m >> 1) + (b.m >> (apart + 1)), a.e + 1);
    return apart < -30 ? b : make((b.m >> 1) + (a.m >> (1 - apart)), b.e + 1);
}

static struct block sub(struct block a, struct block b)
{
    return add(a, (struct block){-b.m, b.e});
}

/* b is not 0. 2^63 / (|b.m| 2) is r. */
static struct block quotient(struct block a, struct block b)
{
    const uint32_t size = (uint32_t)(b.m < 0 ? -b.m : b.m);
    const int32_t half = (int32_t)(fx_recip_norm(size << 1) >> 1);
    return make(fx_mulhi_s32(a.m, b.m < 0 ? -half : half), a.e - b.e - 29);
}

static struct block times(int n, struct block a)
{
    return mul(make(n, 0), a);
}

/* The number in Q30, modulo 2^32, rounded to nearest. */
FX_WRAPS static uint32_t q30(struct block a)
{
    const int up = a.e + 30;
    if (up >= 0)
        return up > 31 ? 0 : (uint32_t)a.m << up;
    return up < -31 ? 0 : (uint32_t)(((a.m >> (-up - 1)) + 1) >> 1);
}

int setup_abbas_literal(const struct plane *plane, const struct setup_samples *s, struct polynomial *out)
{
    const struct block x2 = make(plane->whole_x1, -4), y2 = make(plane->whole_y1, -4);
    const struct block x3 = make(plane->whole_x2, -4), y3 = make(plane->whole_y2, -4);
    const struct block i1 = make(s->value[0], -14), i2 = make(s->value[1], -14), i3 = make(s->value[2], -14);
    const struct block i12 = make(s->edge[0], -28), i23 = make(s->edge[1], -28), i13 = make(s->edge[2], -28);

    const struct block c2 = sub(sub(times(4, i12), times(3, i1)), i2);
    const struct block c3 = sub(sub(times(4, i13), times(3, i1)), i3);
    const struct block c12 = sub(add(i1, i2), times(2, i12));
    const struct block c13 = sub(add(i1, i3), times(2, i13));
    const struct block c23 = times(4, add(sub(sub(i1, i12), i13), i23));
    const struct block d23 = sub(mul(mul(times(2, x2), x2), y3), mul(mul(times(2, x2), y2), x3));
    const struct block d32 = sub(mul(mul(times(2, y2), x3), x3), mul(mul(times(2, x2), x3), y3));
    const struct block e23 = sub(mul(mul(x2, y2), y3), mul(mul(y2, y2), x3));
    const struct block e32 = sub(mul(mul(y2, x3), y3), mul(mul(x2, y3), y3));

    const struct block det = sub(mul(x2, y3), mul(y2, x3));
    const struct block p = sub(mul(times(4, c12), y3), mul(c23, y2));
    const struct block q = sub(mul(times(4, c13), y2), mul(c23, y3));
    const struct block den = sub(mul(e32, d23), mul(e23, d32));
    const struct block y2_squared = mul(y2, y2);
    if (det.m == 0 || den.m == 0 || y2_squared.m == 0)
        return 0;
    const struct block t1 = quotient(sub(mul(c3, x2), mul(c2, x3)), det);
    const struct block t2 = quotient(sub(mul(c2, y3), mul(c3, y2)), det);
    const struct block t4 = quotient(sub(mul(q, d23), mul(p, d32)), den);
    const struct block t5 = quotient(sub(mul(p, e32), mul(q, e23)), den);
    const struct block t3 = quotient(sub(sub(times(2, c12), mul(mul(t5, x2), x2)), mul(mul(t4, x2), y2)), y2_squared);
    *out = (struct polynomial){.f = q30(i1), .d = q30(t2), .e = q30(t1), .a = q30(t5), .b = q30(t3), .c = q30(t4)};
    return 1;
}

/* SPDX-License-Identifier: MIT */
/*
 * The set-ups in the renderer's number formats (firmware/shade/plane.c): corner differences scaled to 14 bits, one
 * reciprocal of the determinant, sums of products first and the reciprocal last, except where the ortho-normalised
 * triangle's alpha and beta are what a way is about.
 *
 * The coordinates x1 .. y2 of the plane are below 2^14; a product of two, times 8, is below 2^31. Normals up to 90
 * degrees apart have |a|, |b| <= 1.18 * 2^28 and |c| <= 3.6 * 2^28 in Q28 (X: 2^28, 3 * 2^28).
 */
#include "tests/setups/setup.h"

/* x * 2^up modulo 2^32, or rounded to nearest for up < 0. */
FX_WRAPS static inline uint32_t shifted(int32_t x, int up)
{
    if (up >= 0)
        return (uint32_t)x << up;
    return up < -31 ? 0 : (uint32_t)((x + (int32_t)(1u << (-up - 1))) >> -up);
}

/* What a high product with `half` wants to become a gradient in Q30 a pixel, and one with r2 a second difference. */
static inline int linear_shift(const struct plane *p)
{
    return p->shift + 4;
}
static inline int square_shift(const struct plane *p)
{
    return 2 * (p->up - p->scale) - 22;
}

static inline int32_t to_q14(int32_t q28)
{
    return (q28 + (1 << 13)) >> 14;
}

/* --- samples ---------------------------------------------------------------------------------------------------- */

static inline int32_t dot(const int16_t a[3], const int16_t b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; /* Q28; unit vectors: 2^28 and what rounding adds */
}

static inline void sample_values(const struct setup_case *c, struct setup_samples *out)
{
    for (int k = 0; k < 3; k++)
        out->value[k] = to_q14(dot(c->light, c->normal[k]));
}

/* X eq. 4-6: (Ii + Ij) / |Ni + Nj|. The length's square is in [2^29, 2^30 + 2^16]. */
static inline int32_t mid_edge(const struct setup_case *c, const struct setup_samples *s, int i, int j)
{
    int32_t square = 0;
    for (int k = 0; k < 3; k++) {
        const int32_t sum = c->normal[i][k] + c->normal[j][k];
        square += sum * sum;
    }
    const unsigned up = fx_clz((uint32_t)square) & ~1u;
    const int32_t half = (int32_t)(fx_rsqrt_norm((uint32_t)square << up) >> 1);
    /* 2^45 / (2^(up/2) 2^14 |Ni + Nj|): in Q31 - up/2, and the sum in Q29; |sum| <= 2^15 + 2 */
    return fx_mulhi_s32((s->value[i] + s->value[j]) * (1 << 15), half) * (1 << (up / 2));
}

static inline void sample_middle(const struct setup_case *c, struct setup_samples *out)
{
    sample_values(c, out);
    out->edge[0] = mid_edge(c, out, 0, 1);
    out->edge[1] = mid_edge(c, out, 1, 2);
    out->edge[2] = mid_edge(c, out, 2, 0);
}

/* X eq. 32: (Ii + Ij)(Ni.Nj - 1) / 2, the dot product computed here. Q29 * Q31 / 2^32 = Q28. */
static inline void sample_x(const struct setup_case *c, struct setup_samples *out)
{
    sample_values(c, out);
    for (int i = 0; i < 3; i++) {
        const int j = i == 2 ? 0 : i + 1;
        const int32_t k = dot(c->normal[i], c->normal[j]) - (1 << 28); /* 2 kij in Q28: [-2^28 - 2^15, 2^15] */
        out->edge[i] = fx_mulhi_s32((out->value[i] + out->value[j]) * (1 << 15), k * 4);
    }
}

/* With k as the mesh has it. |Ii + Ij| <= 2^15 + 2, bend <= 2^15. */
static inline void sample_x_k(const struct setup_case *c, struct setup_samples *out)
{
    sample_values(c, out);
    for (int i = 0; i < 3; i++) {
        const int j = i == 2 ? 0 : i + 1;
        out->edge[i] = -((out->value[i] + out->value[j]) * c->bend[i] >> 2);
    }
}

/* --- solutions -------------------------------------------------------------------------------------------------- */

/* Over the triangle (0,0) (1,0) (0,1): a u^2 + b v^2 + c u v + d u + e v, d and e in Q14, |d|, |e| < 2^17. */
struct unit {
    int32_t a, b, c, d, e;
};

/* X eq. 16. */
static inline struct unit unit_of_six(const struct setup_samples *s)
{
    const int32_t i1 = s->value[0] * (1 << 14), i2 = s->value[1] * (1 << 14), i3 = s->value[2] * (1 << 14);
    const int32_t i12 = s->edge[0], i23 = s->edge[1], i13 = s->edge[2];
    struct unit q;
    q.a = 2 * (i1 + i2 - 2 * i12);
    q.b = 2 * (i1 + i3 - 2 * i13);
    q.c = 4 * (i1 + i23 - i13 - i12);
    q.d = s->value[1] - s->value[0] - to_q14(q.a);
    q.e = s->value[2] - s->value[0] - to_q14(q.b);
    return q;
}

/* X eq. 32, from the bulges. */
static inline struct unit unit_of_x(const struct setup_samples *s)
{
    struct unit q;
    q.a = s->edge[0];
    q.b = s->edge[2];
    q.c = q.a + q.b - s->edge[1];
    q.d = s->value[1] - s->value[0] - to_q14(q.a);
    q.e = s->value[2] - s->value[0] - to_q14(q.b);
    return q;
}

/*
 * X eq. 20-22. The alphas and betas share an exponent, 44 + scale - up fraction bits, and are below 2^31: 2 * 2^30 less
 * 2^17. Products of two are below 2^30, times a coefficient 3.6 * 2^26 at most; those of C twice that, and its sum
 * below 2^30. dαu is d 2^13 alpha / 2^32, below 2^29.
 */
static inline int to_screen(const struct plane *p, struct unit q, int32_t f, struct polynomial *out)
{
    const int32_t au = fx_mulhi_s32(p->y2 * (1 << 17), p->half) * 2, bu = fx_mulhi_s32(-p->x2 * (1 << 17), p->half) * 2;
    const int32_t av = fx_mulhi_s32(-p->y1 * (1 << 17), p->half) * 2, bv = fx_mulhi_s32(p->x1 * (1 << 17), p->half) * 2;
    const int32_t a = fx_mulhi_s32(q.a, fx_mulhi_s32(au, au)) + fx_mulhi_s32(q.b, fx_mulhi_s32(av, av)) +
                      fx_mulhi_s32(q.c, fx_mulhi_s32(au, av));
    const int32_t b = fx_mulhi_s32(q.a, fx_mulhi_s32(bu, bu)) + fx_mulhi_s32(q.b, fx_mulhi_s32(bv, bv)) +
                      fx_mulhi_s32(q.c, fx_mulhi_s32(bu, bv));
    const int32_t c = 2 * fx_mulhi_s32(q.a, fx_mulhi_s32(au, bu)) + 2 * fx_mulhi_s32(q.b, fx_mulhi_s32(av, bv)) +
                      fx_mulhi_s32(q.c, fx_mulhi_s32(au, bv) + fx_mulhi_s32(av, bu));
    const int32_t d = fx_mulhi_s32(q.d * (1 << 13), au) + fx_mulhi_s32(q.e * (1 << 13), av);
    const int32_t e = fx_mulhi_s32(q.d * (1 << 13), bu) + fx_mulhi_s32(q.e * (1 << 13), bv);
    out->a = shifted(a, square_shift(p));
    out->b = shifted(b, square_shift(p));
    out->c = shifted(c, square_shift(p));
    out->d = shifted(d, linear_shift(p) + 1);
    out->e = shifted(e, linear_shift(p) + 1);
    out->f = (uint32_t)f << 16;
    return 1;
}

static inline int solve_hast(const struct plane *p, const struct setup_samples *s, struct polynomial *out)
{
    return to_screen(p, unit_of_six(s), s->value[0], out);
}

static inline int solve_x(const struct plane *p, const struct setup_samples *s, struct polynomial *out)
{
    return to_screen(p, unit_of_x(s), s->value[0], out);
}

/* Lee and Jen's share terms: 2T, 2U, 4V in Q28, G, H in Q14; |4V| <= 3.6 * 2^28. */
struct share {
    int32_t t2, u2, v4, g, h;
};

static inline struct share share_terms(const struct setup_samples *s)
{
    const int32_t n0 = s->value[0] * (1 << 14), n1 = s->value[1] * (1 << 14), n2 = s->value[2] * (1 << 14);
    const int32_t n5 = s->edge[0], n3 = s->edge[1], n4 = s->edge[2];
    const int32_t t = n0 + n1 - 2 * n5, u = n0 + n2 - 2 * n4, v = n0 + n3 - n4 - n5;
    return (struct share){2 * t, 2 * u, 4 * v, to_q14(2 * n5 - 2 * n0 - t), to_q14(2 * n4 - 2 * n0 - u)};
}

/* A product of coordinates for a high product that halves. */
static inline int32_t pair(int32_t x, int32_t y)
{
    return x * y * 8;
}

/* 2(T y2^2 + U y1^2 - 2V y1 y2), halved. */
static inline int32_t over_square(struct share s, int32_t first, int32_t second)
{
    return fx_mulhi_s32(s.t2, pair(second, second)) + fx_mulhi_s32(s.u2, pair(first, first)) -
           fx_mulhi_s32(s.v4, pair(first, second));
}

/* 4[V(w1 + w2) - U x1 y1 - T x2 y2], by four; |w1 + w2| < 2^29. */
static inline int32_t over_mixed(const struct plane *p, struct share s)
{
    return fx_mulhi_s32(s.v4, (p->x1 * p->y2 + p->x2 * p->y1) * 4) - fx_mulhi_s32(s.u2, pair(p->x1, p->y1)) -
           fx_mulhi_s32(s.t2, pair(p->x2, p->y2));
}

static inline int share_to_screen(const struct plane *p, struct share q, int32_t f, struct polynomial *out)
{
    out->a = shifted(fx_mulhi_s32(over_square(q, p->y1, p->y2), p->r2), square_shift(p));
    out->b = shifted(fx_mulhi_s32(over_square(q, p->x1, p->x2), p->r2), square_shift(p));
    out->c = shifted(fx_mulhi_s32(over_mixed(p, q), p->r2), square_shift(p) + 1);
    out->d = shifted(fx_mulhi_s32(q.g * p->y2 - q.h * p->y1, p->half), linear_shift(p));
    out->e = shifted(fx_mulhi_s32(q.h * p->x1 - q.g * p->x2, p->half), linear_shift(p));
    out->f = (uint32_t)f << 16;
    return 1;
}

static inline int solve_lee_jen(const struct plane *p, const struct setup_samples *s, struct polynomial *out)
{
    return share_to_screen(p, share_terms(s), s->value[0], out);
}

/* X's a, b, c, d, e are 2T, 2U, 4V, G, H. */
static inline int solve_x_products(const struct plane *p, const struct setup_samples *s, struct polynomial *out)
{
    const struct unit q = unit_of_x(s);
    return share_to_screen(p, (struct share){q.a, q.b, q.c, q.d, q.e}, s->value[0], out);
}

/* 2 C12, 2 C13 and C23 are 2T, 2U and 4V, and C2, C3 are G, H: the same under other names, but for how they are made.
 * 4(I12 - I1) + I1 - I2: as printed, 4 I12 - 3 I1 - I2, it may pass 2^31 on the way. */
static inline int solve_abbas_safe(const struct plane *p, const struct setup_samples *s, struct polynomial *out)
{
    const int32_t i1 = s->value[0] * (1 << 14), i2 = s->value[1] * (1 << 14), i3 = s->value[2] * (1 << 14);
    const int32_t i12 = s->edge[0], i23 = s->edge[1], i13 = s->edge[2];
    const struct share q = {.t2 = 2 * (i1 + i2 - 2 * i12),
                            .u2 = 2 * (i1 + i3 - 2 * i13),
                            .v4 = 4 * (i1 - i12 - i13 + i23),
                            .g = ((i12 - i1 + (1 << 11)) >> 12) + s->value[0] - s->value[1],
                            .h = ((i13 - i1 + (1 << 11)) >> 12) + s->value[0] - s->value[2]};
    return share_to_screen(p, q, s->value[0], out);
}

/* n 2^up / d for d > 0; the quotient fits. n is taken up to its full length first. */
static inline int32_t quotient(int32_t n, uint32_t d, int up)
{
    const uint32_t size = n < 0 ? 0u - (uint32_t)n : (uint32_t)n;
    if (size == 0)
        return 0;
    const int more = (int)fx_clz(size) - 1, down = (int)fx_clz(d);
    /* n / d = n 2^more (r / 2) 2^(down - more - 62) */
    return (int32_t)shifted(fx_mulhi_s32(n * (1 << more), (int32_t)(fx_recip_norm(d << down) >> 1)),
                            up + down - more - 30);
}

/*
 * c = (2T - a x1^2 - b x1 y1) / y1^2 and e = (G - d x1) / y1. With s = up - 2 scale, 3..9 of what is not thin: a, b, c
 * are kept in Q(32 - 2 s) and d, e in Q(30 - s) for coordinates in Q14, which leaves room for a y1 of a fourth and
 * more.
 */
static inline int solve_seiler(const struct plane *p, const struct setup_samples *s, struct polynomial *out)
{
    const struct share q = share_terms(s);
    const int thin = p->up - 2 * p->scale;
    if (p->y1 == 0)
        return 0;
    const int32_t a = fx_mulhi_s32(over_square(q, p->y1, p->y2), p->r2);
    const int32_t b = (int32_t)shifted(fx_mulhi_s32(over_mixed(p, q), p->r2), 1);
    const int32_t d = fx_mulhi_s32(q.g * p->y2 - q.h * p->y1, p->half);
    const int32_t rest =
        (q.t2 >> (2 * thin - 4)) - 2 * fx_mulhi_s32(a, pair(p->x1, p->x1)) - 2 * fx_mulhi_s32(b, pair(p->x1, p->y1));
    const int32_t c = quotient(rest, (uint32_t)(p->y1 * p->y1), 28);
    const int32_t slope = q.g * (1 << (16 - thin)) - 2 * fx_mulhi_s32(d, p->x1 * (1 << 17));
    const int32_t e = quotient(p->y1 < 0 ? -slope : slope, (uint32_t)(p->y1 < 0 ? -p->y1 : p->y1), 14);
    out->a = shifted(a, square_shift(p));
    out->b = shifted(c, square_shift(p));
    out->c = shifted(b, square_shift(p));
    out->d = shifted(d, linear_shift(p));
    out->e = shifted(e, linear_shift(p));
    out->f = (uint32_t)s->value[0] << 16;
    return 1;
}

/* --- the list --------------------------------------------------------------------------------------------------- */

static int place_triangle(const struct setup_case *c, struct plane *plane)
{
    const int16_t *const p[3] = {c->place[0], c->place[1], c->place[2]};
    if (!plane_setup(plane, p, SETUP_SIZE, SETUP_SIZE))
        return 0;
    plane_setup_quadratic(plane);
    return !plane->thin;
}

#define SETUP(name, sample, solve)                                              \
    static int setup_##name(const struct setup_case *c, struct polynomial *out) \
    {                                                                           \
        struct plane plane;                                                     \
        struct setup_samples samples;                                           \
        sample(c, &samples);                                                    \
        return place_triangle(c, &plane) && solve(&plane, &samples, out);       \
    }
SETUP(lee_jen, sample_middle, solve_lee_jen)
SETUP(abbas, sample_middle, setup_abbas_literal)
SETUP(abbas_safe, sample_middle, solve_abbas_safe)
SETUP(seiler, sample_middle, solve_seiler)
SETUP(hast, sample_middle, solve_hast)
SETUP(x, sample_x, solve_x)
SETUP(x_k, sample_x_k, solve_x)
SETUP(x_products, sample_x_k, solve_x_products)

const struct setup_integer setup_integers[] = {
    {"lee-jen", sample_middle, solve_lee_jen, setup_lee_jen},
    {"abbas", sample_middle, setup_abbas_literal, setup_abbas},
    {"abbas-safe", sample_middle, solve_abbas_safe, setup_abbas_safe},
    {"seiler", sample_middle, solve_seiler, setup_seiler},
    {"hast", sample_middle, solve_hast, setup_hast},
    {"x", sample_x, solve_x, setup_x},
    {"x-k", sample_x_k, solve_x, setup_x_k},
    {"x-products", sample_x_k, solve_x_products, setup_x_products},
};
const unsigned setup_integer_count = sizeof setup_integers / sizeof setup_integers[0];

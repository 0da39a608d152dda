/* SPDX-License-Identifier: MIT */
#include "shade/plane.h"

/*
 * Corner differences are scaled to 14 bits, so a determinant far below 2^28 of those is a sliver. With `up` its leading
 * zero bits, a linear channel errs by about 2^up in Q30 at the far end (one unit of the high product, times
 * 2^(scale + up - 14), over 2^(14 - scale) sub-pixels), a quadratic one by 3 * 2^(2 up - 2), and besides by half a unit
 * times the square of the distance from the origin, as its second differences are rounded. These limits keep the first
 * two below 1/64 and 1/5 of a display unit; the third is 3/16 at 1024 pixels and 1/2 at 2048.
 */
#define MOST_UP_LINEAR    15
#define MOST_UP_QUADRATIC 9

/* up of the scaled determinant, det * 2^(2 scale) */
static inline int scaled_up(const struct plane *plane)
{
    return plane->up - 2 * plane->scale;
}

/* i, or the nearest of [0, size). */
static inline int32_t inside(int32_t i, unsigned size)
{
    if (fx_wrap_u32(i) < size)
        return i;
    return i < 0 ? 0 : fx_s32(size) - 1;
}

int plane_setup(struct plane *plane, const int16_t *const p[3], unsigned width, unsigned height)
{
    int32_t x0 = p[0][0], y0 = p[0][1];
    int32_t x1 = p[1][0] - x0, y1 = p[1][1] - y0, x2 = p[2][0] - x0, y2 = p[2][1] - y0;
    /* |differences| <= 2^15: each product at most 2^30, the determinant is that of a triangle in a box of 2^15. */
    const int32_t det = x1 * y2 - x2 * y1;
    if (det <= 0)
        return 0;
    plane->whole_x1 = x1;
    plane->whole_y1 = y1;
    plane->whole_x2 = x2;
    plane->whole_y2 = y2;
    plane->det = fx_u32(det);
    plane->up = fx_s32(fx_clz(fx_u32(det)));
    plane->r = fx_recip_norm(fx_u32(det) << plane->up);
    plane->half = fx_s32(plane->r >> 1);

    uint32_t largest = fx_u32(x1 < 0 ? -x1 : x1) | fx_u32(y1 < 0 ? -y1 : y1) | fx_u32(x2 < 0 ? -x2 : x2) |
                       fx_u32(y2 < 0 ? -y2 : y2); /* as good as the maximum for counting bits */
    const int scale = fx_s32(fx_clz(largest)) - 18;
    if (scale >= 0) {
        x1 *= 1 << scale;
        y1 *= 1 << scale;
        x2 *= 1 << scale;
        y2 *= 1 << scale;
    } else { /* more than 1024 pixels: half a sub-pixel, a quarter where it is 2048, does not show over that length */
        x1 >>= -scale;
        y1 >>= -scale;
        x2 >>= -scale;
        y2 >>= -scale;
    }
    plane->x1 = x1;
    plane->y1 = y1;
    plane->x2 = x2;
    plane->y2 = y2;
    plane->scale = scale;
    plane->shift = plane->up - scale - 14;
    plane->sliver = scaled_up(plane) > MOST_UP_LINEAR;

    /* The origin stays in the picture: a rounded second difference errs with the square of the distance from it. */
    const int32_t left = x0 + 8 * fx_s32(width), top = y0 + 8 * fx_s32(height);
    plane->ox = inside(left >> 4, width);
    plane->oy = inside(top >> 4, height);
    plane->fx = plane->ox * 16 + 8 - left;
    plane->fy = plane->oy * 16 + 8 - top;
    return 1;
}

void plane_setup_quadratic(struct plane *plane)
{
    /* Heights of 2 pixels at least bound the second differences: det / longest side >= 32 sub-pixels, the longest taken
     * as 2^(14 - scale). det << scale stays below 2^29. */
    uint32_t height = plane->scale > 0 ? plane->det << plane->scale : plane->det >> -plane->scale;
    plane->thin = scaled_up(plane) > MOST_UP_QUADRATIC || height < 32u << 14;
    plane->slim = plane->sliver || height < 1u << 12; /* see plane_quadratic_wide() */
    plane->r2 = fx_s32(fx_mulhi_u32(plane->r, plane->r) >> 1);
    /* within -8..23 sixteenths of corner 0, or not */
    plane->far = (fx_wrap_u32((plane->fx + 8) | (plane->fy + 8)) >> 5 | fx_wrap_u32(plane->scale) >> 31) != 0;
}

/* x * 2^up, which fits, or rounded to nearest for up < 0. */
static inline int32_t shifted(int32_t x, int up)
{
    if (up >= 0)
        return fx_shl(x, up);
    return up < -31 ? 0 : (x + fx_s32(1u << (-up - 1))) >> -up;
}

/* Corner differences d1, d2, |d| < 2^16, across the edges: det * 2^(2 scale) times the gradient, by 2^-scale. */
struct slope {
    int32_t x, y;
};

/* Beyond 1024 pixels: better to lose the low bits of the differences than those of the coordinates. */
static __attribute__((noinline)) struct slope slope_wide(const struct plane *p, int32_t d1, int32_t d2)
{
    const int down = -p->scale, half = 1 << (down - 1);
    d1 = (d1 + half) >> down;
    d2 = (d2 + half) >> down;
    return (struct slope){d1 * p->whole_y2 - d2 * p->whole_y1, d2 * p->whole_x1 - d1 * p->whole_x2};
}

/* Products are at most 2^30, here and above; the sums at most 2^31, and less where both have one sign. */
static inline struct slope slope_near(const struct plane *p, int32_t d1, int32_t d2)
{
    return (struct slope){d1 * p->y2 - d2 * p->y1, d2 * p->x1 - d1 * p->x2};
}

static inline struct slope slope_of(const struct plane *p, int32_t d1, int32_t d2)
{
    return p->scale < 0 ? slope_wide(p, d1, d2) : slope_near(p, d1, d2);
}

/* The gradient: a sixteenth of a pixel's step, times 2^16. */
static inline void gradient(const struct plane *p, struct slope n, uint32_t *gx, uint32_t *gy)
{
    /* n / (det 2^(2 scale)) * 2^(16 + scale) = n * (r / 2^33) * 2^(up - scale - 14) */
    const int32_t x = fx_mulhi_s32(n.x, p->half), y = fx_mulhi_s32(n.y, p->half);
    const int up = p->shift; /* -13..17 */
    if (up >= 0) {
        *gx = fx_wrap_shl(fx_wrap_u32(x), fx_u32(up));
        *gy = fx_wrap_shl(fx_wrap_u32(y), fx_u32(up));
    } else {
        const int32_t round = 1 << (-up - 1);
        *gx = fx_wrap_u32((x + round) >> -up);
        *gy = fx_wrap_u32((y + round) >> -up);
    }
}

void plane_linear(const struct plane *plane, const int32_t value[3], struct channel *channel)
{
    channel->exact = plane->sliver; /* PLANE_EXACT */
    if (plane->sliver) {
        plane_keep_corners(channel, value, 0);
        return;
    }
    uint32_t gx, gy;
    gradient(plane, slope_of(plane, value[1] - value[0], value[2] - value[0]), &gx, &gy);
    struct polynomial *p = &channel->p;
    p->f = fx_wrap_add(fx_wrap_add(fx_wrap_shl(fx_wrap_u32(value[0]), 16), fx_wrap_mul(gx, fx_wrap_u32(plane->fx))),
                       fx_wrap_mul(gy, fx_wrap_u32(plane->fy)));
    p->d = fx_wrap_shl(gx, 4);
    p->e = fx_wrap_shl(gy, 4);
    p->a = p->b = p->c = 0;
}

/* Second differences, of eq. 22, times det^2 2^(4 scale) and halved. */
struct curve {
    int32_t a, b, c;
};

/* a p + b q - c r, of the high words.. */
static inline int32_t form(const int32_t abc[3], int32_t p, int32_t q, int32_t r)
{
    return fx_mulhi_s32(abc[0], p) + fx_mulhi_s32(abc[1], q) - fx_mulhi_s32(abc[2], r);
}

/* Coordinates are below 2^14, their products below 2^28 and times 8 below 2^31. Each high product is half of
 * coefficient * product: below 2^27, for c 3 * 2^27; the sums stay below 2^30. */
static inline struct curve curve_of(const struct plane *p, const int32_t abc[3])
{
    const int32_t x1 = p->x1, y1 = p->y1, x2 = p->x2, y2 = p->y2;
    return (struct curve){form(abc, (y2 * y2) << 3, (y1 * y1) << 3, (y1 * y2) * 8),
                          form(abc, (x2 * x2) << 3, (x1 * x1) << 3, (x1 * x2) * 8),
                          -form(abc, (x2 * y2) * 8, (x1 * y1) * 8, (x1 * y2 + x2 * y1) * 4)};
}

/* n / (det 2^(2 scale))^2 * 2^(31 + 8 + 2 scale) = n * (r2 / 2^32) * 2^curve_shift; a pixel is 16 sub-pixels. */
static inline int curve_shift(const struct plane *p)
{
    return 2 * (p->up - p->scale) - 22;
}

static inline int32_t second_difference(const struct plane *p, int32_t curve, int up)
{
    return shifted(fx_mulhi_s32(curve, p->r2), curve_shift(p) + up);
}

/* By how much a place x, y off changes what has these slopes. */
FX_WRAPS static inline uint32_t moved(int32_t gx, int32_t x, int32_t gy, int32_t y)
{
    return fx_wrap_u32(gx) * fx_wrap_u32(x) + fx_wrap_u32(gy) * fx_wrap_u32(y);
}

/* Where the origin is near the centre of corner 0's pixel. Heights are at least 2 pixels, so the second differences are
 * at most 5/4 (a, b) and 1.95 (c) of 2^30 at the very worst bends; products are taken modulo 2^32, the results fit. */
void plane_quadratic(const struct plane *plane, const int32_t value[3], const int32_t bulge[3], struct channel *channel)
{
    channel->exact = 0;
    if (plane->thin || plane->far) {
        plane_quadratic_large(plane, value, bulge, channel);
        return;
    }
    /* eq. 32: a u^2 + b v^2 + c u v + d u + e v + f, u towards corner 1, v towards corner 2. In Q28; |a|, |b| <= 2^28,
     * |c| <= 3 * 2^28. What is linear of it is the linear channel to other corners; no sliver is left here. */
    const int32_t abc[3] = {bulge[0], bulge[2], bulge[0] + bulge[2] - bulge[1]};
    const int32_t ends[3] = {value[0], value[1] - ((abc[0] + (1 << 13)) >> 14),
                             value[2] - ((abc[1] + (1 << 13)) >> 14)};
    plane_linear(plane, ends, channel);
    const struct curve curve = curve_of(plane, abc);
    const int32_t a = second_difference(plane, curve.a, 0), b = second_difference(plane, curve.b, 0),
                  c = second_difference(plane, curve.c, 1), fx = plane->fx, fy = plane->fy;
    struct polynomial *p = &channel->p;
    fx_wrap_inc(&p->f, fx_wrap_add(moved(a >> 8, fx * fx, b >> 8, fy * fy),
                                   fx_wrap_mul(fx_wrap_u32(c >> 8), fx_wrap_u32(fx * fy))));
    fx_wrap_inc(&p->d, moved(a >> 3, fx, c >> 4, fy));
    fx_wrap_inc(&p->e, moved(b >> 3, fy, c >> 4, fx));
    p->a = fx_wrap_u32(a);
    p->b = fx_wrap_u32(b);
    p->c = fx_wrap_u32(c);
}

/* The value at column i, row j of the origin, and the step to the next column. */
FX_WRAPS static inline uint32_t value_at(const struct polynomial *p, uint32_t i, uint32_t j)
{
    return p->f + (p->e + p->b * j) * j + (p->d + p->c * j + p->a * i) * i;
}
FX_WRAPS static inline uint32_t step_at(const struct polynomial *p, uint32_t i, uint32_t j)
{
    return p->d + p->c * j + p->a * (2 * i + 1);
}

void plane_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out)
{
    if (channel->exact) {
        plane_exact_values(plane, channel, x, y, n, out);
        return;
    }
    const struct polynomial *p = &channel->p;
    const uint32_t i = fx_wrap_u32(x - plane->ox), j = fx_wrap_u32(y - plane->oy);
    uint32_t value = value_at(p, i, j), step = step_at(p, i, j);
    for (; n; n--, fx_wrap_inc(&value, step), fx_wrap_inc(&step, fx_wrap_mul(2, p->a)))
        *out++ = fx_wrap_s32(value);
}

/* SPDX-License-Identifier: MIT */
/* What plane.c leaves aside: large triangles and large values, in 64 bits; and those that no polynomial suits. */
#include "shade/plane.h"

void plane_keep_corners(struct channel *channel, const int32_t value[3], const int32_t bulge[3])
{
    for (int i = 0; i < 3; i++) {
        channel->corner.value[i] = value[i];
        channel->corner.bulge[i] = bulge ? bulge[i] : 0;
    }
}

/* x m / 2^32 2^up modulo 2^64, rounded where up < 0; |x| < 2^63. */
FX_WRAPS static uint64_t product(int64_t x, uint32_t m, int up)
{
    const int64_t t = (x >> 32) * fx_s64(m) + fx_s64(fx_u64(fx_wrap_u32(x)) * m >> 32);
    if (up >= 0)
        return fx_wrap_u64(t) << up;
    return fx_wrap_u64((t + (INT64_C(1) << (-up - 1))) >> -up);
}

/* Q46 to Q30, rounded. */
FX_WRAPS static uint32_t narrowed(uint64_t x)
{
    return fx_wrap_u32((x + (1u << 15)) >> 16);
}

/* Gradient and half the second differences: a sub-pixel's steps, in Q46 of 1. */
struct wide {
    uint64_t gx, gy, ax, ay, axy;
};

/* From corner differences d1, d2, |d| < 2^33.6: slopes are below 2^49.6. */
static void find_gradient(const struct plane *p, int64_t d1, int64_t d2, struct wide *out)
{
    out->gx = product(d1 * p->whole_y2 - d2 * p->whole_y1, p->r, p->up - 15);
    out->gy = product(d2 * p->whole_x1 - d1 * p->whole_x2, p->r, p->up - 15);
}

/* In Q46 of 1 and sub-pixels until the end, so that an origin far from corner 0 costs no accuracy: offsets are up to
 * 2^15, and half a unit of the last place becomes 2^-17 of a unit of Q30. */
FX_WRAPS static void finish(const struct plane *plane, int32_t value, const struct wide *w, struct polynomial *p)
{
    const uint64_t x = fx_wrap_u64(plane->fx), y = fx_wrap_u64(plane->fy);
    p->f = narrowed((fx_wrap_u64(value) << 16) + (w->gx + w->ax * x + w->axy * y) * x + (w->gy + w->ay * y) * y);
    p->d = narrowed((w->gx + 2 * w->ax * x + w->axy * y) * 16);
    p->e = narrowed((w->gy + 2 * w->ay * y + w->axy * x) * 16);
    p->a = narrowed(w->ax * 256);
    p->b = narrowed(w->ay * 256);
    p->c = narrowed(w->axy * 256);
}

void plane_linear_wide(const struct plane *plane, const int32_t value[3], struct channel *channel)
{
    channel->exact = plane->sliver ? PLANE_EXACT_WIDE : 0;
    if (plane->sliver) {
        plane_keep_corners(channel, value, 0);
        return;
    }
    struct wide w;
    struct polynomial *p = &channel->p;
    find_gradient(plane, fx_s64(value[1]) - value[0], fx_s64(value[2]) - value[0], &w);
    p->f = narrowed(
        fx_wrap_add(fx_wrap_add(fx_wrap_shl(fx_wrap_u64(value[0]), 16), fx_wrap_mul(w.gx, fx_wrap_u64(plane->fx))),
                    fx_wrap_mul(w.gy, fx_wrap_u64(plane->fy))));
    p->d = narrowed(fx_wrap_mul(w.gx, 16));
    p->e = narrowed(fx_wrap_mul(w.gy, 16));
    p->a = p->b = p->c = 0;
}

/*
 * How thin a triangle may be. With s the largest corner difference in sub-pixels and h = det / s, 2^up < 2^32 / det.
 * product() drops less than a unit before it shifts. So at X, Y <= s from corner 0 a gradient errs by less than
 * 2^(up - 15) (X + Y) in Q46, which is 2^-31 2^32 / det 2 s = 4 / h in Q30; second differences by less than
 * 2^(2 up - 42) (X^2 + Y^2 + X Y), which is 2^-58 2^64 / det^2 3 s^2 = 192 / h^2. What r and r2 err by relatively, less
 * than 2^-28.8, is common to both gradients and to the three second differences, so that it multiplies parts of the
 * value which inside the triangle are below 2^34: less than 2^5.2. The rounded coefficients err as in plane.c however
 * thin it is, and all sums are modulo 2^32. With h >= 1/4 that is 2^12 of Q30 in all, 1/1000 of a display unit.
 * plane_setup_quadratic() asks for det 2^scale >= 2^12, and s 2^scale is below 2^14: det > s / 4.
 */
void plane_quadratic_wide(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                          struct channel *channel)
{
    channel->exact = plane->slim ? PLANE_EXACT_WIDE : 0;
    if (plane->slim) {
        plane_keep_corners(channel, value, bulge);
        return;
    }
    const int32_t x1 = plane->whole_x1, y1 = plane->whole_y1, x2 = plane->whole_x2, y2 = plane->whole_y2;
    /* Coefficients of eq. 32 in Q28: |a|, |b| <= 2^31, |c| <= 3 * 2^31; d in Q30, at most 2^32 + 2^33. */
    int64_t a = bulge[0], b = bulge[2], c = a + b - bulge[1];
    const int up = 2 * plane->up - 42;
    struct wide w;
    find_gradient(plane, fx_s64(value[1]) - value[0] - a * 4, fx_s64(value[2]) - value[0] - b * 4, &w);
    /* det^2 times half the second differences, coefficients in Q26 and coordinates' products, at most 2^30:
     * twice (2^29 + 2^29 + 3 * 2^29) * 2^30 < 2^62.4. */
    const uint32_t r2 = fx_mulhi_u32(plane->r, plane->r);
    a >>= 2;
    b >>= 2;
    c >>= 2;
    w.ax = product(a * (y2 * y2) + b * (y1 * y1) - c * (y1 * y2), r2, up);
    w.ay = product(a * (x2 * x2) + b * (x1 * x1) - c * (x1 * x2), r2, up);
    w.axy = product(c * (fx_s64(x1) * y2 + fx_s64(x2) * y1) - 2 * (a * (x2 * y2) + b * (x1 * y1)), r2, up);
    finish(plane, value[0], &w, &channel->p);
}

void plane_quadratic_large(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                           struct channel *channel)
{
    const int32_t q30[3] = {value[0] * 65536, value[1] * 65536, value[2] * 65536};
    plane_quadratic_wide(plane, q30, bulge, channel);
}

/* The barycentric way: u, v, w in Q16 from edge functions, clamped to the triangle. (px, py) is the pixel's centre from
 * corner 0 in sub-pixels. */
static int32_t exact_value(const struct plane *plane, const struct channel *channel, int32_t px, int32_t py)
{
    const int32_t *value = channel->corner.value, *bulge = channel->corner.bulge;
    /* |px|, |py| <= 2^15. Inside the triangle both numerators lie in [0, det]: they fit though a product's difference
     * may not on the way. */
    int32_t nu = fx_wrap_s32(fx_wrap_sub(fx_wrap_u32(px * plane->whole_y2), fx_wrap_u32(py * plane->whole_x2)));
    int32_t nv = fx_wrap_s32(fx_wrap_sub(fx_wrap_u32(py * plane->whole_x1), fx_wrap_u32(px * plane->whole_y1)));
    int32_t det = fx_s32(plane->det);
    nu = nu < 0 ? 0 : nu > det ? det : nu;
    nv = nv < 0 ? 0 : nv > det - nu ? det - nu : nv;
    /* n / det in Q31, then Q16: together at most 65536 and 2^-14, and so at most 65536. */
    uint32_t u = fx_mulhi_u32(fx_u32(nu) << plane->up, plane->r) >> 15;
    uint32_t v = fx_mulhi_u32(fx_u32(nv) << plane->up, plane->r) >> 15;
    uint32_t w = 65536 - u - v;
    /* Corner values differ by less than 2^16; the true sum fits, the products are modulo 2^32. Weights' products are
     * Q32, at most 2^30. */
    uint32_t linear;
    if (channel->exact == PLANE_EXACT_WIDE) /* weights in Q30: a quarter of each term */
        linear =
            fx_wrap_shl(fx_wrap_u32(fx_mulhi_s32(value[0], fx_s32(w << 14)) + fx_mulhi_s32(value[1], fx_s32(u << 14)) +
                                    fx_mulhi_s32(value[2], fx_s32(v << 14))),
                        2);
    else
        linear = fx_wrap_add(
            fx_wrap_add(fx_wrap_shl(fx_wrap_u32(value[0]), 16), fx_wrap_mul(fx_wrap_u32(value[1] - value[0]), u)),
            fx_wrap_mul(fx_wrap_u32(value[2] - value[0]), v));
    int32_t bend = fx_mulhi_s32(bulge[0], fx_s32(w * u)) + fx_mulhi_s32(bulge[1], fx_s32(u * v)) +
                   fx_mulhi_s32(bulge[2], fx_s32(v * w));
    return fx_wrap_s32(fx_wrap_sub(linear, fx_wrap_shl(fx_wrap_u32(bend), 2)));
}

void plane_exact_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out)
{
    int32_t px = (x - plane->ox) * 16 + plane->fx, py = (y - plane->oy) * 16 + plane->fy;
    for (int i = 0; i < n; i++, px += 16)
        out[i] = exact_value(plane, channel, px, py);
}

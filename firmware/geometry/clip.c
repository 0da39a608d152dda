/* SPDX-License-Identifier: MIT */
#include "geometry/clip.h"

/* The planes: near, far, then the guard band's sides. */
enum { NEAR_PLANE, FAR_PLANE, RIGHT, LEFT, BOTTOM, TOP, PLANES };

/* Distance inside a plane, any positive scale. x / z * 2^(z_exponent - xy_exponent) is sub-pixels, and
 * transform.shift = 30 + xy_exponent - z_exponent where it divides: inside is GUARD * z >= +-x * 2^(30 - shift). */
static int64_t inside(const struct transform *t, const struct eye_point *e, int plane)
{
    if (plane == NEAR_PLANE)
        return fx_s64(e->z) - t->near_z;
    if (plane == FAR_PLANE)
        return fx_s64(t->far_z) - e->z;
    int32_t side = plane < BOTTOM ? e->x : e->y;
    int64_t reach;
    /* |z|, |x| < 2^29, GUARD < 2^14 */
    int down = transform_divides(t) ? t->shift - 30 : t->shift;
    if (transform_divides(t))
        reach = fx_s64(e->z) * GUARD;
    else
        reach = GUARD;
    int64_t value = side;
    if (down >= 0)
        reach = down > 18 ? INT64_MAX / 4 : reach * (INT64_C(1) << down);
    else
        value = down < -30 ? value * (INT64_C(1) << 30) : value * (INT64_C(1) << -down);
    return plane & 1 ? reach + value : reach - value; /* LEFT and TOP are odd */
}

/* Rounded to nearest; between a and b, as t is in 0..1. */
static int32_t mix(int32_t a, int32_t b, uint32_t t_q31)
{
    return fx_s32(a + (((fx_s64(b) - a) * fx_s64(t_q31) + (1 << 30)) >> 31));
}

/*
 * The cut from a corner inside to one outside: t = d0 / (d0 - d1) in Q31, rounded down, so that it is less than 1. Each
 * coordinate lies between its ends. At the near and the far plane d0 - d1 is below 2^32 and the way in z itself: t
 * takes of it no more than d0, which rounding to nearest keeps, and no cut lies outside.
 */
static void cut(const struct clip_corner *in, int64_t d0, const struct clip_corner *out, int64_t d1,
                struct clip_corner *result)
{
    uint64_t span = fx_u64(d0 - d1), part = fx_u64(d0); /* d0 >= 0 > d1, both below 2^61 in size */
    while (span >= UINT64_C(1) << 32) {
        span >>= 1;
        part >>= 1;
    }
    uint32_t t = fx_u32(fx_divide_u64(part << 31, span));
    result->eye.x = mix(in->eye.x, out->eye.x, t);
    result->eye.y = mix(in->eye.y, out->eye.y, t);
    result->eye.z = mix(in->eye.z, out->eye.z, t);
    for (int i = 0; i < 3; i++)
        result->weight[i] = mix(in->weight[i], out->weight[i], t);
}

static void clip_plane(const struct transform *t, int plane, const struct clip_polygon *from, struct clip_polygon *to)
{
    to->count = 0;
    for (int i = 0; i < from->count; i++) {
        const struct clip_corner *a = &from->corner[i], *b = &from->corner[i + 1 == from->count ? 0 : i + 1];
        int64_t da = inside(t, &a->eye, plane), db = inside(t, &b->eye, plane);
        /* A convex polygon gains at most one corner a plane; the bound keeps rounding from ever writing past the end.
         */
        if (da >= 0 && to->count < CLIP_MAX_CORNERS)
            to->corner[to->count++] = *a;
        if ((da < 0) != (db < 0) && to->count < CLIP_MAX_CORNERS) {
            if (da >= 0)
                cut(a, da, b, db, &to->corner[to->count++]);
            else
                cut(b, db, a, da, &to->corner[to->count++]);
        }
    }
}

void clip_triangle(const struct transform *transform, struct clip_polygon *polygon, struct clip_polygon *other)
{
    for (int plane = 0; plane < PLANES && polygon->count >= 3; plane++) {
        clip_plane(transform, plane, polygon, other);
        *polygon = *other;
    }
}

/* SPDX-License-Identifier: MIT */
/* The divide, and the rounding to the screen: in perspective inline, as it runs once a vertex. */
#ifndef GLINT_PROJECT_H
#define GLINT_PROJECT_H

#include "geometry/transform.h"

/* As project_round() where down <= 0 or down > 30: a vertex far nearer than its object's size, or one so far that it is
 * less than a quarter of a sub-pixel from the centre. */
int project_extreme(int32_t x, int32_t y, int down, int32_t reach, struct screen_point *out);

/* (x, y) * 2^-down rounded to nearest, ties up; 0 if either is beyond `reach`. |x|, |y| < 2^29, reach < 2^15. */
static inline int project_round(int32_t x, int32_t y, int down, int32_t reach, struct screen_point *out)
{
    if (fx_wrap_u32(down - 1) >= 30)
        return project_extreme(x, y, down, reach, out);
    const int32_t half = 1 << (down - 1); /* below 2^30 */
    x = (x + half) >> down;
    y = (y + half) >> down;
    out->x = fx_wrap_s16(x); /* of no account beyond */
    out->y = fx_wrap_s16(y);
    return fx_within(x, reach) && fx_within(y, reach);
}

static inline int project_perspective(const struct transform *t, struct eye_point e, int32_t reach,
                                      struct screen_point *out)
{
    /* 1 <= z < 2^29: up in 3..31. r = 2^63 / (z 2^up). */
    unsigned up = fx_clz(fx_u32(e.z));
    uint32_t r = fx_recip_norm(fx_u32(e.z) << up);
    /* near <= z, so up <= depth_shift, or 1 more by rounding: the ratio in Q(31 + depth_shift - up); wanted in Q16. */
    unsigned down = 15u + fx_u32(t->depth_shift) - up;
    uint32_t q16 = down < 32 ? fx_mulhi_u32(t->depth_scale, r) >> down : 0;
    q16 = q16 > 65535 ? 65535 : q16;
    out->depth = fx_u16(DEPTH_FAR + ((q16 * fx_u32(DEPTH_NEAR - DEPTH_FAR)) >> 16));
    /* x / z in units of 2^-(30 - up), |.| < |x| / 2. */
    int32_t half = fx_s32(r >> 1);
    int shift = t->shift - fx_s32(up);
    return project_round(fx_mulhi_s32(e.x, half), fx_mulhi_s32(e.y, half), shift, reach, out);
}

int project_orthographic(const struct transform *t, struct eye_point e, int32_t reach, struct screen_point *out);

/* Projects a point: 1, or 0 where it lies before the near plane, beyond the far one or farther from the centre than
 * `reach`. Positions are rounded to nearest sub-pixel, ties up; the value before rounding errs by less than 2^-8
 * sub-pixel inside a 1024-pixel picture. */
static inline int project_within(const struct transform *t, struct eye_point e, int32_t reach, struct screen_point *out)
{
    if (fx_wrap_u32(e.z - t->near_z) > t->range) /* near_z >= 1, |z| < 2^29 */
        return 0;
    return transform_divides(t) ? project_perspective(t, e, reach, out) : project_orthographic(t, e, reach, out);
}

/* A vertex: 1 if the clipper would surely leave it alone, so that a triangle needs it only if one of these is 0, and
 * edges of clipped and unclipped triangles agree. */
static inline int project(const struct transform *t, struct eye_point e, struct screen_point *out)
{
    return project_within(t, e, GUARD - 1, out);
}

/* A corner that the clipper left or made: as far as the guard band and a rounding. What a cut is rounded out by is more
 * than that where the near plane is nearer than 2^-14 of the object's reach, as so close by the units of z show: such a
 * corner is put where the guard band ends. 0 if it is as far out again. */
int project_clipped(const struct transform *t, const struct eye_point *e, struct screen_point *out);

#endif

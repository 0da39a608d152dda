/* SPDX-License-Identifier: MIT */
#include "geometry/project.h"

/* v * 2^up, or 0 if that is beyond `reach`. */
static int enlarged(int32_t v, int up, int32_t reach, int16_t *out)
{
    const int fits = v <= reach >> up && v >= -(reach >> up);
    *out = fits ? fx_s16(v * (1 << up)) : 0;
    return fits;
}

int project_extreme(int32_t x, int32_t y, int down, int32_t reach, struct screen_point *out)
{
    out->x = out->y = 0;
    if (down > 0)
        return 1;
    return down >= -14 && enlarged(x, -down, reach, &out->x) && enlarged(y, -down, reach, &out->y);
}

int project_orthographic(const struct transform *t, struct eye_point e, int32_t reach, struct screen_point *out)
{
    uint32_t to_far = fx_u32(t->far_z - e.z);
    /* to_far is below 2^(32 - up) where depth_shift = 47 - up: moved up to 32 bits it is below 2^32, and the product is
     * the depth times 2^(47 - up), less the 32 bits that mulhi drops. */
    unsigned up = t->depth_shift < 32 ? 32u - fx_u32(t->depth_shift) : 0,
             down = t->depth_shift > 32 ? fx_u32(t->depth_shift) - 32 : 0;
    const uint32_t depth = fx_mulhi_u32(to_far << up, t->depth_scale) >> down;
    out->depth = fx_u16(DEPTH_FAR + depth); /* all is rounded down, and to_far <= range */
    return project_round(e.x, e.y, t->shift, reach, out);
}

static __attribute__((noinline)) int16_t into_guard(int16_t v)
{
    return v > GUARD + 1 ? GUARD + 1 : v < -GUARD - 1 ? -GUARD - 1 : v;
}

int project_clipped(const struct transform *t, const struct eye_point *e, struct screen_point *out)
{
    if (!project_within(t, *e, INT16_MAX, out))
        return 0;
    out->x = into_guard(out->x);
    out->y = into_guard(out->y);
    return 1;
}

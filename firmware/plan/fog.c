/* SPDX-License-Identifier: MIT */
#include "plan/fog.h"

#define DEPTHS   (fx_u32(DEPTH_NEAR - DEPTH_FAR)) /* K */
#define ONE      (1 << 16)
#define MOST     (1 << 30)   /* of A / c and of B */
#define LOG2_E   3098164009u /* 1 / ln 2 in Q31 */
#define THINNEST 13

/* A positive number, m 2^-down with m in [2^31, 2^32). */
struct scaled {
    uint32_t m;
    int down;
};

FX_COLD static struct scaled scaled_of(uint64_t x, int down)
{
    for (; x >> 32 == 0; down++)
        x <<= 1;
    for (; x >> 32; down--) /* at most 31 bits go */
        x >>= 1;
    return (struct scaled){fx_u32(x), down};
}

static struct scaled product(struct scaled a, struct scaled b)
{
    return scaled_of(fx_u64(a.m) * b.m, a.down + b.down);
}

static struct scaled quotient(struct scaled a, struct scaled b)
{
    return scaled_of(fx_divide_u64(fx_u64(a.m) << 31, b.m), a.down + 31 - b.down);
}

/* x 2^-down, at most MOST. */
static int32_t fitted(uint32_t x, int down)
{
    if (down >= 32)
        return 0;
    if (down < 0) /* x is at least 2^30 then: orthographic A is at most 2^-2 */
        return MOST;
    x >>= down;
    return x > MOST ? MOST : fx_s32(x);
}

static int32_t q16_of(struct scaled a)
{
    return fitted(a.m, a.down - 16);
}

/* c in Q16. Depths are rounded down, once or in perspective twice: on the average half of that is put back. */
static uint32_t closeness_of(const struct fog *fog, uint32_t depth_q16)
{
    const uint32_t far = fx_u32(DEPTH_FAR) << 16, least = 1u << 14, back = fog->divides ? 1u << 16 : 1u << 15;
    return depth_q16 + back > far + least ? depth_q16 + back - far
                                          : least; /* depths are at most DEPTH_NEAR and a rounding */
}

/* u in Q16, -2^30..2^31. */
static int32_t argument(const struct fog *fog, uint32_t depth_q16)
{
    const uint32_t c = closeness_of(fog, depth_q16);
    if (!fog->divides) /* A c: the product's upper half is 2^-32 of it */
        return fog->offset - fitted(fx_mulhi_u32(fog->scale, c), fog->scale_down - 32);
    /* A / c = scale 2^-scale_down * r 2^(up - 63) 2^16, in Q16 2^16 more, of which mulhi takes 2^32 */
    const unsigned up = fx_clz(c);
    return fitted(fx_mulhi_u32(fog->scale, fx_recip_norm(c << up)), fog->scale_down - 1 - fx_s32(up)) - fog->offset;
}

static uint32_t part_of(const struct fog *fog, int32_t u)
{
    if (u <= 0)
        return 0;
    if (fog->kind == FOG_EXPONENTIAL)
        return ONE - fx_exp2_minus(fx_u32(u));
    return u < ONE ? fx_u32(u) : ONE;
}

uint32_t fog_part(const struct fog *fog, uint32_t depth_q16)
{
    return part_of(fog, argument(fog, depth_q16));
}

static uint32_t q14_of(uint32_t part_q16)
{
    return (part_q16 + 2) >> 2;
}

/* The least depth whose part in Q14 is at most `part`: it falls as depth rises. */
FX_COLD static uint16_t first_depth(const struct fog *fog, uint32_t part)
{
    uint32_t low = 0, high = DEPTH_NEAR + 1;
    while (low < high) {
        const uint32_t middle = (low + high) / 2;
        if (q14_of(fog_part(fog, middle << 16)) > part)
            low = middle + 1;
        else
            high = middle;
    }
    return fx_u16(low);
}

/* The greatest |dF/dc|, by which a depth counts that is off by 1 (orthographic: 1/2). In perspective du/dc = -A / c^2 =
 * -(u + B)^2 / A: linear fog has u <= 1, and 2^-u u^2 ln 2 <= 25/32. */
FX_COLD static uint16_t error_of(const struct fog *fog, struct scaled a)
{
    const int exponential = fog->kind == FOG_EXPONENTIAL;
    int32_t error;
    if (fog->divides) {
        const uint64_t reach = exponential ? 0 : fx_u64(fx_u32(ONE + fog->offset));
        error = q16_of(quotient(exponential ? scaled_of(25, 5) : scaled_of(reach * reach, 32), a));
    } else {
        error = q16_of(a) / 2;
    }
    error += exponential ? 10 : 4;
    return fx_u16(error > 65535 ? 65535 : error);
}

/* u a unit of exponential fog. In orthographic views B, u behind all, is below 2^14. */
FX_COLD static struct scaled density_of(const struct fog *fog, const struct scene_header *scene)
{
    const uint64_t most = fx_divide_u64(UINT64_C(177) << 46, fx_u32(scene->camera.far_plane)); /* 177/256 < ln 2 */
    const uint32_t density = scene->fog.density;
    return product(scaled_of(fog->divides || density < most ? density : most, 24), (struct scaled){LOG2_E, 31});
}

/* thickness: of linear fog. */
FX_COLD static struct scaled scale_of(const struct fog *fog, const struct scene_header *scene, uint32_t thickness)
{
    const struct scene_camera *camera = &scene->camera;
    const struct scaled depths = scaled_of(DEPTHS, 0);
    const struct scaled per_unit =
        fog->kind == FOG_LINEAR ? quotient(scaled_of(1, 0), scaled_of(thickness, 16)) : density_of(fog, scene);
    if (fog->divides)
        return product(product(scaled_of(fx_u32(camera->near_plane), 16), depths), per_unit);
    return product(quotient(scaled_of(fx_u32(camera->far_plane - camera->near_plane), 16), depths), per_unit);
}

FX_COLD void fog_begin(struct fog *fog, const struct scene_header *scene)
{
    const struct scene_fog *from = &scene->fog;
    const uint32_t far = fx_u32(scene->camera.far_plane);
    *fog = (struct fog){.kind = fx_u8(from->kind), .divides = scene->camera.kind == CAMERA_PERSPECTIVE};
    if (fog->kind == FOG_LINEAR && fx_u32(from->from) >= far)
        fog->kind = FOG_NONE;
    if (fog->kind == FOG_NONE)
        return;
    const uint32_t thinnest = (fog->divides ? fx_u32(from->from) : far) >> THINNEST;
    uint32_t thickness = fx_u32(from->to - from->from);
    thickness = thickness > thinnest ? thickness : thinnest;
    const struct scaled a = scale_of(fog, scene, thickness);
    fog->scale = a.m;
    fog->scale_down = fx_s16(a.down);
    if (fog->kind == FOG_LINEAR) {
        const int64_t to_far = fog->divides ? from->from : fx_s64(far) - from->from;
        fog->offset = fx_s32(fx_divide_s64(to_far * ONE, thickness));
    } else if (!fog->divides) {
        fog->offset = q16_of(product(scaled_of(far, 16), density_of(fog, scene)));
    }
    fog->error = error_of(fog, a);
    fog->clear = first_depth(fog, 0);
    fog->solid = first_depth(fog, (ONE >> 2) - 1);
    fog->solid = fx_u16(fog->solid ? fog->solid - 1 : 0);
}

/* How far the interpolation of u between the extremes can be above it, Q16. They differ by less than 1. */
static uint32_t bow_of(const struct fog *fog, int32_t near, int32_t far)
{
    if (!fog->divides)
        return 0;
    const uint32_t step = fx_u32(far - near);
    /* z in u's units: at most MOST, so a quarter of the sum is at most 2^30 */
    const uint32_t sum = 3 * (fx_u32(near + fog->offset) >> 2) + (fx_u32(far + fog->offset) >> 2);
    return sum ? (step * step >> 2) / sum + 2 : step;
}

/* Of exponential fog, where u changes by `step` < 1 and is nowhere less than `least`. */
static uint32_t exponential_error(uint32_t bow, uint32_t step, int32_t least)
{
    const uint32_t curve = step * step >> 20; /* (ln 2)^2 / 8 < 2^-4 */
    bow = bow * 45427 >> 16;                  /* ln 2 */
    bow = (bow > curve ? bow : curve) + 1;
    return (bow * fx_exp2_minus(least > 0 ? fx_u32(least) : 0) >> 16) + 2; /* bow < 3/4 * 2^16 */
}

/* How far the interpolated part can be off, Q16. */
static uint32_t linear_error(const struct fog *fog, int32_t near, int32_t far)
{
    if (far - near >= ONE)
        return ONE;
    const uint32_t bow = bow_of(fog, near, far); /* at most their difference and 2 */
    if (fog->kind == FOG_EXPONENTIAL)
        return exponential_error(bow, fx_u32(far - near), near);
    return bow + fx_u32(near < 0 ? -near : 0) + fx_u32(far > ONE ? far - ONE : 0);
}

uint32_t fog_run_error(const struct fog *fog, const int32_t depth[3], uint32_t step_q16)
{
    int32_t least = depth[0] < depth[1] ? depth[0] : depth[1], most = depth[0] < depth[1] ? depth[1] : depth[0];
    least = depth[2] < least ? depth[2] : least;
    most = depth[2] > most ? depth[2] : most;
    const int32_t most_u = argument(fog, fx_u32(least) << 16), least_u = argument(fog, fx_u32(most) << 16);
    const uint32_t at = fx_u32(least < fog->solid ? fog->solid : least) << 16, top = fx_u32(DEPTH_NEAR) << 16;
    if (step_q16 > top - at)
        return ONE;
    const int32_t near = argument(fog, at + step_q16), far = argument(fog, at);
    if (far - near >= ONE)
        return ONE;
    const uint32_t bow = bow_of(fog, near, far), step = fx_u32(far - near);
    if (fog->kind == FOG_EXPONENTIAL)
        return exponential_error(bow, step, least_u);
    return least_u < 0 || most_u > ONE ? bow + step / 4 + 1 : bow;
}

static void set_even(struct fog_plan *plan, uint32_t part_q14, int all)
{
    plan->kind = FOGGED_EVENLY;
    if (!all && part_q14 == 0)
        plan->kind = FOGGED_NOT;
    if (!all && part_q14 == ONE >> 2)
        plan->kind = FOGGED_WHOLLY;
    plan->part[0] = plan->part[1] = plan->part[2] = fx_s32(part_q14);
}

void fog_choose(const struct fog *fog, const int32_t depth[3], uint32_t allowed, int all, struct fog_plan *plan)
{
    uint32_t part[3], least = ONE, most = 0;
    int32_t near = INT32_MAX, far = INT32_MIN;
    plan->error = fog->error;
    if (depth[0] >= fog->clear && depth[1] >= fog->clear && depth[2] >= fog->clear) {
        plan->shown = ONE;
        plan->error = 0;
        set_even(plan, 0, all);
        return;
    }
    for (int k = 0; k < 3; k++) {
        const int32_t u = argument(fog, fx_u32(depth[k]) << 16);
        part[k] = part_of(fog, u);
        near = u < near ? u : near;
        far = u > far ? u : far;
        least = part[k] < least ? part[k] : least;
        most = part[k] > most ? part[k] : most;
    }
    plan->shown = ONE - least;
    const uint32_t range = most - least;
    if (range <= 2 * allowed) {
        plan->error += (range + 1) / 2;
        set_even(plan, q14_of((least + most) / 2), all);
        return;
    }
    for (int k = 0; k < 3; k++)
        plan->part[k] = fx_s32(q14_of(part[k]));
    const uint32_t error = linear_error(fog, near, far);
    plan->kind = error <= allowed ? FOGGED_LINEARLY : FOGGED_BY_PIXEL;
    plan->error += error <= allowed ? error : 0;
}

/* SPDX-License-Identifier: MIT */
#include "raster/normals.h"

#include "shade/perspective.h"

#define SHORTEST (1u << 12)

static inline __attribute__((always_inline)) void keep(struct raster *r, int i, int32_t x, int32_t y, int32_t z,
                                                       uint32_t squared)
{
    const struct normals_vector v = normals_vector(x, y, z, squared);
    r->value[0][i] = v.x;
    r->value[1][i] = v.y;
    r->value[2][i] = v.z;
    r->divisor[i].half = v.inverse;
}

/* Any length: the largest component is first moved to 15 bits. */
static void normalise_one(struct raster *r, int i)
{
    int32_t x = r->value[0][i], y = r->value[1][i], z = r->value[2][i];
    uint32_t size = fx_u32((x ^ x >> 31) | (y ^ y >> 31) | (z ^ z >> 31)); /* of the largest, within a bit */
    if (size < SHORTEST) {
        r->value[0][i] = r->value[1][i] = r->value[2][i] = 0;
        return;
    }
    const int32_t up = 1 << (fx_clz(size) - 1); /* 2^0..2^18: within [-2^31, 2^31) */
    x = x * up >> 16;
    y = y * up >> 16;
    z = z * up >> 16; /* within [-2^15, 2^15): each square at most 2^30, their sum at least 2^28 */
    keep(r, i, x, y, z, fx_u32(x * x) + fx_u32(y * y) + fx_u32(z * z));
}

static void normalise_any(struct raster *r, int n)
{
    for (int i = 0; i < n; i++)
        normalise_one(r, i);
}

/* Q30 in. Less than 1.2 long: what is linear is at most 1 + 2^-13, for corners that were rounded. One shorter than 2^-6
 * (between opposite corners, or where a quadratic passes 0) takes the longer way. */
static void normalise(struct raster *r, int n)
{
    for (int i = 0; i < n; i++) {
        int32_t x = r->value[0][i] >> 15, y = r->value[1][i] >> 15, z = r->value[2][i] >> 15; /* Q15 */
        uint32_t squared = fx_u32(x * x) + fx_u32(y * y) + fx_u32(z * z);                     /* Q30, below 2^31 */
        if (squared < 1u << 18)
            normalise_one(r, i);
        else
            keep(r, i, x, y, z, squared);
    }
}

static inline __attribute__((always_inline)) q30_t dot(const struct raster *r, int i, const q14_t u[3])
{
    const struct normals_vector v = {r->value[0][i], r->value[1][i], r->value[2][i], r->divisor[i].half};
    return normals_dot(&v, u);
}

static inline __attribute__((always_inline)) void add_diffuse(struct raster *r, int i, unsigned l,
                                                              const q14_t towards[3])
{
    const struct surface *s = &r->surface;
    const q30_t diffuse = dot(r, i, towards);
    if (diffuse > 0)
        for (unsigned c = 0; c < surface_channels(s); c++)
            r->sum[i][c] += surface_diffuse(fx_u32(diffuse) >> 15, s->light[l].diffuse[c]);
}

/* `formed`: by another form of the power than the table. */
static inline __attribute__((always_inline)) void add_highlight(struct raster *r, int i, unsigned l, q30_t highlight,
                                                                int formed)
{
    const struct surface *s = &r->surface;
    const uint32_t power = formed ? surface_power(s, highlight) : fx_power(s->power, highlight);
    for (unsigned c = 0; c < surface_channels(s); c++)
        raster_gloss(r)[3 * i + fx_s32(c)] += surface_diffuse(power, s->light[l].specular[c]);
}

/* By a W of their own: the depth's is exact to a part of the picture's nearest depth, which is not enough of a triangle
 * that reaches from the near plane a hundred times as far. Q30: s of the corners, from 1 on, times 2^14, and off by
 * less than 2^12 (coefficients by 2^11 over 2048 pixels and rows; see plane_wide.c), so never 0. */
static void find_divisors(struct raster *r, int x, int y, int n)
{
    plane_values(&r->setup.plane, &r->setup.channel[SHADE_WEIGHT], x, y, n, r->value[0]);
    for (int i = 0; i < n; i++)
        r->divisor[i] = perspective_divisor_of(fx_u32(r->value[0][i]) << 2);
}

/* Where lights or the eye are near: the places in 1/256 of position units, into r->value[3] to [5]. */
static __attribute__((noinline)) void find_places(struct raster *r, int x, int y, int n)
{
    const int perspective = r->setup.perspective;
    if (perspective)
        find_divisors(r, x, y, n);
    for (int c = 3; c < 6; c++) {
        int32_t *value = r->value[c];
        plane_values(&r->setup.plane, &r->setup.channel[c], x, y, n, value);
        for (int i = 0; i < n; i++)
            value[i] = perspective ? perspective_divide(value[i], r->divisor[i]) >> 7 : value[i] >> 8;
    }
}

/* All lights, far as the eye is, a run each. A template, as the next: `formed` is constant. */
static inline __attribute__((always_inline)) void add_lights_far(struct raster *r, int n, int formed)
{
    const struct surface *s = &r->surface;
    q14_t towards[3], half[3];
    for (unsigned l = 0; l < surface_lights(s); l++) {
        object_light_at(r->input.object, l, 0, towards, half);
        const int32_t lacks = normals_shortness(half);
        for (int i = 0; i < n; i++) {
            add_diffuse(r, i, l, towards);
            const q30_t highlight = surface_highlights(s) ? dot(r, i, half) : 0;
            if (highlight > 0)
                add_highlight(r, i, l, normals_lengthened(highlight, lacks), formed);
        }
    }
}

/* N.H of H = L + V, Q28 each, not made unit before: where they are all but opposite, H is short and only as good as
 * they. */
static q30_t half_way(const struct raster *r, int i, const int32_t towards[3], const int32_t eye[3])
{
    int32_t half[3];
    uint32_t largest = 1u << 13, squared = 0;
    for (int k = 0; k < 3; k++) { /* at most 2^29 (1 + 2^-19) */
        half[k] = towards[k] + eye[k];
        largest |= fx_u32(half[k] < 0 ? -half[k] : half[k]);
    }
    const int down = 18 - fx_s32(fx_clz(largest)); /* the largest to 14 bits; what is below 2^-15 is as good as none */
    for (int k = 0; k < 3; k++) {
        half[k] >>= down;
        squared += fx_u32(half[k] * half[k]); /* below 3 * 2^28 */
    }
    if (squared < 1u << 26)
        return 0;
    /* |v| |half| < 2^16 * 2^14.8, so the high product is below 2^28.8: N.H |H| in Q27 of |H| in Q14. 1 / |H| is inverse
     * 2^(even / 2) / 2^45. */
    const unsigned even = fx_clz(squared) & ~1u; /* 2 or 4 */
    const int32_t inverse = fx_s32(fx_rsqrt_norm(squared << even) >> 1);
    const int32_t sum = r->value[0][i] * half[0] + r->value[1][i] * half[1] + r->value[2][i] * half[2];
    return fx_mulhi_s32(fx_mulhi_s32(sum, r->divisor[i].half) * 4, inverse) * (1 << (2 + even / 2));
}

/* All lights where one of them or the eye is near, a pixel each. */
static inline __attribute__((always_inline)) void add_lights_near(struct raster *r, int n, int formed)
{
    const struct surface *s = &r->surface;
    const struct object_state *object = r->input.object;
    for (int i = 0; i < n; i++) {
        const int32_t place[3] = {r->value[3][i], r->value[4][i], r->value[5][i]};
        int32_t eye[3], way[3];
        object_towards(&object->eye, place, eye);
        for (unsigned l = 0; l < surface_lights(s); l++) {
            object_towards(&object->light[l].source, place, way);
            const q14_t towards[3] = {fx_s16((way[0] + (1 << 13)) >> 14), fx_s16((way[1] + (1 << 13)) >> 14),
                                      fx_s16((way[2] + (1 << 13)) >> 14)};
            add_diffuse(r, i, l, towards);
            const q30_t highlight = surface_highlights(s) ? half_way(r, i, way, eye) : 0;
            if (highlight > 0)
                add_highlight(r, i, l, highlight, formed);
        }
    }
}

static inline __attribute__((always_inline)) void add_lights(struct raster *r, int n, int formed)
{
    const struct surface *s = &r->surface;
    for (int i = 0; i < n; i++)
        for (unsigned c = 0; c < surface_channels(s); c++)
            r->sum[i][c] = s->base[c];
    if (object_local(r->input.object))
        add_lights_near(r, n, formed);
    else
        add_lights_far(r, n, formed);
}

FX_COLD static void add_lights_formed(struct raster *r, int n)
{
    add_lights(r, n, 1);
}

static __attribute__((noinline)) void light(struct raster *r, int n)
{
    if (surface_form(&r->surface))
        add_lights_formed(r, n);
    else
        add_lights(r, n, 0);
}

static void find_normals(struct raster *r, int x, int y, int n)
{
    for (int c = 0; c < 3; c++)
        plane_values(&r->setup.plane, &r->setup.channel[c], x, y, n, r->value[c]);
}

void normals_run(struct raster *r, int x, int y, int n)
{
    if (object_local(r->input.object))
        find_places(r, x, y, n);
    find_normals(r, x, y, n);
    normalise(r, n);
    light(r, n);
}

static __attribute__((noinline)) void light_any(struct raster *r, int n)
{
    normalise_any(r, n);
    light(r, n);
}

void normals_shade(struct raster *r, int x, int y, int n)
{
    if (object_local(r->input.object))
        find_places(r, x, y, n);
    light_any(r, n);
}

/* The divisors of places take r->value[0], so that normals come after them. */
void normals_run_perspective(struct raster *r, int x, int y, int n)
{
    if (object_local(r->input.object))
        find_places(r, x, y, n);
    find_normals(r, x, y, n);
    light_any(r, n);
}

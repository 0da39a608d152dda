/* SPDX-License-Identifier: MIT */
/*
 * X-shading (Barrera, Hast, Bengtsson 2006): N.L and N.H as quadratics over the triangle from the vertex normals
 * alone, eq. 32 in its order-free form
 *     Phi = sum Ii li - sum (Ii + Ij) kij li lj,    kij = (Ni.Nj - 1) / 2 precomputed with the mesh;
 * clamp and power per pixel.
 */
#include "plan/bounds.h"
#include "shade/shade.h"

/* The bulges (Ii + Ij) kij in Q28. |Ii + Ij| <= 2^15 and bend < 2^16: the product stays above -2^31. */
static void bulges(const int32_t value[3], const struct scene_triangle *triangle, int32_t out[3])
{
    out[0] = -(((value[0] + value[1]) * triangle->bend[2]) >> 2);
    out[1] = -(((value[1] + value[2]) * triangle->bend[1]) >> 2);
    out[2] = -(((value[2] + value[0]) * triangle->bend[0]) >> 2);
}

/* The same polynomial over a piece of the triangle whose corners have barycentric weights w[k]. Along an edge with
 * difference d of weights the second derivative is -2 sum aij di dj, so the piece's bulge is -sum aij di dj. */
static void restrict_to(const uint16_t (*w)[3], int32_t value[3], int32_t bulge[3])
{
    int32_t v[3], a[3];
    for (int k = 0; k < 3; k++) {
        int32_t linear = 0, bend = 0;
        for (int i = 0; i < 3; i++) { /* |value| <= 2^14, weights sum to 2^15 */
            int j = i == 2 ? 0 : i + 1;
            linear += value[i] * w[k][i];
            bend +=
                fx_mulhi_s32(bulge[i], (int32_t)((uint32_t)w[k][i] * w[k][j])); /* Q28 * Q30: Q26; product <= 2^30 */
        }
        v[k] = (linear >> 15) - (bend >> 12);
        int next = k == 2 ? 0 : k + 1;
        int32_t d[3], sum = 0;
        for (int i = 0; i < 3; i++)
            d[i] = (int32_t)w[next][i] - w[k][i]; /* |d| <= 2^15 */
        for (int i = 0; i < 3; i++)
            sum += fx_mulhi_s32(bulge[i], d[i] * d[i == 2 ? 0 : i + 1]);
        a[k] = -sum * 4; /* |sum| <= 3 * 2^28 * 2^30 / 2^32 at the very most, below 2^28 for unit normals */
    }
    for (int k = 0; k < 3; k++) {
        value[k] = v[k];
        bulge[k] = a[k];
    }
}

/* How much the highlight can change, in Q8 steps, when N.H of at most `top` is off by `bend`: the power is convex. */
static uint32_t highlight_slack(const struct surface *s, unsigned light, int32_t top, int32_t bend)
{
    top = top > 16384 ? 16384 : top; /* beyond, the power is clamped */
    int32_t lower = top > bend ? top - bend : 0;
    uint32_t change = fx_power(s->power, (q30_t)(top << 16)) - fx_power(s->power, (q30_t)(lower << 16));
    return surface_diffuse(change, s->light[light].specular_most) >> 7;
}

/* One dot product of a light over the triangle, where it can show. Returns 0 if not. Twice a triangle and light, with
 * `highlight` constant. */
static inline __attribute__((always_inline)) int interpolate(struct shade_setup *setup, const struct shade_input *in,
                                                             unsigned light, unsigned highlight, int32_t curl)
{
    const struct surface *s = in->surface;
    struct channel *channel = &setup->channel[2 * light + highlight];
    int32_t value[3], bulge[3];
    for (int k = 0; k < 3; k++)
        value[k] = in->lights[k][2 * light + highlight];
    struct bounds range = bounds_of(value); /* of a clipped piece too: it lies in its source */
    int32_t bend = bounds_bend(range, curl), top = range.high + bend;
    int32_t floor = highlight ? bounds_power_floor(s->power) : 1;
    int deep = highlight && range.low - bend - floor < -32768 + 256; /* less the floor, it may pass -2 in Q30 */
    uint32_t error = 0; /* steps in Q8 at full intensity times a Q14 bend: below 2^16 * 2^15 */
    if (top < floor) {
        if (!in->no_plan || deep)
            return 0;
    } else if (highlight) {
        error = highlight_slack(s, light, top, bend);
        setup->runs_only |= (uint8_t)deep;
    } else {
        error = (s->light[light].diffuse_most * (uint32_t)bend) >> 14;
    }
    int linear = error < s->bend_limit;
    if (!linear || in->weight) {
        bulges(value, in->triangle, bulge);
        if (in->weight)
            restrict_to(in->weight, value, bulge);
    }
    if (linear) {
        plane_linear(&setup->plane, value, channel);
    } else {
        if (!setup->quadratic)
            plane_setup_quadratic(&setup->plane);
        setup->quadratic = 1;
        plane_quadratic(&setup->plane, value, bulge, channel);
    }
    setup->runs_only |= (uint8_t)channel->exact;
    return 1;
}

void shade_x(struct shade_setup *setup, const struct shade_input *in)
{
    int32_t curl = bounds_curl(in->triangle->bend);
    setup->runs_only = setup->depth.exact != 0;
    for (unsigned i = 0; i < in->surface->lights; i++) {
        if (interpolate(setup, in, i, 0, curl))
            setup->diffuse_lights |= (uint8_t)(1u << i);
        if (in->surface->highlights && interpolate(setup, in, i, 1, curl))
            setup->specular_lights |= (uint8_t)(1u << i);
    }
}

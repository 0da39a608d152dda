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
static void bulges(const int32_t value[3], const int32_t bend[3], int32_t out[3])
{
    out[0] = -(((value[0] + value[1]) * bend[0]) >> 2);
    out[1] = -(((value[1] + value[2]) * bend[1]) >> 2);
    out[2] = -(((value[2] + value[0]) * bend[2]) >> 2);
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
            bend += fx_mulhi_s32(bulge[i], (int32_t)((uint32_t)w[k][i] * w[k][j])); /* Q28 * Q30: Q26; product <= 2^30 */
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

/* One dot product over the triangle: its corner values and bulges; returns a third of the largest bulge, Q14. */
static int32_t interpolant(const struct shade_input *in, unsigned which, int32_t value[3], int32_t bulge[3])
{
    for (int k = 0; k < 3; k++)
        value[k] = in->lights[k][which];
    bulges(value, in->bend, bulge);
    if (in->weight)
        restrict_to(in->weight, value, bulge);
    return bounds_bend(bulge);
}

/* A bend below this, in steps of the output, is not drawn: a quarter step at most, Q8. */
#define BEND_STEPS_Q8 64

static uint32_t largest_of(const uint16_t v[3], unsigned channels)
{
    uint32_t largest = v[0];
    for (unsigned c = 1; c < channels; c++)
        largest = v[c] > largest ? v[c] : largest;
    return largest;
}

/* How much the highlight changes, in Q8 steps, when N.H at its largest is off by `bend`. */
static uint32_t highlight_slack(const struct surface *s, unsigned light, int32_t top, int32_t bend)
{
    int32_t lower = top - bend;
    top = top > 16384 ? 16384 : top;
    lower = lower > 16384 ? 16384 : lower < 0 ? 0 : lower;
    uint32_t change = fx_power(s->power, (q30_t)(top << 16)) - fx_power(s->power, (q30_t)(lower << 16));
    return surface_diffuse(change, largest_of(s->light[light].specular, s->channels)) >> 7;
}

void shade_x(struct shade_setup *setup, const struct shade_input *in)
{
    const struct surface *s = in->surface;
    int32_t floor = bounds_power_floor(s->power);
    int32_t value[3], bulge[3];
    int prepared = 0;
    setup->diffuse_lights = setup->specular_lights = setup->quadratic = 0;
    for (unsigned i = 0; i < s->lights; i++) {
        for (unsigned k = 0; k < 2; k++) { /* diffuse, then specular */
            if (k && !s->highlights)
                break;
            int32_t bend = interpolant(in, 2 * i + k, value, bulge);
            int32_t top = bounds_top(value, bend);
            if (top < (k ? floor : 1) && !in->no_plan)
                continue;
            /* steps in Q8 at full intensity times a Q14 bend: below 2^16 * 2^15 */
            uint32_t error = k ? highlight_slack(s, i, top, bend)
                               : (largest_of(s->light[i].diffuse, s->channels) * (uint32_t)bend) >> 14;
            struct channel *channel = &setup->channel[2 * i + k];
            if (k)
                setup->specular_lights |= (uint8_t)(1u << i);
            else
                setup->diffuse_lights |= (uint8_t)(1u << i);
            if (error < BEND_STEPS_Q8) {
                plane_linear(&setup->plane, value, channel);
                continue;
            }
            if (!prepared)
                plane_setup_quadratic(&setup->plane);
            prepared = 1;
            setup->quadratic = 1;
            plane_quadratic(&setup->plane, value, bulge, channel);
        }
    }
}

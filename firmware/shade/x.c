/* SPDX-License-Identifier: MIT */
/*
 * X-shading (Barrera, Hast, Bengtsson 2006): N.L and N.H as quadratics over the triangle from the vertex normals
 * alone, eq. 32 in its order-free form
 *     Phi = sum Ii li - sum (Ii + Ij) kij li lj,    kij = (Ni.Nj - 1) / 2 precomputed with the mesh;
 * clamp and power per pixel.
 */
#include "shade/dots.h"
#include "shade/piece.h"

/* The bulges (Ii + Ij) kij in Q28. |Ii + Ij| <= 2^15 and bend < 2^16: the product stays above -2^31. */
static void bulges(const int32_t value[3], const struct scene_triangle *triangle, int32_t out[3])
{
    out[0] = -(((value[0] + value[1]) * triangle->bend[2]) >> 2);
    out[1] = -(((value[1] + value[2]) * triangle->bend[1]) >> 2);
    out[2] = -(((value[2] + value[0]) * triangle->bend[0]) >> 2);
}

/* One dot product of a light over the triangle, where it can show. Returns 0 if not. A template for the first light,
 * with `light` and `highlight` constant. `alone`: no other light shows. */
static inline __attribute__((always_inline)) int interpolate(struct shade_setup *setup, const struct shade_input *in,
                                                             unsigned light, unsigned highlight, int32_t curl,
                                                             int alone)
{
    struct channel *channel = &setup->channel[2 * light + highlight];
    int32_t value[3], bulge[3];
    for (int k = 0; k < 3; k++)
        value[k] = in->lights[k][2 * light + highlight];
    struct bounds range = bounds_of(value); /* of a clipped piece too: it lies in its source */
    uint32_t error;
    const int32_t bend = bounds_bend(range, curl);
    if (!dots_show(setup, in, light, highlight, range, bend, 0, &error))
        return 0;
    int linear = error < dots_limit(in->surface, alone);
    if (!linear || shade_weight(in)) {
        bulges(value, in->triangle, bulge);
        if (shade_weight(in))
            piece_quadratic(shade_weight(in), value, bulge);
    }
    if (!highlight && alone && surface_fold(in->surface))
        steps_take(setup, in->surface, range, bend, value, linear ? 0 : bulge);
    if (linear) {
        plane_linear(&setup->plane, value, channel);
    } else {
        if (!setup->quadratic)
            plane_setup_quadratic(&setup->plane);
        setup->quadratic = 1;
        plane_quadratic(&setup->plane, value, bulge, channel);
    }
    setup->runs_only |= fx_u8(channel->exact);
    return 1;
}

static __attribute__((noinline)) int interpolate_other(struct shade_setup *setup, const struct shade_input *in,
                                                       unsigned light, unsigned highlight, int32_t curl)
{
    return interpolate(setup, in, light, highlight, curl, 0);
}

static void factors_of(const struct shade_input *in, struct dots_factors *factors)
{
    for (int k = 0; k < 3; k++)
        factors->edge[k] = (1u << 16) + dots_bend(in, k) / 2;
    factors->stretch = 1u << 16;
    factors->are_dots = factors->folds = 1;
}

/* Where light or eye is near: their vectors at the mid-edges are unit ones of that place (eq. 33 with eq. 16). */
static __attribute__((noinline)) void setup_by_samples(struct shade_setup *setup, const struct shade_input *in,
                                                       const struct perspective *perspective)
{
    struct dots_factors factors;
    factors_of(in, &factors);
    dots_setup(setup, in, &factors, perspective);
}

void shade_x_perspective(struct shade_setup *setup, const struct shade_input *in)
{
    struct perspective perspective;
    if (perspective_setup(&perspective, in))
        setup_by_samples(setup, in, &perspective);
    else
        shade_x(setup, in);
}

void shade_x(struct shade_setup *setup, const struct shade_input *in)
{
    if (in->sampled && (object_local(in->object) || surface_form(in->surface))) {
        setup_by_samples(setup, in, 0);
        return;
    }
    int32_t curl = bounds_curl(in->triangle->bend);
    setup->runs_only = setup->depth.exact != 0;
    /* The first last, to know whether it is alone. */
    for (unsigned left = surface_lights(in->surface); USES(USES_SEVERAL_LIGHTS) && left > 1; left--) {
        const unsigned i = left - 1;
        if (interpolate_other(setup, in, i, 0, curl))
            setup->diffuse_lights |= fx_u8(1u << i);
        if (surface_highlights(in->surface) && interpolate_other(setup, in, i, 1, curl))
            setup->specular_lights |= fx_u8(1u << i);
    }
    if (!surface_lights(in->surface))
        return;
    const int alone = shade_alone(setup);
    if (interpolate(setup, in, 0, 0, curl, alone))
        setup->diffuse_lights |= 1;
    if (surface_highlights(in->surface) && interpolate(setup, in, 0, 1, curl, alone))
        setup->specular_lights |= 1;
}

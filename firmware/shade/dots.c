/* SPDX-License-Identifier: MIT */
#include "shade/dots.h"

#include "shade/piece.h"

uint32_t dots_length_factor(uint32_t bend)
{
    const uint32_t one = 1u << 16;
    uint32_t x = bend > one - 256 ? 256 : one - bend; /* 1 + k in Q16, 2^8..2^16 */
    unsigned up = fx_clz(x) & ~1u;                    /* x 2^up in [2^30, 2^32): 14..22 */
    /* 2^46 / sqrt(x 2^up) = 2^24 / sqrt(x) * 2^(22 - up / 2) */
    unsigned down = 22 - up / 2;
    return (fx_rsqrt_norm(x << up) + (1u << (down - 1))) >> down;
}

/* n . v, the normal the sum of two: |n| <= 2 (1 + 2^-13), |v| <= 1 + 2^-12, Q14: below 2^29.1. */
static int32_t dot(const int32_t normal[3], const q14_t v[3])
{
    return (normal[0] * v[0] + normal[1] * v[1] + normal[2] * v[2] + (1 << 13)) >> 14;
}

void dots_sample(const struct shade_input *in, unsigned light, struct dots_samples *samples)
{
    for (int which = 0; which < 2; which++)
        for (int k = 0; k < 3; k++)
            samples->corner[which][k] = in->lights[k][2 * light + fx_u32(which)];
    for (int k = 0; k < 3; k++) {
        const int next = k == 2 ? 0 : k + 1;
        if (!object_local(in->object)) {
            for (int which = 0; which < 2; which++)
                samples->middle[which][k] = samples->corner[which][k] + samples->corner[which][next];
            continue;
        }
        const struct scene_vertex *a = &in->vertices[in->triangle->corner[SHADE_TURN(k)]],
                                  *b = &in->vertices[in->triangle->corner[SHADE_TURN(next)]];
        int32_t place[3], normal[3];
        q14_t towards[3], half[3];
        for (int i = 0; i < 3; i++) {
            place[i] = (a->position[i] + b->position[i]) >> 1;
            normal[i] = a->normal[i] + b->normal[i];
        }
        object_light_at(in->object, light, place, towards, half);
        samples->middle[0][k] = dot(normal, towards);
        samples->middle[1][k] = dot(normal, half);
    }
}

void dots_bulges(const int32_t corner[3], const int32_t middle[3], const struct dots_factors *factors, int32_t out[3])
{
    for (int k = 0; k < 3; k++) {
        int32_t sum = corner[k] + corner[k == 2 ? 0 : k + 1];
        /* |sum| <= 2^15, |m D| <= 2^15 (1 + 2^-3): D shrinks where m grows, but for what bends are off; Q30, < 2^32 */
        int64_t bulge = fx_s64(sum) * (1 << 15) - ((fx_s64(middle[k]) * factors->edge[k]) >> 1);
        out[k] = bulge > INT32_MAX ? INT32_MAX : bulge < -INT32_MAX ? -INT32_MAX : fx_s32(bulge);
    }
}

/* x times a factor in Q16. */
static int32_t stretched(int32_t x, uint32_t factor)
{
    return fx_s32((fx_s64(x) * factor) >> 16);
}

void dots_quadratic(struct shade_setup *setup, const int32_t value[3], const int32_t bulge[3], struct channel *channel)
{
    const uint32_t most = PLANE_MOST_BULGE;
    if (fx_within(bulge[0], most) && fx_within(bulge[1], most) && fx_within(bulge[2], most))
        plane_quadratic(&setup->plane, value, bulge, channel);
    else
        plane_quadratic_large(&setup->plane, value, bulge, channel);
}

static void interpolate(struct shade_setup *setup, const struct shade_input *in, unsigned index, int linear,
                        int32_t value[3], int32_t bulge[3], const struct perspective *perspective,
                        const struct glint_power *form, struct bounds range, int32_t bend, int in_steps)
{
    struct channel *channel = &setup->channel[index];
    if (shade_weight(in))
        piece_quadratic(shade_weight(in), value, bulge);
    if (in_steps)
        steps_take(setup, in->surface, range, bend, value, bulge);
    if (form) {
        int32_t folded[3];
        setup->folded = fx_u8(form->fold(in->surface->power->exponent, value, bulge, folded, bulge));
        if (linear)
            form->linear(&setup->plane, folded, channel);
        else
            plane_quadratic_wide(&setup->plane, folded, bulge, channel);
        setup->quadratic |= fx_u8(!linear);
    } else if (perspective) {
        perspective->quadratic(perspective, &setup->plane, value, bulge, channel);
    } else if (linear) {
        plane_linear(&setup->plane, value, channel);
    } else {
        setup->quadratic = 1;
        dots_quadratic(setup, value, bulge, channel);
    }
    setup->runs_only |= fx_u8(channel->exact != 0);
}

/* 4 in Q14, beyond what any channel holds: a step count in Q8 times it fits. */
#define MOST_BEND 65535

void dots_setup(struct shade_setup *setup, const struct shade_input *in, const struct dots_factors *factors,
                const struct perspective *perspective)
{
    const struct surface *s = in->surface;
    setup->runs_only = setup->depth.exact != 0;
    setup->perspective = perspective ? fx_u8(perspective->up + 1u) : 0;
    plane_setup_quadratic(&setup->plane);
    const struct glint_power *const form = surface_form(s);
    const int folds = form && form->fold && factors->are_dots && !perspective && !in->tabled;
    for (unsigned left = surface_lights(s); left > 0; left--) { /* the first last: is it alone? */
        const unsigned i = left - 1;
        const int alone = !i && shade_alone(setup);
        struct dots_samples samples;
        uint8_t *const shown[2] = {&setup->diffuse_lights, &setup->specular_lights};
        dots_sample(in, i, &samples);
        for (unsigned which = 0; which < (surface_highlights(s) ? 2u : 1u); which++) {
            int32_t bulge[3];
            uint32_t error;
            struct bounds range = bounds_of(samples.corner[which]);
            dots_bulges(samples.corner[which], samples.middle[which], factors, bulge);
            range.low = range.low < 0 ? stretched(range.low, factors->stretch) : range.low;
            range.high = stretched(range.high, factors->stretch);
            int32_t bend = stretched(dots_bulge_bend(bulge), factors->stretch);
            bend = bend < MOST_BEND ? bend : MOST_BEND;
            if (!dots_show(setup, in, i, which, range, bend, form != 0, &error))
                continue;
            *shown[which] |= fx_u8(1u << i);
            const int in_steps = !which && alone && factors->folds && surface_fold(s) && !perspective;
            interpolate(setup, in, 2 * i + which, error < dots_limit(s, alone), samples.corner[which], bulge,
                        perspective, which && folds ? form : 0, range, bend, in_steps);
        }
    }
}

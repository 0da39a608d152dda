/* SPDX-License-Identifier: MIT */
/*
 * shade/dots.c: length factors of any bend, samples and bulges of any corners under near lights and far ones, and what
 * their roundings can do to a highlight. object_light_at() is any pair of vectors here.
 *
 *   proves: dots_length_factor dot dots_sample dots_bulges stretched dots_quadratic dots_bulge_bend
 *           dots_highlight_slack dots_wide dots_deep bounds_power_floor
 *   assumes: fx_rsqrt_norm fx_power plane_quadratic plane_quadratic_large
 *   options: -eva-precision 0 -eva-slevel 60 -eva-min-loop-unroll 3 -eva-split-return full -eva-domains octagon
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "contracts.h"
#include "planes.h"
#include "samples.h"

/*@ requires \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid_read(bulge + (0 .. 2)) && \valid(channel);
    assigns *channel \from *plane, value[0 .. 2], bulge[0 .. 2]; */
void plane_quadratic(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                     struct channel *channel);

/*@ requires \valid_read(table);
    assigns \result \from *table, s; */
static inline uint32_t fx_power(const struct fx_power *table, q30_t s);

#include "firmware/shade/dots.c"

volatile int32_t sink;

static void vector(int16_t v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = any_s32(-16386, 16386);
}

/* In place of geometry/light.c: unit vectors within 2^-12. */
void object_light_at(const struct object_state *object, unsigned i, const int32_t place[3], q14_t towards[3],
                     q14_t half[3])
{
    for (int k = 0; k < 3; k++) {
        towards[k] = any_s32(-16388, 16388);
        half[k] = any_s32(-16388, 16388);
    }
}

static void samples(void)
{
    static struct scene_vertex vertex[3];
    static struct object_state object;
    static struct shade_setup setup;
    struct scene_triangle triangle = {.corner = {any_u32(0, 2), any_u32(0, 2), any_u32(0, 2)}};
    int16_t lights[3][2 * SCENE_MAX_LIGHTS];
    struct shade_input in = {
        .lights = {lights[0], lights[1], lights[2]}, .triangle = &triangle, .vertices = vertex, .object = &object};
    struct dots_samples out;
    struct dots_factors factors;
    int32_t bulge[3];
    any_bytes(vertex, sizeof vertex);
    for (int k = 0; k < 3; k++) {
        vector(vertex[k].normal);
        factors.edge[k] = any_u32(0, 1 << 20);
        for (unsigned i = 0; i < 2 * SCENE_MAX_LIGHTS; i++)
            lights[k][i] = any_s32(-16388, 16388);
    }
    any_bytes(&object, sizeof object);
    dots_sample(&in, any_u32(0, SCENE_MAX_LIGHTS - 1), &out);
    //@ loop unroll 2;
    for (int which = 0; which < 2; which++) {
        dots_bulges(out.corner[which], out.middle[which], &factors, bulge);
        sink = stretched(dots_bulge_bend(bulge), any_u32(1 << 16, 1 << 20));
        dots_quadratic(&setup, out.corner[which], bulge, &setup.channel[0]);
    }
}

void prove(void)
{
    static struct surface surface;
    struct fx_power power;
    struct bounds range = {any_s32(-(1 << 20), 1 << 20), any_s32(-(1 << 20), 1 << 20)};
    const int32_t bend = any_s32(0, 65535);
    sink = dots_length_factor(any_u32(0, 65535));
    any_bytes(&power, sizeof power);
    power.octave = any_u32(0, FX_POWER_MAX_OCTAVE);
    any_bytes(&surface, sizeof surface);
    surface.power = &power;
    sink = dots_wide(&power, range, bend);
    sink = dots_deep(&power, range, bend);
    sink = dots_highlight_slack(&surface, any_u32(0, SCENE_MAX_LIGHTS - 1), any_s32(0, 1 << 20), bend);
    samples();
}

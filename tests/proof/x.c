/* SPDX-License-Identifier: MIT */
/*
 * shade/x.c and shade/six.c: any lights, bends and surfaces, whole triangles and pieces. Bends belong to their normals,
 * as scene_check() asks, which the lemma has.
 *
 *   proves: bulges interpolate interpolate_other factors_of setup_by_samples shade_x_perspective shade_x
 *           setup_of shade_six shade_six_perspective
 *   assumes: fx_power dots_setup dots_length_factor perspective_setup plane_setup_quadratic plane_linear
 *            plane_quadratic
 *   lemmas: x six_samples
 *   options: -eva-precision 0 -eva-slevel 30 -eva-min-loop-unroll 3
 */
#include "proof.h"

#include "pieces.h"

#include "shade/shade.h"

/* What the program has: a constant of its own. */
static uint32_t uses;
#undef GLINT_USES
#define GLINT_USES uses

#include "samples.h"

/*@ requires \valid_read(table);
    assigns \result \from *table, s; */
static inline uint32_t fx_power(const struct fx_power *table, q30_t s);

/*@ requires \valid(setup) && \valid_read(in) && \valid_read(factors);
    requires edges: factors->edge[0] <= 0x100000 && factors->edge[1] <= 0x100000 && factors->edge[2] <= 0x100000;
    requires stretch: 0x10000 <= factors->stretch <= 0x100000;
    assigns *setup \from *setup; */
void dots_setup(struct shade_setup *setup, const struct shade_input *in, const struct dots_factors *factors,
                const struct perspective *perspective);

/*@ requires \valid(p) && \valid_read(in);
    assigns p->s[0 .. 2], p->up \from indirect: *in;
    assigns \result \from indirect: *in; */
int perspective_setup(struct perspective *p, const struct shade_input *in);

/*@ requires \valid(plane);
    assigns *plane \from *plane; */
void plane_setup_quadratic(struct plane *plane);

/*@ requires \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid_read(bulge + (0 .. 2)) && \valid(channel);
    assigns *channel \from indirect: *plane, value[0 .. 2], bulge[0 .. 2]; */
void plane_quadratic(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                     struct channel *channel);

#include "firmware/shade/six.c"
#include "firmware/shade/x.c"
#include "six_samples.h"

static struct shade_setup setup;

void prove(void)
{
    static struct surface surface;
    static struct object_state object;
    static struct scene_triangle triangle;
    uint16_t weight[3][3];
    int16_t lights[3][2 * SCENE_MAX_LIGHTS];
    struct fx_power power;
    struct shade_input in = {.lights = {lights[0], lights[1], lights[2]},
                             .triangle = &triangle,
                             .object = &object,
                             .surface = &surface,
                             .sampled = any_flag(),
                             .no_plan = any_flag()};
    uses = any_u32(0, USES_ALL);
    any_bytes(&triangle, sizeof triangle);
    any_bytes(&object, sizeof object);
    any_bytes(weight, sizeof weight);
    for (int k = 0; k < 3; k++)
        //@ loop unroll 16;
        for (unsigned i = 0; i < 2 * SCENE_MAX_LIGHTS; i++)
            lights[k][i] = any_s32(-16400, 16400);
    any_bytes(&power, sizeof power);
    power.octave = any_u32(0, FX_POWER_MAX_OCTAVE);
    any_bytes(&surface, sizeof surface);
    surface.power = &power;
    surface.lights = any_u32(0, SCENE_MAX_LIGHTS);
    surface.form = 0;
    //@ loop unroll 2;
    for (int piece = 0; piece < 2; piece++) {
        in.weight = piece ? weight : 0;
        any_bytes(&setup, sizeof setup);
        shade_x(&setup, &in);
        shade_x_perspective(&setup, &in);
        shade_six(&setup, &in);
        shade_six_perspective(&setup, &in);
    }
}

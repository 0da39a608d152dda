/* SPDX-License-Identifier: MIT */
/*
 * shade/dots.c: which dot products show on a triangle, and channels of them, for any lights, surfaces and forms of the
 * power, flat and in perspective. Samples and bulges are any that dots.c leaves; over a piece N.L stays below 2, as
 * the lemma shows of six samples of unit vectors.
 *
 *   proves: dots_limit dots_show interpolate dots_setup steps_take steps_fold steps_fold_bulges steps_plain
 *   assumes: fx_power dots_sample dots_bulges dots_quadratic plane_setup_quadratic plane_linear plane_quadratic_wide
 *   lemmas: samples six_samples
 *   options: -eva-precision 0 -eva-slevel 30 -eva-min-loop-unroll 3
 */
#include "proof.h"

#include "pieces.h"

#include "shade/shade.h"

/* What the program has: a constant of its own. */
static uint32_t uses;
#undef GLINT_USES
#define GLINT_USES uses

/*@ requires \valid_read(table);
    assigns \result \from *table, s; */
static inline uint32_t fx_power(const struct fx_power *table, q30_t s);

#include "samples.h"

/*@ requires \valid(plane);
    assigns *plane \from *plane; */
void plane_setup_quadratic(struct plane *plane);

#include "firmware/shade/dots.c"
#include "six_samples.h"

/* In place of shade/power.c and of the parts of perspective that are called by pointer. */
static unsigned fold(unsigned n, const int32_t value[3], const int32_t bulge[3], int32_t value_out[3],
                     int32_t bulge_out[3])
{
    for (int k = 0; k < 3; k++) {
        value_out[k] = ANY_S32;
        bulge_out[k] = ANY_S32;
    }
    return any_u32(0, 30);
}
static void linear(const struct plane *plane, const int32_t value[3], struct channel *channel)
{
    channel->exact = any_s32(0, 2);
}
static void quadratic(const struct perspective *p, const struct plane *plane, const int32_t value[3],
                      const int32_t bulge[3], struct channel *channel)
{
    channel->exact = any_s32(0, 2);
}

static struct shade_setup setup;
static struct surface surface;

static void set_up(struct shade_input *in, const struct perspective *perspective, const struct glint_power *form)
{
    struct dots_factors factors = {.stretch = any_u32(1 << 16, 1 << 20), .are_dots = any_flag(), .folds = any_flag()};
    for (int k = 0; k < 3; k++)
        factors.edge[k] = any_u32(0, 1 << 20);
    any_bytes(&setup, sizeof setup);
    setup.diffuse_lights = setup.specular_lights = 0;
    any_bytes(&surface, sizeof surface);
    surface.lights = any_u32(0, SCENE_MAX_LIGHTS);
    surface.form = form;
    struct fx_power power;
    any_bytes(&power, sizeof power);
    power.octave = any_u32(0, FX_POWER_MAX_OCTAVE);
    surface.power = &power;
    dots_setup(&setup, in, &factors, perspective);
}

void prove(void)
{
    static const struct glint_power folds = {0, fold, 0, linear}, plain = {0, 0, 0, 0};
    const struct perspective perspective = {.up = any_u32(0, 15), .quadratic = quadratic};
    uint16_t weight[3][3];
    struct shade_input in = {.surface = &surface, .no_plan = any_flag(), .tabled = any_flag()};
    uses = any_u32(0, USES_ALL);
    any_bytes(weight, sizeof weight);
    //@ loop unroll 2;
    for (int piece = 0; piece < 2; piece++) {
        in.weight = piece ? weight : 0;
        set_up(&in, 0, 0);
        set_up(&in, 0, &folds);
        set_up(&in, 0, &plain);
        set_up(&in, &perspective, any_flag() ? &folds : 0);
    }
}

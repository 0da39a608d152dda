/* SPDX-License-Identifier: MIT */
/*
 * What a material is under a scene's lights, in steps of the output: a channel's full intensity is 255 for 8 bits, 31
 * or 63 for the fields of 565, 15 for 4-bit grey. Sums are kept in Q15 of a step.
 */
#ifndef GLINT_SURFACE_H
#define GLINT_SURFACE_H

#include "plan/plan.h"
#include "shade/power.h"

/* The output's channels: 1 (grey) or 3, and the largest value of each. */
struct palette {
    uint8_t channels;
    uint8_t top[3];
};

/* A bump map of the scene, ready for its pixels. */
struct surface_bump {
    const int8_t (*texel)[2];        /* null: none */
    const uint16_t *rise;            /* Q14 */
    uint8_t log2_width, log2_height; /* 0..10 */
    uint8_t flags;
    uint16_t steepness; /* Q14 */
};

/* A texture, for the pixels. */
struct surface_texture {
    const void *texels; /* null: none */
    const uint32_t *palette;
    const struct scene_texture *head;
    uint32_t lit;     /* the most light that it can be under, Q8 of full intensity, rounded up */
    uint16_t grey[3]; /* what red, green and blue of a texel count in a grey picture, Q8, of sum 1 */
};

struct surface {
    const struct fx_power *power;
    const struct glint_power *form; /* of the power; null: the table */
    uint8_t channels, lights;
    uint8_t bend_limit; /* a bend that moves a channel by less is left out: half a step over all lights, Q8 */
    uint8_t highlights; /* some channel of `specular` is not 0 */
    /* 8-bit grey (shade/steps.h), else 0: the first light's diffuse part in Q16 of 256 steps, and the ambient part with
     * the rounding half, Q7 steps */
    uint16_t fold, ambient;
    struct plan_surface plan; /* glint_auto's; its power is null until surface_plan() has filled it */
    struct surface_texture texture;
    uint32_t base[3]; /* ambient part, Q15 steps, at most 255 * 2^15 */
    uint32_t top[3];  /* full intensity, Q15 steps */
    struct {
        uint16_t diffuse[3], specular[3];     /* at N.L = 1, (N.H)^n = 1: Q8 steps, at most 255 * 2^8 */
        uint16_t diffuse_most, specular_most; /* the largest of each */
    } light[SCENE_MAX_LIGHTS];
    struct surface_bump bump;
};

/* Of them, what a program for given scenes and formats knows at once. */
static inline unsigned surface_channels(const struct surface *s)
{
    return uses_channels(s->channels);
}
static inline unsigned surface_lights(const struct surface *s)
{
    return USES(USES_SEVERAL_LIGHTS) ? s->lights : s->lights != 0;
}
static inline int surface_bumps(const struct surface *s)
{
    return USES(USES_BUMP) && s->bump.texel;
}
static inline int surface_highlights(const struct surface *s)
{
    return USES(USES_SPECULAR) && s->highlights;
}
static inline const struct glint_power *surface_form(const struct surface *s)
{
    return USES(USES_POWERS) ? s->form : 0;
}
static inline uint32_t surface_fold(const struct surface *s)
{
    return USES(USES_GREY8) ? s->fold : 0;
}

void surface_setup(struct surface *surface, const struct scene_header *scene, const struct scene_material *material,
                   const struct palette *palette);

/* Fills surface->plan of a surface that is set up, for a budget in Q8 of 1/255. */
void surface_plan(struct surface *surface, const struct palette *palette, uint16_t budget);

/* A colour of the scene in Q15 steps; `out` has 3 entries, of a grey palette the others 0. */
void surface_colour(const struct palette *palette, const uint16_t rgb_q15[3], uint32_t *out);

/* Adds diffuse light: n_dot_l in Q30, clamped below at 0. At most 1.0887 * 2^15 * 255 * 2^8 < 2^31.2: unsigned. */
static inline uint32_t surface_diffuse(uint32_t n_dot_l_q15, uint16_t step_q8)
{
    return (n_dot_l_q15 * step_q8) >> 8;
}

/* (N.H)^n in Q15 of N.H in Q30. */
static inline uint32_t surface_power(const struct surface *surface, q30_t n_dot_h)
{
    if (!surface_form(surface))
        return fx_power(surface->power, n_dot_h);
    surface->form->run(surface->power->exponent, &n_dot_h, 1);
    return fx_u32(n_dot_h);
}

/* The finished colour at N.L, N.H in Q14 of each light (a vertex record's), clamped to [0, top], Q15 steps. */
void surface_shade(const struct surface *surface, const int16_t *lights_q14, uint32_t *out);

#endif

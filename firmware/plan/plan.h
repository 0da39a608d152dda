/* SPDX-License-Identifier: MIT */
/*
 * What a triangle needs for every pixel to stay within the budget: the rung of the ladder that glint_auto draws it by,
 * and of each light which dot products are left out, linear or quadratic. README.md beside this file derives the
 * bounds.
 *
 * Errors are in 1/255 of full intensity, Q8, of the channel that errs most; dot products in Q14.
 */
#ifndef GLINT_PLAN_H
#define GLINT_PLAN_H

#include "geometry/object.h"

#define PLAN_BUDGET                (2u << 8)       /* where the configuration says 0 */
#define PLAN_TEXTURE_SHARE(budget) ((budget) >> 2) /* of a budget: what texture coordinates may take of it */

/* The ladder, cheapest first. */
enum plan_rung {
    PLAN_DARK,     /* the ambient part alone: no light reaches it (exact) */
    PLAN_CONSTANT, /* one colour, in the middle of what is possible */
    PLAN_GOURAUD,  /* finished colours, linear */
    PLAN_LINEAR,   /* N.L and N.H linear; clamp and power per pixel */
    PLAN_SIX,      /* some of them quadratic, through exact mid-edges */
    PLAN_DUFF,     /* per-pixel Phong of far lights, by a quadratic denominator */
    PLAN_PHONG,    /* per-pixel Phong */
    PLAN_RUNGS
};

/* What is decided of a triangle; made by plan_triangle(), used by its set-up. Lights are a bit each. */
struct shade_plan {
    union {
        uint32_t none[2]; /* of what follows, for making it 0 at once */
        struct {
            uint8_t diffuse, specular;           /* lights whose N.L, N.H are computed */
            uint8_t diffuse_bent, specular_bent; /* of them those that are quadratic (six); the rest linear */
            uint8_t hidden_lights;               /* left out as they reach no pixel (exact) */
            uint8_t hidden_highlights;           /* below the power table's foot (exact) */
            uint8_t dropped_highlights;          /* left out within the budget */
            uint8_t undivided;                   /* a perspective view, drawn without perspective correction */
        };
    };
    uint8_t rung;                         /* enum plan_rung */
    uint16_t error;                       /* what a pixel can be off by, Q8 of 1/255, roundings apart */
    uint16_t level[2 * SCENE_MAX_LIGHTS]; /* PLAN_CONSTANT: N.L and (N.H)^n of each light, Q15 */
};

/* What a plan must know of a material under the scene's lights. */
struct plan_surface {
    const struct fx_power *power;
    uint16_t budget; /* Q8 of 1/255 */
    uint8_t lights;
    uint8_t highlights; /* some light has one */
    uint16_t spare;     /* what is left of the allowance for roundings, Q8 of 1/255 */
    uint16_t lengths;   /* what Duff's table of reciprocal lengths is off by, likewise */
    uint8_t sharp;      /* roundings of N.H in vertex records alone pass the budget: Duff does not do either */
    uint16_t duff_sum;  /* the largest S (a) for which Duff is taken rather than phong */
    uint8_t apart; /* textured: what is finished before the texel is known must not be clamped, nor have a highlight */
    uint16_t full; /* what all lights together may add before a channel is clamped, Q8 of 1/255 */
    int16_t foot;  /* N.H below which the power is 0, Q14 */
    struct {
        uint16_t diffuse, specular; /* the worst channel's part at N.L = 1, (N.H)^n = 1: Q8 of 1/255, at most 255 */
    } light[SCENE_MAX_LIGHTS];
};

/* What it must know of a triangle. */
struct plan_triangle {
    const int16_t *lights[3]; /* of each corner: N.L and N.H of each light, Q14 */
    const uint16_t *bend;     /* of the three edges, Q16: struct scene_triangle */
    uint32_t shift;           /* plan_shift(); 0: no perspective */
    int keep;                 /* compute what cannot show (GLINT_NO_PLAN) */
};

/* (p) How far perspective moves barycentric coordinates over a triangle of these vertex records, Q16, at most 1. */
uint32_t plan_shift(const int16_t *const place[3]);

/* Plans a triangle under far lights within the surface's budget. */
void plan_triangle(struct shade_plan *plan, const struct plan_surface *surface, const struct plan_triangle *triangle);

/* The same in perspective and for any number of lights but one: what plan_triangle() calls where it has no short cut.
 */
void plan_several(struct shade_plan *plan, const struct plan_surface *surface, const struct plan_triangle *triangle);

/* Makes a plan compute what is hidden all the same, of the first light: which loop draws depends on whether others
 * show.
 */
void plan_keep(struct shade_plan *plan);

#endif

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

#define PLAN_BUDGET (2u << 8) /* where the configuration says 0 */

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
    uint8_t rung;                         /* enum plan_rung */
    uint8_t diffuse, specular;            /* lights whose N.L, N.H are computed */
    uint8_t diffuse_bent, specular_bent;  /* of them those that are quadratic (six); the rest linear */
    uint8_t hidden_lights;                /* left out as they reach no pixel (exact) */
    uint8_t hidden_highlights;            /* below the power table's foot (exact) */
    uint8_t dropped_highlights;           /* left out within the budget */
    uint8_t undivided;                    /* a perspective view, drawn without perspective correction */
    uint8_t texture;                      /* how its coordinates are interpolated */
    uint8_t fog;                          /* how its factor is */
    uint16_t error;                       /* what a pixel can be off by, Q8 of 1/255, roundings apart */
    uint16_t level[2 * SCENE_MAX_LIGHTS]; /* PLAN_CONSTANT: N.L and (N.H)^n of each light, Q15 */
};

/* What a plan must know of a material under the scene's lights. */
struct plan_surface {
    const struct fx_power *power;
    uint16_t budget; /* Q8 of 1/255 */
    uint8_t lights;
    uint8_t highlights; /* some light has one */
    int16_t foot;       /* N.H at or below which the power is 0, Q14 */
    uint16_t full;      /* what all lights together may add before a channel is clamped, Q8 of 1/255 */
    struct {
        uint16_t diffuse, specular; /* the worst channel's part at N.L = 1, (N.H)^n = 1: Q8 of 1/255, at most 255 */
    } light[SCENE_MAX_LIGHTS];
};

/* What it must know of a triangle. */
struct plan_triangle {
    int16_t *const *lights;      /* of each corner: N.L and N.H of each light, Q14 */
    const uint16_t *bend;        /* of the three edges, Q16: struct scene_triangle */
    const int16_t *const *place; /* vertex records of the corners that are drawn: a piece's own depths */
    uint8_t divides;             /* in a perspective view */
    uint8_t local;               /* under a near light or eye */
    uint8_t keep;                /* compute what cannot show (GLINT_NO_PLAN) */
};

/* Plans a triangle within the surface's budget. */
void plan_triangle(struct shade_plan *plan, const struct plan_surface *surface, const struct plan_triangle *triangle);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * N.L and N.H as quadratics over a triangle through six samples: the corners' dot products and those at the middles of
 * the edges, where light and half-way vectors are unit ones of that place and the normal is (Ni + Nj) / 2 times a
 * length factor:
 *   X-shading (eq. 16)     1 + (1 - Ni.Nj) / 4 = 1 - k / 2
 *   exact (six samples)    1 / sqrt(1 + k), of the true unit normal
 *   none (Duff)            1
 * With D = (Ni + Nj).V at the middle and S = Ii + Ij, the bulge is 2 S - 2 m D; far lights have D = S.
 */
#ifndef GLINT_DOTS_H
#define GLINT_DOTS_H

#include "shade/perspective.h"
#include "shade/steps.h"

/* A triangle's length factors of the edges 0-1, 1-2, 2-0, and what a channel's value is at most multiplied by later on;
 * Q16, 2^16..2^20. */
struct dots_factors {
    uint32_t edge[3];
    uint32_t stretch;
    int are_dots; /* the channels hold the dot products themselves */
    int folds;    /* N.L may count in steps of the output (shade/steps.h) */
};

/* Samples of one light: N.L and N.H at the corners, and (Ni + Nj).V at the middles of the edges; Q14. */
struct dots_samples {
    int32_t corner[2][3], middle[2][3];
};

/* -k of the edge from input corner k to the next, Q16. */
static inline uint32_t dots_bend(const struct shade_input *in, int k)
{
    return in->triangle->bend[2 - k];
}

/* 1 / sqrt(1 - bend) of a bend in Q16; of 2^16 (1 - 2^-8) at most, which is 173 degrees between the normals. */
uint32_t dots_length_factor(uint32_t bend);

/* Samples of a light on the source triangle. */
void dots_sample(const struct shade_input *in, unsigned light, struct dots_samples *samples);

/* Bulges in Q28 of samples. */
void dots_bulges(const int32_t corner[3], const int32_t middle[3], const struct dots_factors *factors, int32_t out[3]);

/* How far a value leaves the linear one, Q14: a third of the largest bulge, rounded up; 2 for the roundings of bulges
 * and corner values. */
static inline int32_t dots_bulge_bend(const int32_t bulge[3])
{
    int32_t most = 0;
    for (int k = 0; k < 3; k++) {
        int32_t size = bulge[k] < 0 ? -bulge[k] : bulge[k];
        most = size > most ? size : most;
    }
    return fx_s32(((fx_u32(most) >> 14) * 11) >> 5) + 2;
}

/* A quadratic channel of values in Q14 and bulges in Q28, by the cheapest way that holds them. */
void dots_quadratic(struct shade_setup *setup, const int32_t value[3], const int32_t bulge[3], struct channel *channel);

/* How much the highlight can change, in Q8 steps, when N.H of at most `top` is off by `bend`: the power is convex. */
static inline uint32_t dots_highlight_slack(const struct surface *s, unsigned light, int32_t top, int32_t bend)
{
    top = top > 16384 ? 16384 : top; /* beyond, the power is clamped */
    int32_t lower = top > bend ? top - bend : 0;
    uint32_t change = fx_power(s->power, fx_s32(top << 16)) - fx_power(s->power, fx_s32(lower << 16));
    return surface_diffuse(change, s->light[light].specular_most) >> 7;
}

/* N.H, or it over the length of a normal of .8 at least, has its place in the power's table beyond [-2, 2), for loops
 * whose clamps are by sign (raster/spans.h); 256 for the roundings. */
static inline int dots_wide(const struct fx_power *power, struct bounds range, int32_t bend)
{
    const int32_t floor = bounds_power_floor(power), most = (32768 - 256) >> power->octave;
    const int32_t low = range.low - bend;
    return floor - low - (low < 0 ? low >> 2 : 0) > most || range.high + bend - floor > most;
}

/* N.H less the foot of the power may pass -2 in Q30. */
static inline int dots_deep(const struct fx_power *power, struct bounds range, int32_t bend)
{
    return range.low - bend - bounds_power_floor(power) < -32768 + 256;
}

/* Whether one dot product of a light, within `range` at the corners and at most `bend` off linear, can show on the
 * triangle (`form`: by another power than the table); if so, *error is what leaving out the bend would change, in Q8
 * steps. Twice a triangle and light, with `highlight` constant. */
static inline __attribute__((always_inline)) int dots_show(struct shade_setup *setup, const struct shade_input *in,
                                                           unsigned light, unsigned highlight, struct bounds range,
                                                           int32_t bend, int form, uint32_t *error)
{
    const struct surface *s = in->surface;
    int32_t top = range.high + bend, floor = highlight && !form ? bounds_power_floor(s->power) : 1;
    *error = 0;                                 /* steps in Q8 at full intensity times a Q14 bend: below 2^16 * 2^16 */
    if (top < floor && (!in->no_plan || light)) /* of the others it matters that they do not show */
        return 0;
    const int deep = highlight && (form ? range.low - bend < -32768 + 257 : dots_deep(s->power, range, bend));
    if (top < floor && deep)
        return 0;
    if (highlight && USES(USES_FORMATS & ~USES_GREY4))
        setup->wide |= fx_u8(dots_wide(s->power, range, bend));
    if (top < floor)
        return 1;
    if (highlight) {
        *error = dots_highlight_slack(s, light, top, bend);
        setup->runs_only |= fx_u8(deep);
    } else {
        *error = (s->light[light].diffuse_most * fx_u32(bend)) >> 14;
    }
    return 1;
}

/* The change, in Q8 steps, below which the bend of a light is left out that is the first, no other showing, or not. */
static inline uint32_t dots_limit(const struct surface *s, int alone)
{
    return alone ? 128 : s->bend_limit;
}

/* Fills channels 2 l and 2 l + 1 of each light that can show, linear where the bend cannot; perspective-correct if
 * `perspective` is not null. */
void dots_setup(struct shade_setup *setup, const struct shade_input *in, const struct dots_factors *factors,
                const struct perspective *perspective);

/* Of duff.c, once the plane is set up for quadratics: whether a triangle that one light reaches can be drawn straight
 * into the band (raster/spans.h), where the squared length as its difference from 1 fits plane_quadratic() and a table
 * of reciprocal lengths holds what is below 1/4; and SHADE_SQUARE's channel, of 1 - |N|^2 with setup->length, else
 * |N|^2. */
uint32_t duff_sum(const struct shade_input *in); /* 1 - |N|^2 is at most 4 times that, Q16 */
int duff_direct(const struct shade_setup *setup, const struct shade_input *in);
void duff_square(struct shade_setup *setup, const struct shade_input *in);

/* Of the same: |N|^2 at the input's corners, Q14, and its bulges, Q28. */
void duff_lengths(const struct shade_input *in, int32_t value[3], int32_t bulge[3]);

#endif

/* SPDX-License-Identifier: MIT */
/* What the samples of shade/dots.c give: shown by dots.c, assumed by dots_setup.c and x.c. */
#ifndef SAMPLES_H
#define SAMPLES_H

#include "shade/dots.h"

/*@ predicate row(int32_t *v, integer most) = \initialized(v + (0 .. 2)) && -most <= v[0] <= most &&
        -most <= v[1] <= most && -most <= v[2] <= most; */

/*@ assigns \result \from bend;
    ensures most: \result <= 0x100000; */
uint32_t dots_length_factor(uint32_t bend);

/*@ requires \valid_read(in) && light < SCENE_MAX_LIGHTS;
    assigns *samples \from indirect: *in, indirect: light;
    ensures corners: row((int32_t *)samples->corner[0], 16400) && row((int32_t *)samples->corner[1], 16400); */
void dots_sample(const struct shade_input *in, unsigned light, struct dots_samples *samples);

/*@ requires \valid_read(corner + (0 .. 2)) && \valid_read(middle + (0 .. 2)) && \valid_read(factors);
    assigns out[0 .. 2] \from corner[0 .. 2], middle[0 .. 2], *factors;
    ensures bulges: row(out, 0x7fffffff); */
void dots_bulges(const int32_t corner[3], const int32_t middle[3], const struct dots_factors *factors, int32_t out[3]);

/*@ requires \valid(setup) && \valid_read(value + (0 .. 2)) && \valid_read(bulge + (0 .. 2)) && \valid(channel);
    assigns *channel \from indirect: setup->plane, value[0 .. 2], bulge[0 .. 2]; */
void dots_quadratic(struct shade_setup *setup, const int32_t value[3], const int32_t bulge[3], struct channel *channel);

#endif

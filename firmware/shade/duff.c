/* SPDX-License-Identifier: MIT */
/*
 * Phong by N.V / |N| of the linear normal (Duff 1979; bump mapping eq. 36-42): the numerator is linear under a far
 * light and a six-sample quadratic under a near one, the denominator's square is the quadratic |N|^2 = 1 + 4 sum kij li
 * lj, which is X-shading's form with intensities of 1 and bulges of -4 kij.
 */
#include "plan/curve.h"
#include "shade/dots.h"
#include "shade/piece.h"

uint32_t duff_sum(const struct shade_input *in)
{
    const uint32_t a = dots_bend(in, 0), b = dots_bend(in, 1), c = dots_bend(in, 2);
    const uint32_t most = a > b ? a : b;
    return curve_sum(c > most ? c : most, a, b, c);
}

int duff_direct(const struct shade_setup *setup, const struct shade_input *in)
{
    return surface_fold(in->surface) && !object_local(in->object) && duff_sum(in) <= SHADE_LENGTH_SUM &&
           !setup->plane.slim;
}

void duff_lengths(const struct shade_input *in, int32_t value[3], int32_t bulge[3])
{
    for (int k = 0; k < 3; k++) {
        value[k] = Q14(1, 1);
        bulge[k] = fx_s32(fx_u32(dots_bend(in, k)) << 14); /* 4 bend in Q28: below 2^30 */
    }
    if (shade_weight(in))
        piece_quadratic(shade_weight(in), value, bulge);
}

void duff_square(struct shade_setup *setup, const struct shade_input *in)
{
    int32_t value[3], bulge[3];
    duff_lengths(in, value, bulge);
    if (!setup->length) {
        plane_quadratic_large(&setup->plane, value, bulge, &setup->channel[SHADE_SQUARE]);
        return;
    }
    for (int k = 0; k < 3; k++) {
        bulge[k] = -bulge[k];
        value[k] = Q14(1, 1) - value[k];
    }
    plane_quadratic(&setup->plane, value, bulge, &setup->channel[SHADE_SQUARE]);
}

void shade_duff(struct shade_setup *setup, const struct shade_input *in)
{
    struct dots_factors factors;
    uint32_t most = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t bend = dots_bend(in, k);
        factors.edge[k] = 1u << 16;
        most = bend > most ? bend : most;
    }
    plane_setup_quadratic(&setup->plane);
    /* sum li lj <= 1/3: the normal's squared length is at least 1 - 4/3 of the largest bend */
    most += (most + 2) * 43691u >> 17; /* a third, rounded up */
    factors.stretch = dots_length_factor(most < 65536 ? most : 65536);
    factors.are_dots = 0;
    factors.folds = duff_direct(setup, in);
    dots_setup(setup, in, &factors, 0);
    setup->length = factors.folds && shade_alone(setup);
    duff_square(setup, in);
}

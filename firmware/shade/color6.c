/* SPDX-License-Identifier: MIT */
/*
 * The finished colour, clamp and power included, at the corners and at the middles of the edges, and the quadratic
 * through the six (hardware paper, section 2): one interpolation for any number of lights. It rings: samples in 0..1
 * give values in -1/3..4/3, for which the channels have room, and a pixel clamps.
 */
#include "shade/colour.h"
#include "shade/dots.h"
#include "shade/piece.h"

/* The finished colours at the middles of the edges, Q8 steps. */
static void middle_colours(const struct shade_input *in, uint16_t out[3][3])
{
    const struct surface *s = in->surface;
    int16_t dots[3][2 * SCENE_MAX_LIGHTS];
    for (unsigned l = 0; l < surface_lights(s); l++) {
        struct dots_samples samples;
        dots_sample(in, l, &samples);
        for (int k = 0; k < 3; k++) {
            const uint32_t factor = dots_length_factor(dots_bend(in, k));
            for (unsigned which = 0; which < 2; which++) {
                int64_t dot = (fx_s64(samples.middle[which][k]) * factor) >> 17; /* half of the sum's, Q14 */
                dots[k][2 * l + which] = fx_s16(dot > 16383 ? 16383 : dot < -16384 ? -16384 : dot);
            }
        }
    }
    for (int k = 0; k < 3; k++)
        colour_finished(s, dots[k], out[k]);
}

void shade_color6(struct shade_setup *setup, const struct shade_input *in)
{
    const uint16_t *const corner[3] = {colour_corner(in, 0), colour_corner(in, 1), colour_corner(in, 2)};
    const int up = 16 - fx_s32(colour_bits(in->surface)); /* to 14 bits: Q6, Q8 or Q10 of a step */
    uint16_t middle[3][3];
    middle_colours(in, middle);
    plane_setup_quadratic(&setup->plane);
    for (unsigned c = 0; c < surface_channels(in->surface); c++) {
        int32_t value[3], bulge[3];
        for (int k = 0; k < 3; k++) /* at most 2^16 in Q8 steps */
            value[k] = fx_s32(corner[k][c]) * (1 << up) >> 2;
        for (int k = 0; k < 3; k++) { /* 2 (Ii + Ij - 2 Iij), half of it at most 2^17: 2^30 in Q28 */
            int32_t twice = corner[k][c] + corner[k == 2 ? 0 : k + 1][c] - 2 * middle[k][c];
            bulge[k] = twice * (1 << up) * (1 << 13);
        }
        if (in->weight)
            piece_quadratic(in->weight, value, bulge);
        dots_quadratic(setup, value, bulge, &setup->channel[c]);
    }
}

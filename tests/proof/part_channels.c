/* SPDX-License-Identifier: MIT */
/*
 * shade/part.c: frames and channels of any part of any triangle in any picture, whatever its colours.
 *
 *   proves: frame_setup narrow part_linear part_channel part_quadratic
 *   assumes: part_place shape_of height_of nearest fx_recip_norm fx_divide_s64 plane_linear plane_quadratic
 *   lemmas: part_channels part_corners
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 400 -eva-split-return full
 */
#include "proof.h"

#include "contracts.h"
#include "part_planes.h"

/*@ requires divisor: d != 0;
    assigns \result \from n, d; */
int64_t fx_divide_s64(int64_t n, int64_t d);

#include "firmware/shade/plane.c"
#include "parts.h"

volatile int sink;

void prove(void)
{
    static struct shade_setup setup;
    static struct surface surface;
    static struct part_corner part[3], middle[3];
    int16_t place[3][3];
    const struct shade_input in = {.place = {place[0], place[1], place[2]}, .surface = &surface};
    const struct part_corner *const corner[3] = {&part[0], &part[1], &part[2]};
    int32_t value[3], bulge[3];
    struct channel channel;
    any_bytes(&setup, sizeof setup);
    any_bytes(middle, sizeof middle);
    setup.plane.ox = any_s32(0, 2047);
    setup.plane.oy = any_s32(0, 2047);
    setup.plane.fx = any_s32(-32768, 32768);
    setup.plane.fy = any_s32(-32768, 32768);
    surface.channels = any_flag() ? 1 : 3;
    for (int k = 0; k < 3; k++) {
        value[k] = any_s32(-(1 << 14) - (1 << 11), (1 << 14) + (1 << 11));
        bulge[k] = k == 1 ? any_s32(-(1 << 29), 1 << 29) : any_s32(-(1 << 28), 1 << 28);
        for (int i = 0; i < 3; i++) {
            place[k][i] = any_s32(-16384, 16384);
            part[k].colour[i] = any_u32(0, 65535);
        }
        for (int i = 0; i < 2; i++)
            part[k].weight[i] = any_u32(0, PART_ONE);
    }
    sink = part_linear(&setup, &in, corner, 0);
    sink = part_linear(&setup, &in, corner, 1);
    sink = part_channel(&setup, &in, corner, value, bulge, any_s32(-8, 31), &channel);
    sink = part_quadratic(&setup, &in, corner, middle);
}

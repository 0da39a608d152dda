/* SPDX-License-Identifier: MIT */
/*
 * shade/plane.c: set-up of any triangle inside the guard band, and channels over any plane that set-up may leave.
 *
 *   proves: scaled_up plane_setup_quadratic shifted slope_wide slope_near slope_of gradient
 *           plane_linear form curve_of curve_shift second_difference plane_quadratic plane_values
 *   assumes: fx_recip_norm plane_keep_corners plane_quadratic_large
 *   options: -eva-precision 2 -eva-slevel 100 -eva-split-return full
 */
#include "proof.h"

#include "contracts.h"
#include "planes.h"

#include "firmware/shade/plane.c"

/* In place of the exact way (exact.c): any values. */
void plane_exact_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out)
{
    for (int i = 0; i < n; i++)
        out[i] = ANY_S32;
}

static void linear(const struct plane *plane, int32_t least)
{
    struct channel channel;
    const int32_t value[3] = {any_s32(least, least + 65535), any_s32(least, least + 65535),
                              any_s32(least, least + 65535)};
    plane_linear(plane, value, &channel);
}

static void quadratic(const struct plane *plane)
{
    const int32_t most = (1 << 14) + (1 << 11), bend = 1 << 28;
    struct channel channel;
    const int32_t value[3] = {any_s32(-most, most), any_s32(-most, most), any_s32(-most, most)};
    const int32_t bulge[3] = {any_s32(-bend, bend), any_s32(-bend, bend), any_s32(-bend, bend)};
    plane_quadratic(plane, value, bulge, &channel);
}

static void values(const struct plane *plane)
{
    struct channel channel = {.p = {ANY_U32, ANY_U32, ANY_U32, ANY_U32, ANY_U32, ANY_U32}};
    int32_t out[16];
    channel.exact = any_s32(0, 2);
    plane_values(plane, &channel, any_s32(0, 2047), any_s32(0, 2047), any_s32(0, 16), out);
}

void prove(void)
{
    //@ loop unroll 16;
    for (int scale = -2; scale <= 13; scale++)
        //@ loop unroll 31;
        for (int up = 1; up <= 31; up++) {
            struct plane plane;
            if (!any_plane(&plane, scale, up))
                continue;
            plane_setup_quadratic(&plane);
            linear(&plane, -32768); /* dot products, colours */
            linear(&plane, 0);      /* depths */
            quadratic(&plane);
            values(&plane);
        }
}

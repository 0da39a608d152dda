/* SPDX-License-Identifier: MIT */
/*
 * shade/plane_wide.c: channels in 64 bits over any plane, of any 32-bit values and bulges.
 *
 *   proves: plane_keep_corners product narrowed find_gradient finish plane_linear_wide plane_quadratic_wide
 *           plane_quadratic_large
 *   options: -eva-precision 2 -eva-slevel 100
 */
#include "proof.h"

#include "contracts.h"
#include "planes.h"

#include "firmware/shade/plane_wide.c"

static void channels(struct plane *plane)
{
    struct channel channel;
    const int32_t most = (1 << 14) + (1 << 11);
    const int32_t value[3] = {ANY_S32, ANY_S32, ANY_S32};
    const int32_t small[3] = {any_s32(-most, most), any_s32(-most, most), any_s32(-most, most)};
    const int32_t bulge[3] = {ANY_S32, ANY_S32, ANY_S32};
    plane->slim = any_flag();
    plane_linear_wide(plane, value, &channel);
    plane_quadratic_wide(plane, value, bulge, &channel);
    plane_quadratic_large(plane, small, bulge, &channel);
    plane_keep_corners(&channel, value, 0);
}

void prove(void)
{
    //@ loop unroll 16;
    for (int scale = -2; scale <= 13; scale++)
        //@ loop unroll 31;
        for (int up = 1; up <= 31; up++) {
            struct plane plane;
            if (any_plane(&plane, scale, up))
                channels(&plane);
        }
}

/* SPDX-License-Identifier: MIT */
/*
 * shade/plane_wide.c: the barycentric way, over any plane that set-up may leave, at any pixels of any picture, of any
 * corner values and bulges. That weights sum to 1 is the lemma's.
 *
 *   proves: exact_value plane_exact_values
 *   lemmas: exact
 *   options: -eva-precision 0 -eva-min-loop-unroll 17
 */
#include "proof.h"

#include "contracts.h"
#include "planes.h"

#include "firmware/shade/plane_wide.c"

static void any_corners(struct channel *channel, int32_t most)
{
    //@ loop unroll 3;
    for (int i = 0; i < 3; i++) {
        channel->corner.value[i] = any_s32(-most - 1, most);
        channel->corner.bulge[i] = ANY_S32;
    }
}

static void values(const struct plane *plane)
{
    struct channel channel;
    int32_t out[16];
    //@ loop unroll 17;
    for (int n = 0; n <= 16; n++) {
        channel.exact = PLANE_EXACT_WIDE;
        any_corners(&channel, INT32_MAX);
        plane_exact_values(plane, &channel, any_s32(0, 2048 - n), any_s32(0, 2047), n, out);
        channel.exact = PLANE_EXACT;
        any_corners(&channel, 65535);
        plane_exact_values(plane, &channel, any_s32(0, 2048 - n), any_s32(0, 2047), n, out);
    }
}

void prove(void)
{
    struct plane plane, one;
    if (!any_plane(&plane, -2, 1))
        return;
    //@ loop unroll 16;
    for (int scale = -2; scale <= 13; scale++)
        //@ loop unroll 31;
        for (int up = 1; up <= 31; up++)
            if (any_plane(&one, scale, up) && any_flag())
                plane = one;
    values(&plane); /* any of them: exact_value() asks for no more */
}

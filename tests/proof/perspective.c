/* SPDX-License-Identifier: MIT */
/*
 * shade/perspective.c: any depths of corners, any values and bulges, in any program.
 *
 *   proves: perspective_setup perspective_linear saturated perspective_numerator perspective_quadratic
 *   assumes: plane_linear_wide plane_quadratic_wide
 *   options: -eva-precision 0 -eva-min-loop-unroll 3 -eva-slevel 200 -eva-split-return full
 */
#define PROOF_CLZ_BY_CASES
#include "proof.h"

#include "pieces.h"

/* What the program has: a constant of its own. */
static uint32_t uses;
#undef GLINT_USES
#define GLINT_USES uses

#include "firmware/shade/perspective.c"

void prove(void)
{
    int16_t place[3][3];
    const int32_t value[3] = {any_s32(-32768, 32767), any_s32(-32768, 32767), any_s32(-32768, 32767)};
    const int32_t most = INT32_MAX;
    const int32_t bulge[3] = {any_s32(-most, most), any_s32(-most, most), any_s32(-most, most)};
    const struct shade_input in = {.place = {place[0], place[1], place[2]}, .divides = any_flag()};
    struct plane plane;
    struct channel channel;
    struct perspective p;
    uses = any_u32(0, USES_ALL);
    any_bytes(place, sizeof place);
    any_bytes(&plane, sizeof plane);
    if (!perspective_setup(&p, &in))
        return;
    perspective_linear(&p, &plane, value, &channel);
    p.quadratic(&p, &plane, value, bulge, &channel);
}

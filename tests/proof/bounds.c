/* SPDX-License-Identifier: MIT */
/*
 * plan/bounds.h and plan/curve.h: any bends, any dot products at the corners.
 *
 *   proves: bounds_of bounds_curl bounds_bend bounds_power_floor curve_sum curve_setup
 *           curve_values curve_bound
 *   options: -eva-precision 3 -eva-slevel 200
 */
#include "proof.h"

#include "firmware/plan/curve.c"
#include "plan/bounds.h"

volatile int32_t sink;

static int32_t any_dot(void)
{
    return any_s32(-16384, 16383);
}

/* Bends with the largest up to 90 degrees, in each band, or one beyond. */
static void bends(uint32_t least, uint32_t most)
{
    const uint16_t bend[3] = {any_u32(least, most), any_u32(0, most), any_u32(0, most)};
    const int32_t value[3] = {any_dot(), any_dot(), any_dot()};
    struct fx_power power = {.octave = any_u32(0, 7)};
    struct curve curve;
    sink = bounds_bend(bounds_of(value), bounds_curl(bend)) + bounds_power_floor(&power);
    curve_setup(&curve, bend);
    struct curve_values v = curve_values(value[0], value[1], value[2]);
    if (v.high > 0)
        curve_bound(&curve, &v);
}

void prove(void)
{
    bends(0, 32768);
    bends(32769, 65535);
}

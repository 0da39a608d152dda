/* SPDX-License-Identifier: MIT */
/*
 * fixed/power.c and fx_power(): every exponent, any argument.
 *
 *   proves: power_mul power_of power_base fx_power_exact fx_power_build fx_power
 *   options: -eva-precision 0
 */
#include "proof.h"

#include "firmware/fixed/power.c"

volatile uint32_t sink;

void prove(void)
{
    struct fx_power table;
    const int32_t one = 1 << 30;
    sink = fx_power_exact(any_u32(1, 1023), any_s32(INT32_MIN, 0));
    sink = fx_power_exact(any_u32(1, 1023), any_s32(1, one - 1));
    sink = fx_power_exact(any_u32(1, 1023), any_s32(one, INT32_MAX));
    fx_power_build(&table, any_u32(1, 1023));
    //@ loop unroll 130;
    for (unsigned i = 0; i < FX_POWER_STEPS + 2; i++)
        table.value[i] = any_u32(0, 32768);
    //@ loop unroll 8;
    for (unsigned octave = 0; octave < 8; octave++) {
        table.octave = octave;
        sink = fx_power(&table, any_s32(INT32_MIN, -1));
        sink = fx_power(&table, any_s32(0, one - (one >> octave)));
        sink = fx_power(&table, any_s32(one - (one >> octave), one - 1));
        sink = fx_power(&table, any_s32(one, INT32_MAX));
    }
}

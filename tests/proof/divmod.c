/* SPDX-License-Identifier: MIT */
/*
 * fx_divmod_floor(), both ways: every numerator and divisor that fixed.h allows. What relates them is shown by the
 * lemmas.
 *
 *   proves: fx_divmod_floor fx_divmod_floor_narrow
 *   lemmas: divmod divmod_narrow
 *   options: -eva-precision 0
 */
#include "proof.h"

#include "edges.h"

void prove(void)
{
    int32_t quotient, remainder;
    fx_divmod_floor(any_s32(-FX_DIVMOD_MOST, FX_DIVMOD_MOST), any_s32(1, 1 << 30), &quotient, &remainder);
    fx_divmod_floor_narrow(any_s32(0, FX_DIVMOD_MOST), any_s32(1, 1 << 30), &quotient, &remainder);
    fx_divmod_floor_narrow(any_s32(-FX_DIVMOD_MOST, -1), any_s32(1, 1 << 30), &quotient, &remainder);
}

/* SPDX-License-Identifier: MIT */
/*
 * Forms of the highlight's power besides the interpolated table (fx_power()), which is the default and needs none of
 * this. A form works on a run, so that no pixel asks which it is.
 *
 * The power-free ones, max(0, 1 - (n / g)(1 - s))^g with g = 4, 8 or 16, need neither table nor power: an affine map,
 * folded into N.H's corner values and bulges at set-up where those are the dot products themselves, and two, three or
 * four squarings a pixel.
 */
#ifndef GLINT_POWER_H
#define GLINT_POWER_H

#include "shade/plane.h"

struct glint_power {
    /* N.H in Q30 to its power in Q15, 0..32768, in place, 0 where N.H is not above 0; n is the exponent. */
    void (*run)(unsigned n, int32_t *value, int count);
    /* N.H's corner values in Q14 and bulges in Q28 to those of 1 - (n / g)(1 - s), in Q(30 - down) and Q(28 - down);
     * returns down. Null: nothing to fold. */
    unsigned (*fold)(unsigned n, const int32_t value[3], const int32_t bulge[3], int32_t value_out[3],
                     int32_t bulge_out[3]);
    /* The rest of the power, from that in Q(30 - down). As above, 0 where N.H is not above 0. */
    void (*run_folded)(unsigned n, unsigned down, int32_t *value, int count);
    /* What puts a folded linear channel on the plane: plane_linear_wide(), linked with the form alone. */
    void (*linear)(const struct plane *plane, const int32_t value[3], struct channel *channel);
};

#endif

/* SPDX-License-Identifier: MIT */
/*
 * shade/plane.c: set-up of any three corners within the guard band, in a picture of any size; what is set is what
 * planes.h says, from which the proofs of all that goes over planes start. Each pair of answers that counting leading
 * zeros may give, the determinant's and the corners', is a case of its own.
 *
 *   proves: plane_setup inside scaled_up
 *   assumes: fx_recip_norm
 *   lemmas: plane_setup
 *   options: -eva-precision 0 -eva-slevel-function plane_setup:4 -eva-domains equality
 */
#include "proof.h"

static int32_t answer[2], asked; /* of the case in hand */

/*@ assigns \nothing;
    ensures \false; */
void another_case(void);

static int clz(uint32_t x)
{
    const int n = answer[asked++];
    //@ assert x != 0;
    if (x < 1u << (31 - n) || x > UINT32_MAX >> n)
        another_case();
    return n;
}
#define __builtin_clz clz

#include "contracts.h"
#include "planes.h"

#include "firmware/shade/plane.c"

/* A corner that was cut may be rounded out of the guard band. */
#define REACH (GUARD + 1)

void plane_exact_values(const struct plane *plane, const struct channel *channel, int x, int y, int n, int32_t *out) {}

void prove(void)
{
    struct plane plane;
    int16_t place[3][2];
    const int16_t *const p[3] = {place[0], place[1], place[2]};
    //@ loop unroll 3;
    for (int i = 0; i < 3; i++) {
        place[i][0] = any_s32(-REACH, REACH);
        place[i][1] = any_s32(-REACH, REACH);
    }
    //@ loop unroll 32;
    for (answer[0] = 0; answer[0] < 32; answer[0]++)
        //@ loop unroll 32;
        for (answer[1] = 0; answer[1] < 32; answer[1]++) {
            asked = 0;
            plane_setup(&plane, p, any_u32(1, 2048), any_u32(1, 2048));
        }
}

/* SPDX-License-Identifier: MIT */
/* The formulas in double precision, and their triangles. */
#ifndef REAL_H
#define REAL_H

#include <math.h>

typedef double real;
#define real_root sqrt
#include "tests/setups/setup.h"
#include "tests/setups/steps.h"

static inline struct real_case real_of(const struct setup_case *c)
{
    struct real_case r = {.x1 = (c->place[1][0] - c->place[0][0]) / 16.,
                          .y1 = (c->place[1][1] - c->place[0][1]) / 16.,
                          .x2 = (c->place[2][0] - c->place[0][0]) / 16.,
                          .y2 = (c->place[2][1] - c->place[0][1]) / 16.,
                          .k12 = c->bend[0] / -65536.,
                          .k23 = c->bend[1] / -65536.,
                          .k13 = c->bend[2] / -65536.};
    for (int i = 0; i < 3; i++) {
        r.l[i] = c->light[i] * 0x1p-14;
        for (int k = 0; k < 3; k++)
            r.n[k][i] = c->normal[k][i] * 0x1p-14;
    }
    return r;
}

#endif

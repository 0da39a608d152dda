/* SPDX-License-Identifier: MIT */
/* What geometry/object.c's object_unit() asks and gives: proven by object.c, assumed by what calls it. */
#ifndef OBJECTS_H
#define OBJECTS_H

#include "geometry/object.h"

#define UNIT 16385 /* 1 and a rounding, Q14 */

/*@ requires first: -0x7fffffff <= v[0];
    requires second: -0x7fffffff <= v[1];
    requires third: -0x7fffffff <= v[2];
    requires there: \valid_read(v + (0 .. 2)) && \valid(out + (0 .. 2)) && \separated(v + (0 .. 2), out + (0 .. 2));
    assigns out[0 .. 2] \from v[0 .. 2];
    ensures set: \initialized(out + (0 .. 2));
    ensures first: -UNIT <= out[0] <= UNIT;
    ensures second: -UNIT <= out[1] <= UNIT;
    ensures third: -UNIT <= out[2] <= UNIT; */
void object_unit(const int32_t v[3], q14_t out[3]);

#endif

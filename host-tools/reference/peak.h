/* SPDX-License-Identifier: MIT */
/* Where in a triangle the centre of a highlight is: "Improved Specular Highlights with Adaptive Shading", 3.1.1. */
#ifndef PEAK_H
#define PEAK_H

#include "reference/decode.h"

enum peak_kind {
    PEAK_NONE,   /* H1 holds nowhere between the corners */
    PEAK_INSIDE, /* P, between Q and R, where H1 holds on two edges */
    PEAK_EDGE,   /* it is outside: of Q and R the one where N.H is larger */
};

struct peak {
    enum peak_kind kind;
    double at[3]; /* barycentric */
};

/* Normals and positions linear between the corners. Where light or viewer are near H1 holds along a curve, and P is
 * refined as in the paper's Fig. 12. */
struct peak peak_find(const struct decode_view *view, unsigned light, const struct decode_vertex corner[3]);

#endif

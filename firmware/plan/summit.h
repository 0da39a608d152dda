/* SPDX-License-Identifier: MIT */
/* Where in a potentially highlighted triangle the highlight's centre is (Cho et al. 1996, section 3.1.1). */
#ifndef GLINT_SUMMIT_H
#define GLINT_SUMMIT_H

#include "plan/highlighted.h"

#define SUMMIT_ONE 1024 /* weights are barycentric, Q10: three that sum to this */

enum summit_place {
    SUMMIT_NONE,   /* H1 changes no sign between the corners */
    SUMMIT_INSIDE, /* between Q and R */
    SUMMIT_EDGE,   /* outside; the one of Q and R that is nearer to it, in brightness */
};

/*
 * Q and R are where H1 holds on two edges, P where H2 does between them, each by halving, exact to 1 in SUMMIT_ONE.
 * With a near light or viewer H1 holds along a curve, and P is refined: along the line from the edges' common corner by
 * H1, then between that point and Q or R by H2. Fills weight[] with P, or Q or R; *opposite: for SUMMIT_EDGE, the
 * corner that its edge does not touch.
 */
enum summit_place summit_find(const struct object_state *object, unsigned light,
                              const struct highlighted_point corner[3], uint16_t weight[3], int *opposite);

#endif

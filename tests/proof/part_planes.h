/* SPDX-License-Identifier: MIT */
/* What plane_linear() and plane_quadratic() ask of a part's plane, and give: proven by part_planes.c, assumed by what
 * makes such planes. up - 2 scale are the zeros of the scaled determinant. */
#ifndef PART_PLANES_H
#define PART_PLANES_H

#include "shade/plane.h"

/*@ predicate corners(struct plane *p) = -0x3fff <= p->x1 <= 0x3fff && -0x3fff <= p->y1 <= 0x3fff &&
                                         -0x3fff <= p->x2 <= 0x3fff && -0x3fff <= p->y2 <= 0x3fff;
    predicate whole(struct plane *p) = -0x8000 <= p->whole_x1 <= 0x8000 && -0x8000 <= p->whole_y1 <= 0x8000 &&
                                       -0x8000 <= p->whole_x2 <= 0x8000 && -0x8000 <= p->whole_y2 <= 0x8000;
    predicate odd(struct plane *p) = p->scale != -1 || (p->whole_x1 <= 0x7fff && p->whole_y1 <= 0x7fff &&
                                                        p->whole_x2 <= 0x7fff && p->whole_y2 <= 0x7fff);
    predicate origin(struct plane *p) = -8 <= p->fx <= 8 && -8 <= p->fy <= 8; */

/*@ requires scale: -2 <= plane->scale <= 13;
    requires shift: -13 <= plane->shift <= 17;
    requires place: corners(plane) && whole(plane) && origin(plane);
    requires odd: odd(plane);
    requires half: 0x40000000 <= plane->half;
    requires sliver: plane->sliver == 0;
    requires differences: -65535 <= value[1] - value[0] <= 65535 && -65535 <= value[2] - value[0] <= 65535;
    requires there: \valid(channel);
    assigns channel->exact, channel->p \from *plane, value[0 .. 2];
    ensures set: \initialized(&channel->p);
    ensures polynomial: channel->exact == 0; */
void plane_linear(const struct plane *plane, const int32_t value[3], struct channel *channel);

/*@ predicate value(int32_t v) = -0x4800 <= v <= 0x4800;
    predicate bulge(int32_t b) = -0x10000000 <= b <= 0x10000000; */

/*@ requires scale: -2 <= plane->scale <= 13;
    requires zeros: 3 <= plane->up - 2 * plane->scale <= 9;
    requires shift: plane->shift == plane->up - plane->scale - 14;
    requires place: corners(plane) && whole(plane) && origin(plane);
    requires half: 0x40000000 <= plane->half && 0x80000000 <= plane->r && 0x20000000 <= plane->r2;
    requires sliver: plane->sliver == 0 && plane->thin == 0;
    requires slim: plane->slim == 0;
    requires far: plane->scale >= 0 || plane->far != 0;
    requires values: value(value[0]) && value(value[1]) && value(value[2]);
    requires bulges: bulge(bulge[0]) && bulge(bulge[2]) && -0x20000000 <= bulge[1] <= 0x20000000;
    requires there: \valid(channel);
    assigns channel->exact, channel->p \from *plane, value[0 .. 2], bulge[0 .. 2];
    ensures set: \initialized(&channel->p);
    ensures polynomial: channel->exact == 0; */
void plane_quadratic(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                     struct channel *channel);

#endif

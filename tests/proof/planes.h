/* SPDX-License-Identifier: MIT */
/* Planes as plane_setup() leaves them (shade/plane.h): what plane_setup.c shows of each is all that any_plane() takes.
 */
#ifndef PLANES_H
#define PLANES_H

#include "shade/plane.h"

#include "proof.h"

/* Corners are at most plane_side() apart, and plane_scaled() when moved by the scale, whose low bits may be lost; a
 * determinant, of `up` leading zeros, is at most twice the square of that, and nowhere more than 2^30. */
/*@ logic integer plane_side(integer scale) = scale < -1 ? 32768 : (1 << (14 - scale)) - 1;
    logic integer plane_scaled(integer scale) =
        scale < -1 ? 8192 : scale == -1 ? 16384 : plane_side(scale) * (1 << scale);
    predicate within(integer x, integer most) = -most <= x <= most;
    predicate plane_range(integer scale, integer up) = -2 <= scale <= 13 && 1 <= up <= 31;
    predicate plane_whole(struct plane *p) =
        within(p->whole_x1, plane_side(p->scale)) && within(p->whole_y1, plane_side(p->scale)) &&
        within(p->whole_x2, plane_side(p->scale)) && within(p->whole_y2, plane_side(p->scale));
    predicate plane_moved(struct plane *p) =
        within(p->x1, plane_scaled(p->scale)) && within(p->y1, plane_scaled(p->scale)) &&
        within(p->x2, plane_scaled(p->scale)) && within(p->y2, plane_scaled(p->scale));
    predicate plane_bits(struct plane *p) = (1 << (31 - p->up)) <= p->det < (1 << (32 - p->up));
    predicate plane_det(struct plane *p) = 1 <= p->det <= 0x40000000;
    predicate plane_low(struct plane *p) = p->scale >= 0 ==> p->up >= 2 * p->scale + 3;
    predicate plane_reciprocal(struct plane *p) =
        0x80000000 <= p->r && 0x40000000 <= p->half <= 0x7fffffff && p->shift == p->up - p->scale - 14;
    predicate plane_sliver(struct plane *p) = p->sliver == (p->up - 2 * p->scale > 15 ? 1 : 0);
    predicate plane_origin(struct plane *p) = 0 <= p->ox <= 2047 && 0 <= p->oy <= 2047;
    predicate plane_corner(struct plane *p) = within(p->fx, 0x8000) && within(p->fy, 0x8000);
    predicate plane_set(struct plane *p) =
        plane_whole(p) && plane_moved(p) && plane_bits(p) && plane_det(p) && plane_low(p) && plane_reciprocal(p) &&
   plane_sliver(p) && plane_origin(p) && plane_corner(p); */

/*@ requires corners: \valid_read(p + (0 .. 2)) && \valid_read(p[0] + (0 .. 1)) && \valid_read(p[1] + (0 .. 1)) &&
                      \valid_read(p[2] + (0 .. 1));
    requires guard: \forall integer k; 0 <= k <= 2 ==> within(p[k][0], 16384) && within(p[k][1], 16384);
    requires picture: 1 <= width <= 2048 && 1 <= height <= 2048;
    requires there: \valid(plane);
    assigns *plane \from p[0 .. 2][0 .. 1], width, height;
    assigns \result \from p[0 .. 2][0 .. 1];
    ensures found: \result == 0 || \result == 1;
    ensures range: \result == 1 ==> plane_range(plane->scale, plane->up);
    ensures whole: \result == 1 ==> plane_whole(plane);
    ensures moved: \result == 1 ==> plane_moved(plane);
    ensures bits: \result == 1 ==> plane_bits(plane);
    ensures det: \result == 1 ==> plane_det(plane);
    ensures low: \result == 1 ==> plane_low(plane);
    ensures reciprocal: \result == 1 ==> plane_reciprocal(plane);
    ensures sliver: \result == 1 ==> plane_sliver(plane);
    ensures origin: \result == 1 ==> plane_origin(plane);
    ensures corner: \result == 1 ==> plane_corner(plane); */
int plane_setup(struct plane *plane, const int16_t *const p[3], unsigned width, unsigned height);

/*@ requires \valid(channel) && \valid_read(value + (0 .. 2));
    requires bulge == \null || \valid_read(bulge + (0 .. 2));
    assigns channel->corner \from value[0 .. 2], bulge[0 .. 2]; */
void plane_keep_corners(struct channel *channel, const int32_t value[3], const int32_t bulge[3]);

/*@ requires \valid_read(plane) && \valid_read(value + (0 .. 2)) && \valid_read(bulge + (0 .. 2)) && \valid(channel);
    requires values: -32768 <= value[0] <= 32767 && -32768 <= value[1] <= 32767 && -32768 <= value[2] <= 32767;
    assigns *channel \from *plane, value[0 .. 2], bulge[0 .. 2]; */
void plane_quadratic_large(const struct plane *plane, const int32_t value[3], const int32_t bulge[3],
                           struct channel *channel);

/* Any plane of that scale and `up`, and nothing in it that is not yet set; 0 if there is none. */
static inline int any_plane(struct plane *p, int scale, int up)
{
    if (scale >= 0 && up < 2 * scale + 3)
        return 0;
    p->scale = scale;
    p->up = up;
    p->whole_x1 = ANY_S32;
    p->whole_y1 = ANY_S32;
    p->whole_x2 = ANY_S32;
    p->whole_y2 = ANY_S32;
    p->x1 = ANY_S32;
    p->y1 = ANY_S32;
    p->x2 = ANY_S32;
    p->y2 = ANY_S32;
    p->det = ANY_U32;
    p->r = ANY_U32;
    p->half = ANY_S32;
    p->shift = ANY_S32;
    p->sliver = any_flag();
    p->ox = ANY_S32;
    p->oy = ANY_S32;
    p->fx = ANY_S32;
    p->fy = ANY_S32;
    //@ admit plane_set(p);
    return 1;
}

#endif

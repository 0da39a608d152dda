/* SPDX-License-Identifier: MIT */
/*
 * How much of a pixel is fog, from its depth alone, and where it need not be found for each pixel.
 *
 * The fog's part is F(u): with z the distance along the view (-z of the eye's axes) u = (z - from) / (to - from) and
 * F = u within 0..1 for linear fog, u = density z / ln 2 and F = 1 - 2^-u for exponential fog. Closeness c is the depth
 * less DEPTH_FAR, linear on the screen: in perspective z = near K / c, else z = far - (far - near) c / K, with K the
 * depths from far to near. So u = A / c - B or B - A c with two numbers made once a frame.
 *
 * Over a triangle F is interpolated from its corners where a bound allows (fog_choose()). With zn, zf the nearest and
 * the farthest corner's distance, d = zf - zn and ui the corners' u, in perspective:
 *   - z is convex in c; by Jensen its interpolation is above it by at most the chord's gap between the extremes,
 *     (sqrt(zf) - sqrt(zn))^2 = d^2 / (sqrt(zf) + sqrt(zn))^2 <= d^2 / (3 zn + zf), as 2 sqrt(zn zf) >= 2 zn. The same
 *     holds for u, in which z is scaled and moved. In orthographic views it is exact: bow = 0.
 *   - linear fog: interpolating the clamped ui instead differs from that by at most how far the extremes pass 0 and 1,
 *     so that |error| <= bow + max(0, -un) + max(0, uf - 1).
 *   - exponential: V = 2^-u is convex in u: the mean of V(ui) is above V at the mean of the ui by at most
 *     2^-un (ln 2 (uf - un))^2 / 8, and V at that mean is below the true V, as the mean is above the true u by at most
 *     bow, by at most 2^-un ln 2 bow. The two have opposite signs: the larger is the bound.
 *   - always |error| <= F(uf) - F(un), and half of that for its mean in place of F.
 * Over a run of pixels in a row, within which c changes by no more than some s, the same holds between its ends; in
 * perspective du = A dc / c^2, so that both d and bow are largest where c is least in the triangle (linear fog: least
 * where u < 1). A kink of linear fog inside a run, of slope 0 on one side, costs at most a quarter of what u changes
 * by.
 */
#ifndef GLINT_FOG_H
#define GLINT_FOG_H

#include "geometry/transform.h"

/* Of a picture. */
struct fog {
    uint8_t kind;       /* enum scene_fog_kind; FOG_NONE also where no visible distance has any */
    uint8_t divides;    /* a perspective view */
    int16_t scale_down; /* A = scale * 2^-scale_down, scale in [2^31, 2^32) */
    uint32_t scale;
    int32_t offset;        /* B in Q16, |B| <= 2^30 */
    uint16_t clear, solid; /* depths: from `clear` on there is no fog, up to `solid` nothing else */
    uint16_t error;        /* how far F may be off, Q16: depths are whole numbers, and F's own roundings */
};

/* The fog of a checked scene. One so thin that it is thinner than 2^-13 of `from`, in orthographic views of the far
 * plane's distance, is taken for that thick; one that grows so fast that u passes 2^14 before an orthographic far
 * plane, for one that comes to as much there. */
void fog_begin(struct fog *fog, const struct scene_header *scene);

/* The fog's part in Q16, 0..65536, at a depth times 2^16 (a depth channel's value). */
uint32_t fog_part(const struct fog *fog, uint32_t depth_q16);

enum fogged {
    FOGGED_NOT,
    FOGGED_EVENLY,
    FOGGED_LINEARLY, /* over the triangle */
    FOGGED_BY_RUN,   /* between the ends of a run of pixels */
    FOGGED_BY_PIXEL,
    FOGGED_WHOLLY,
    FOGGED_KINDS
};

/* Of a triangle. */
struct fog_plan {
    uint8_t kind;    /* enum fogged */
    int32_t part[3]; /* the fog's at the corners, Q14, 0..16384; all one where it is even */
    uint32_t error;  /* of the fog's part at most, Q16: times the colour's distance from the fog's, of the pixel */
    uint32_t shown; /* the most of its own colour that shows, Q16: what is off in it is off in the pixel by that part */
};

/* The cheapest way that adds no more than `allowed` (Q16) to fog->error. With `all` nothing is left out that cannot
 * show: what is FOGGED_NOT or FOGGED_WHOLLY becomes FOGGED_EVENLY, and the picture is the same. */
void fog_choose(const struct fog *fog, const int32_t depth[3], uint32_t allowed, int all, struct fog_plan *plan);

/* What interpolating the part between the ends of a run can add to the error, Q16, where depths of the triangle change
 * by at most `step` (times 2^16) from one end to the other. */
uint32_t fog_run_error(const struct fog *fog, const int32_t depth[3], uint32_t step_q16);

#endif

/* SPDX-License-Identifier: MIT */
/* What the functions of shade/part.c ask and give: each is proven by one of part*.c, and assumed by what calls it. What
 * is no interval in them is shown by the lemmas (.smt2). */
#ifndef PARTS_H
#define PARTS_H

#include "firmware/shade/part.c"

/*@ requires weights: corner->weight[0] + corner->weight[1] <= 0x8000;
    requires places: \forall integer k; 0 <= k < 3 ==>
             -0x4000 <= in->place[k][0] <= 0x4000 && -0x4000 <= in->place[k][1] <= 0x4000;
    assigns \result \from *corner, *(in->place[0 .. 2] + (0 .. 1));
    ensures box: -0x20000000 <= \result.x <= 0x20000000 && -0x20000000 <= \result.y <= 0x20000000; */
struct part_place part_place(const struct shade_input *in, const struct part_corner *corner);

/*@ predicate share(integer w) = 0 <= w <= 0x8000;
    predicate shares(struct shade_input *in, integer i) =
              share(in->weight[i][0]) && share(in->weight[i][1]) && share(in->weight[i][2]);
    predicate one(struct shade_input *in, integer i) =
              in->weight[i][0] + in->weight[i][1] + in->weight[i][2] == 0x8000;
    predicate source(struct shade_input *in) = in->weight == \null || (shares(in, 0) && shares(in, 1) && shares(in, 2));
    predicate sums(struct shade_input *in) = in->weight == \null || (one(in, 0) && one(in, 1) && one(in, 2)); */

/*@ requires source: source(in);
    requires sums: sums(in);
    requires weights: corner->weight[0] + corner->weight[1] <= 0x8000;
    assigns weight[0 .. 2] \from corner->weight[0 .. 1], in->weight[0 .. 2][0 .. 2];
    ensures set: \initialized(weight) && \initialized(weight + 1) && \initialized(weight + 2);
    ensures each: weight[0] <= 0x8000 && weight[1] <= 0x8000 && weight[2] <= 0x8000;
    ensures whole: weight[0] + weight[1] + weight[2] == 0x8000; */
void part_weights(const struct shade_input *in, const struct part_corner *corner, uint16_t weight[3]);

/* x 2^up or x 2^-down. */
/*@ requires shifts: 0 <= up <= 13 && 0 <= down <= 17 && (up == 0 || down == 0);
    requires fits: -(0x4000 << down) < x * (1 << up) < (0x4000 << down);
    assigns \result \from x, up, down;
    ensures small: -0x3fff <= \result <= 0x3fff; */
static int32_t scaled(int32_t x, int up, int down);

/*@ predicate small(struct shape *s) = -0x3fff <= s->x1 <= 0x3fff && -0x3fff <= s->y1 <= 0x3fff &&
                                       -0x3fff <= s->x2 <= 0x3fff && -0x3fff <= s->y2 <= 0x3fff;
    predicate large(struct shape *s) = s->x1 >= 0x2000 || s->y1 >= 0x2000 || s->x2 >= 0x2000 || s->y2 >= 0x2000 ||
                                       s->x1 <= -0x2000 || s->y1 <= -0x2000 || s->x2 <= -0x2000 || s->y2 <= -0x2000;
    predicate within(integer d, integer scale) = -(1 << (29 - scale)) < d < (1 << (29 - scale));
    predicate product(struct shape *s) = s->det == s->x1 * s->y2 - s->x2 * s->y1; */

/*@ requires reach: -0x40000000 <= at <= 0x40000000;
    requires apart: \valid(pixel) && \valid(sub) && \valid(rest);
    assigns *pixel, *sub, *rest \from at;
    ensures set: \initialized(pixel) && \initialized(sub) && \initialized(rest);
    ensures pixel: -2048 <= *pixel <= 2048;
    ensures sub: -8 <= *sub <= 8;
    ensures rest: -0x4000 <= *rest <= 0x4000; */
static void nearest(int32_t at, int32_t *pixel, int32_t *sub, int32_t *rest);

/*@ requires box: \forall integer k; 0 <= k < 3 ==>
             -0x20000000 <= p[k].x <= 0x20000000 && -0x20000000 <= p[k].y <= 0x20000000;
    assigns \result \from p[0 .. 2];
    ensures small: -0x3fff <= \result.x1 <= 0x3fff && -0x3fff <= \result.y1 <= 0x3fff &&
                   -0x3fff <= \result.x2 <= 0x3fff && -0x3fff <= \result.y2 <= 0x3fff;
    ensures scale: -2 <= \result.scale <= 28;
    ensures lost: 0 <= \result.lost <= 1;
    ensures product: \result.det == \result.x1 * \result.y2 - \result.x2 * \result.y1;
    ensures bound: -0x20000000 < \result.det < 0x20000000;
    ensures widest: \result.scale > -2 || \result.det <= 0x8000000;
    ensures large: \result.det <= 0 || \result.x1 >= 0x2000 || \result.y1 >= 0x2000 || \result.x2 >= 0x2000 ||
                   \result.y2 >= 0x2000 || \result.x1 <= -0x2000 || \result.y1 <= -0x2000 ||
                   \result.x2 <= -0x2000 || \result.y2 <= -0x2000;
    ensures within: within(p[1].x - p[0].x, \result.scale) && within(p[1].y - p[0].y, \result.scale) &&
                    within(p[2].x - p[0].x, \result.scale) && within(p[2].y - p[0].y, \result.scale); */
static struct shape shape_of(const struct part_place p[3]);

/*@ requires small: small(s);
    requires scale: -2 <= s->scale <= 28;
    requires large: s->det <= 0 || large(s);
    requires product: product(s);
    assigns \result \from *s;
    ensures range: 0 <= \result <= 0x3ffff;
    ensures least: \result == 0 || 4 * s->det >= \result * (0x2000 << (s->scale + 2)); */
static int32_t height_of(const struct shape *s);

/*@ requires box: \forall integer k; 0 <= k < 3 ==>
             -0x20000000 <= p[k].x <= 0x20000000 && -0x20000000 <= p[k].y <= 0x20000000;
    assigns \result \from p[0 .. 2];
    ensures range: 0 <= \result <= 0x3ffff; */
int32_t part_height(const struct part_place p[3]);

/*@ predicate q14(int32_t v) = -0x4800 <= v <= 0x4800;
    predicate q28(int32_t b) = -0x10000000 <= b <= 0x10000000; */

/*@ requires values: q14(value[0]) && q14(value[1]) && q14(value[2]);
    requires bulges: q28(bulge[0]) && q28(bulge[2]) && -0x20000000 <= bulge[1] <= 0x20000000;
    requires up: -8 <= up < 32;
    assigns \result, channel->exact, channel->p \from setup->plane, value[0 .. 2], bulge[0 .. 2], up; */
int part_channel(const struct shade_setup *setup, const struct shade_input *in,
                 const struct part_corner *const corner[3], const int32_t value[3], const int32_t bulge[3], int up,
                 struct channel *channel);

#endif

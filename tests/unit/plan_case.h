/* SPDX-License-Identifier: MIT */
/*
 * Triangles made at random, planned by plan_triangle(), and what ideal arithmetic makes of the plan against per-pixel
 * Phong with the linear normal, both in double precision on a lattice of points. In perspective the truth is taken
 * where the point is in space, the plan's values where it is on the screen.
 */
#ifndef PLAN_CASE_H
#define PLAN_CASE_H

#include "plan/plan.h"
#include "random.h"

#include <math.h>
#include <string.h>

#define PLAN_CASE_LIGHTS 3

struct plan_case {
    double dot[PLAN_CASE_LIGHTS][2][3]; /* N.L, N.H at the corners, as vertex records have them */
    double bend[3];                     /* (1 - Ni.Nj) / 2 of edges 0-1, 1-2, 2-0, as the mesh has them */
    double closeness[3];                /* 1 / w of the corners */
    uint16_t packed_bend[3];
    int16_t record[3][VERTEX_LIGHTS + 2 * PLAN_CASE_LIGHTS];
    struct fx_power power;
    struct plan_surface surface;
    struct plan_triangle triangle;
    double rest; /* of full intensity, that lights can add before the channel is clamped; 1/255 */
};

/* A unit vector that leans from `from` by an angle. */
static inline void plan_case_lean(const double from[3], double angle, double out[3])
{
    double way[3], along = 0, length = 0;
    random_direction(way, 3);
    for (int i = 0; i < 3; i++)
        along += way[i] * from[i];
    for (int i = 0; i < 3; i++) {
        way[i] -= along * from[i];
        length += way[i] * way[i];
    }
    for (int i = 0; i < 3; i++)
        out[i] = cos(angle) * from[i] + sin(angle) / sqrt(length) * way[i];
}

static inline double plan_case_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double plan_case_rounded(double x, double one)
{
    return floor(x * one + .5) / one;
}

/* Normals within `widest` degrees of each other; lights anywhere, highlights near as often as not. */
static inline void plan_case_triangle(struct plan_case *c, double widest)
{
    double middle[3], normal[3][3], towards[2][3];
    random_direction(middle, 3);
    const double radius = widest * acos(-1) / 180 / 2 * 1.15 * sqrt(random_fraction());
    for (int k = 0; k < 3; k++)
        plan_case_lean(middle, radius * (random_fraction() < .6 ? 1 : random_fraction()), normal[k]);
    for (int k = 0; k < 3; k++) {
        const double bend = (1 - plan_case_dot(normal[k], normal[(k + 1) % 3])) / 2;
        c->packed_bend[k] = (uint16_t)fmin(65535, floor(bend * 65536 + .5));
        c->bend[k] = bend;
    }
    for (unsigned l = 0; l < c->surface.lights; l++) {
        const double far = random_fraction(), off = random_fraction();
        plan_case_lean(middle, far * far * acos(-1), towards[0]);
        plan_case_lean(middle, random_fraction() < .5 ? radius * 1.5 * off : off * off * 2, towards[1]);
        for (int d = 0; d < 2; d++)
            for (int k = 0; k < 3; k++) {
                const double dot = plan_case_rounded(plan_case_dot(normal[k], towards[d]), 16384);
                c->record[k][VERTEX_LIGHTS + 2 * l + (unsigned)d] = (int16_t)fmin(16383, dot * 16384);
                c->dot[l][d][k] = c->record[k][VERTEX_LIGHTS + 2 * l + (unsigned)d] / 16384.;
            }
    }
}

static inline void plan_case_material(struct plan_case *c, double budget)
{
    const double share = random_fraction() < .7 ? random_fraction() : 1;
    fx_power_build(&c->power,
                   random_fraction() < .2 ? (unsigned)random_between(1, 3) : (unsigned)random_magnitude(2, 60));
    c->surface = (struct plan_surface){.power = &c->power,
                                       .budget = (uint16_t)(budget * 256),
                                       .highlights = 1,
                                       .duff_sum = 65535,
                                       .foot = (int16_t)(16384 - (16384 >> c->power.octave))};
    c->surface.lights = (uint8_t)(random_fraction() < .7 ? 1 : random_between(2, PLAN_CASE_LIGHTS));
    c->rest = 255 * random_real(.3, 1);
    c->surface.full = (uint16_t)(c->rest * 256);
    c->rest = c->surface.full / 256.;
    for (unsigned l = 0; l < c->surface.lights; l++) {
        c->surface.light[l].diffuse = (uint16_t)(share * random_real(0, 65280));
        c->surface.light[l].specular = (uint16_t)random_between(0, 50000);
    }
}

static inline void plan_case_random(struct plan_case *c, double widest, double budget)
{
    const int divides = random_fraction() < .3;
    memset(c, 0, sizeof *c);
    plan_case_material(c, budget);
    plan_case_triangle(c, widest);
    const double far = random_magnitude(.02, 1);
    for (int k = 0; k < 3; k++) {
        const double closeness = divides ? far * (1 + random_magnitude(.001, .5) * random_fraction()) : 1;
        const int32_t depth = DEPTH_FAR + (int32_t)fmin(65519, closeness * 60000);
        c->record[k][VERTEX_DEPTH] = (int16_t)(uint16_t)depth;
        c->closeness[k] = (depth - DEPTH_FAR) / 60000.;
        c->triangle.lights[k] = c->record[k] + VERTEX_LIGHTS;
    }
    c->triangle.bend = c->packed_bend;
    c->triangle.shift = divides ? plan_shift((const int16_t *const[3]){c->record[0], c->record[1], c->record[2]}) : 0;
}

static inline double plan_case_lit(double dot)
{
    return dot < 0 ? 0 : dot > 1 ? 1 : dot;
}

/* The colour of dot products, 1/255, clamped. */
static inline double plan_case_colour(const struct plan_case *c, double dots[][2])
{
    double sum = 0;
    for (unsigned l = 0; l < c->surface.lights; l++)
        sum += c->surface.light[l].diffuse / 256. * plan_case_lit(dots[l][0]) +
               c->surface.light[l].specular / 256. * pow(plan_case_lit(dots[l][1]), c->power.exponent);
    return fmin(sum, c->rest);
}

/* A dot product at barycentric coordinates b: linear, by six samples, by the normalised normal. */
enum plan_case_way { PLAN_CASE_LINEAR, PLAN_CASE_SIX, PLAN_CASE_TRUE };
static inline double plan_case_value(const struct plan_case *c, const double dot[3], const double b[3],
                                     enum plan_case_way way)
{
    double linear = 0, bent = 0, square = 1;
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        linear += dot[k] * b[k];
        bent += (dot[k] + dot[next]) * 2 * (1 / sqrt(1 - c->bend[k]) - 1) * b[k] * b[next];
        square -= 4 * c->bend[k] * b[k] * b[next];
    }
    return way == PLAN_CASE_LINEAR ? linear : way == PLAN_CASE_SIX ? linear + bent : linear / sqrt(fmax(square, 1e-12));
}

/* The same by normals as long as their corners are close (duff in perspective), at a point of the screen. */
static inline double plan_case_weighted(const struct plan_case *c, const double dot[3], const double b[3])
{
    double linear = 0, square = 0;
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        const double s = c->closeness[k] * b[k], t = c->closeness[next] * b[next];
        linear += dot[k] * s;
        square += s * s + 2 * s * t * (1 - 2 * c->bend[k]);
    }
    return linear / sqrt(fmax(square, 1e-12));
}

static inline double plan_case_truth(const struct plan_case *c, const double space[3])
{
    double dots[PLAN_CASE_LIGHTS][2];
    for (unsigned l = 0; l < c->surface.lights; l++)
        for (int d = 0; d < 2; d++)
            dots[l][d] = plan_case_value(c, c->dot[l][d], space, PLAN_CASE_TRUE);
    return plan_case_colour(c, dots);
}

/* What the plan makes of a point of the screen. */
static inline double plan_case_planned(const struct plan_case *c, const struct shade_plan *plan, const double b[3])
{
    double dots[PLAN_CASE_LIGHTS][2], sum = 0;
    if (plan->rung == PLAN_CONSTANT) {
        for (unsigned l = 0; l < c->surface.lights; l++)
            sum += c->surface.light[l].diffuse / 256. * plan->level[2 * l] / 32768. +
                   c->surface.light[l].specular / 256. * plan->level[2 * l + 1] / 32768.;
        return fmin(sum, c->rest);
    }
    if (plan->rung == PLAN_GOURAUD) {
        for (int k = 0; k < 3; k++) {
            for (unsigned l = 0; l < c->surface.lights; l++)
                for (int d = 0; d < 2; d++)
                    dots[l][d] = c->dot[l][d][k];
            sum += b[k] * plan_case_colour(c, dots);
        }
        return sum;
    }
    for (unsigned l = 0; l < c->surface.lights; l++)
        for (int d = 0; d < 2; d++) {
            const int shown = (d ? plan->specular : plan->diffuse) >> l & 1,
                      bent = (d ? plan->specular_bent : plan->diffuse_bent) >> l & 1;
            dots[l][d] = plan->rung == PLAN_DUFF && c->triangle.shift && !plan->undivided
                             ? plan_case_weighted(c, c->dot[l][d], b)
                         : plan->rung == PLAN_DUFF ? plan_case_value(c, c->dot[l][d], b, PLAN_CASE_TRUE)
                         : shown ? plan_case_value(c, c->dot[l][d], b, bent ? PLAN_CASE_SIX : PLAN_CASE_LINEAR)
                                 : 0;
        }
    return plan_case_colour(c, dots);
}

/* What roundings may add to a plan's error, 1/255: half a unit of each record, of the mesh's bends, and the power's
 * table. */
static inline double plan_case_roundings(const struct plan_case *c)
{
    double sum = .01;
    for (unsigned l = 0; l < c->surface.lights; l++)
        sum += c->surface.light[l].diffuse / 256. / 16384 +
               c->surface.light[l].specular / 256. * (c->power.exponent / 16384. + .5 / 255);
    return sum;
}

/* The largest difference over a lattice of `side` steps. */
static inline double plan_case_error(const struct plan_case *c, const struct shade_plan *plan, int side)
{
    double most = 0;
    for (int i = 0; i <= side; i++)
        for (int j = 0; i + j <= side; j++) {
            const double b[3] = {(side - i - j) / (double)side, i / (double)side, j / (double)side};
            double space[3], sum = 0;
            for (int k = 0; k < 3; k++)
                sum += b[k] * c->closeness[k];
            for (int k = 0; k < 3; k++)
                space[k] = b[k] * c->closeness[k] / sum;
            most = fmax(most, fabs(plan_case_planned(c, plan, b) - plan_case_truth(c, space)));
        }
    return most;
}

/* Counts of many plans: how close to a rung's bound its error came, and how often beyond. */
struct plan_case_counts {
    unsigned long planned[PLAN_RUNGS], beyond[PLAN_RUNGS], beyond_most[PLAN_RUNGS];
    double closest[PLAN_RUNGS]; /* the largest part of a bound of 1/4 and more that an error was, roundings included */
};

/* Plans `count` triangles; what is beyond `share` of the bound (1: the bound) is counted in beyond_most too. */
static inline void plan_case_run(struct plan_case_counts *counts, double widest, unsigned long count, int side,
                                 double share)
{
    for (unsigned long i = 0; i < count; i++) {
        struct plan_case c;
        struct shade_plan plan;
        plan_case_random(&c, widest, random_magnitude(.25, 32));
        plan_triangle(&plan, &c.surface, &c.triangle);
        if (plan.rung == PLAN_PHONG)
            continue;
        const double error = plan_case_error(&c, &plan, side), bound = plan.error / 256.,
                     more = plan_case_roundings(&c);
        counts->planned[plan.rung]++;
        counts->beyond[plan.rung] += error > bound + more || plan.error > c.surface.budget;
        counts->beyond_most[plan.rung] += error > share * bound + more;
        if (bound >= .25)
            counts->closest[plan.rung] = fmax(counts->closest[plan.rung], error / (bound + more));
    }
}

#endif

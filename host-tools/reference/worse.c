/* SPDX-License-Identifier: MIT */
#include "reference/worse.h"

#include "reference/method.h"
#include "scene/vec.h"

#include <math.h>

enum { WORSE_STEPS = 8 }; /* of an edge: sampled on a regular grid, with the corners */

/* In (0, 1) (xorshift). */
static double worse_fraction(uint32_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 17;
    *seed ^= *seed << 5;
    return *seed * 0x1p-32;
}

/* A direction of n <= 3 dimensions, all equally likely. */
static void worse_direction(double *v, int n, uint32_t *seed)
{
    double length;
    do {
        length = 0;
        for (int k = 0; k < n; k++) {
            v[k] = 2 * worse_fraction(seed) - 1;
            length += v[k] * v[k];
        }
    } while (length > 1 || length < 1e-4);
    for (int k = 0; k < n; k++)
        v[k] /= sqrt(length);
}

void worse_make(struct worse_triangle *t, struct decode_view *view, double cosine, uint32_t *seed)
{
    static const struct decode_material material = {.diffuse = {1, 1, 1}, .shininess = 1};
    struct decode_vertex corner[3] = {0};
    double bend[3], place[3][2] = {{0}};
    worse_direction(view->lights[0].vector, 3, seed);
    for (unsigned v = 0; v < 3; v++) {
        double turn[2], *normal = corner[v].normal;
        worse_direction(turn, 2, seed);
        normal[2] = cosine + (1 - cosine) * worse_fraction(seed);
        for (int k = 0; k < 2; k++)
            normal[k] = turn[k] * sqrt(1 - normal[2] * normal[2]);
    }
    t->smallest = 1;
    for (unsigned e = 0; e < 3; e++) {
        double dot = vec_dot(corner[e].normal, corner[(e + 1) % 3].normal);
        bend[e] = (1 - dot) / 2;
        t->smallest = fmin(t->smallest, dot);
    }
    shading_material(&t->shading, view, &material, 1);
    shading_setup(&t->shading, methods + REFERENCE_X, corner, bend, place);
}

struct worse_values worse_at(const struct worse_triangle *t, const double at[3])
{
    const struct quadratic *dot = &t->shading.dot[0][0];
    struct decode_vertex v = shading_mix(t->shading.corner, at);
    struct worse_values out = {.x = quadratic_value(dot, at), .line = quadratic_linear(dot->corner, at)};
    out.truth = out.line / vec_length(v.normal);
    for (int k = 0; k < 3; k++)
        out.clamped_line += at[k] * fmax(0, dot->corner[k]);
    return out;
}

static double worse_square(double x)
{
    return x * x;
}

/* X's RMS difference over the line's: as they are, and as they are seen, in 0..1. */
static void worse_compare(const struct worse_triangle *t, double *ratio, double *clamped_ratio)
{
    double x = 0, line = 0, clamped_x = 0, clamped_line = 0;
    for (int i = 0; i <= WORSE_STEPS; i++)
        for (int j = 0; i + j <= WORSE_STEPS; j++) {
            const double at[3] = {(double)i / WORSE_STEPS, (double)j / WORSE_STEPS,
                                  (double)(WORSE_STEPS - i - j) / WORSE_STEPS};
            struct worse_values v = worse_at(t, at);
            double seen = fmax(0, v.truth);
            x += worse_square(v.x - v.truth);
            line += worse_square(v.line - v.truth);
            clamped_x += worse_square(fmin(1, fmax(0, v.x)) - seen);
            clamped_line += worse_square(v.clamped_line - seen);
        }
    *ratio = sqrt(x / line);
    *clamped_ratio = clamped_x > 0 ? sqrt(clamped_x / clamped_line) : 0;
}

struct worse_count worse_count(double degrees, unsigned triangles)
{
    struct decode_view view = {.light_count = 1, .lights = {{.colour = {1, 1, 1}}}};
    struct worse_count count = {.clamped_degrees = 180};
    struct worse_triangle t;
    uint32_t seed = 7;
    for (unsigned i = 0; i < triangles; i++) {
        double ratio, clamped;
        worse_make(&t, &view, cos(degrees * acos(-1) / 180), &seed);
        worse_compare(&t, &ratio, &clamped);
        count.worse += ratio > 1;
        count.ratio = fmax(count.ratio, ratio);
        count.clamped_worse += clamped > 1;
        count.clamped_ratio = fmax(count.clamped_ratio, clamped);
        if (clamped > 1)
            count.clamped_degrees = fmin(count.clamped_degrees, acos(t.smallest) * 180 / acos(-1));
    }
    return count;
}

/* SPDX-License-Identifier: MIT */
/*
 * "The approximation will always do better than a linear approximation" says the paper on X-shading. In the middle of
 * an edge it does. Over a triangle it does not always: here are counted, over random normals and lights, the triangles
 * on which X's RMS difference from Phong's N.L is larger than that of the line, before clamping and after.
 */
#include "random.h"
#include "reference/method.h"
#include "scene/vec.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>

enum { TRIANGLES = 100000, STEPS = 8, SAMPLES = (STEPS + 1) * (STEPS + 2) / 2 };

static double sample[SAMPLES][3]; /* barycentric, a regular grid with the corners */

static void make_samples(void)
{
    int n = 0;
    for (int i = 0; i <= STEPS; i++)
        for (int j = 0; i + j <= STEPS; j++, n++)
            for (int k = 0; k < 3; k++)
                sample[n][k] = (double[]){i, j, STEPS - i - j}[k] / STEPS;
}

/* A unit vector within the angle of +z whose cosine this is, every direction as likely. */
static void random_within(double cosine, double v[3])
{
    double turn[2];
    random_direction(turn, 2);
    v[2] = random_real(cosine, 1);
    for (int k = 0; k < 2; k++)
        v[k] = turn[k] * sqrt(1 - v[2] * v[2]);
}

struct triangle {
    struct shading shading;
    double smallest; /* cosine between two of the normals */
};

static void make(struct triangle *t, struct decode_view *view, double cosine)
{
    static const struct decode_material material = {.diffuse = {1, 1, 1}, .shininess = 1};
    struct decode_vertex corner[3] = {0};
    double bend[3], place[3][2] = {{0}};
    random_direction(view->lights[0].vector, 3);
    for (unsigned v = 0; v < 3; v++)
        random_within(cosine, corner[v].normal);
    t->smallest = 1;
    for (unsigned e = 0; e < 3; e++) {
        double dot = vec_dot(corner[e].normal, corner[(e + 1) % 3].normal);
        bend[e] = (1 - dot) / 2;
        t->smallest = fmin(t->smallest, dot);
    }
    shading_material(&t->shading, view, &material, 1);
    shading_setup(&t->shading, methods + REFERENCE_X, corner, bend, place);
}

struct values {
    double truth, x, line, clamped_line;
};

static struct values values_at(const struct triangle *t, const double at[3])
{
    const struct quadratic *dot = &t->shading.dot[0][0];
    struct decode_vertex v = shading_mix(t->shading.corner, at);
    struct values out = {.x = quadratic_value(dot, at), .line = quadratic_linear(dot->corner, at)};
    out.truth = out.line / vec_length(v.normal);
    for (int k = 0; k < 3; k++)
        out.clamped_line += at[k] * fmax(0, dot->corner[k]);
    return out;
}

/* X's RMS difference over the line's: as they are, and as they are seen, in 0..1. */
static void compare(const struct triangle *t, double *ratio, double *clamped_ratio)
{
    double x = 0, line = 0, clamped_x = 0, clamped_line = 0;
    for (int i = 0; i < SAMPLES; i++) {
        struct values v = values_at(t, sample[i]);
        double seen = fmax(0, v.truth);
        x += pow(v.x - v.truth, 2);
        line += pow(v.line - v.truth, 2);
        clamped_x += pow(fmin(1, fmax(0, v.x)) - seen, 2);
        clamped_line += pow(v.clamped_line - seen, 2);
    }
    *ratio = sqrt(x / line);
    *clamped_ratio = clamped_x > 0 ? sqrt(clamped_x / clamped_line) : 0;
}

struct count {
    unsigned worse, clamped_worse;
    double ratio, clamped_ratio, clamped_degrees;
};

/* Of random triangles whose normals lie within `degrees` of one direction. */
static struct count count_worse(double degrees)
{
    struct decode_view view = {.light_count = 1, .lights = {{.colour = {1, 1, 1}}}};
    struct count count = {.clamped_degrees = 180};
    struct triangle t;
    random_seed(7);
    for (int i = 0; i < TRIANGLES; i++) {
        double ratio, clamped;
        make(&t, &view, cos(degrees * acos(-1) / 180));
        compare(&t, &ratio, &clamped);
        count.worse += ratio > 1;
        count.ratio = fmax(count.ratio, ratio);
        count.clamped_worse += clamped > 1;
        count.clamped_ratio = fmax(count.clamped_ratio, clamped);
        if (clamped > 1)
            count.clamped_degrees = fmin(count.clamped_degrees, acos(t.smallest) * 180 / acos(-1));
    }
    print_message("normals within %2.0f degrees: worse on %.3f %%, at most %.4f times; clamped on %.3f %%", degrees,
                  100. * count.worse / TRIANGLES, count.ratio, 100. * count.clamped_worse / TRIANGLES);
    if (count.clamped_worse)
        print_message(", %.4f times, from %.1f degrees on", count.clamped_ratio, count.clamped_degrees);
    print_message("\n");
    return count;
}

/* There the line's norm is c and X's c (3 - c^2)/2, between c and 1. */
static void in_the_middle_of_an_edge_x_is_never_worse(void **state)
{
    struct decode_view view = {.light_count = 1, .lights = {{.colour = {1, 1, 1}}}};
    struct triangle t;
    (void)state;
    random_seed(8);
    for (int i = 0; i < TRIANGLES; i++) {
        double at[3] = {.5, .5, .5};
        at[i % 3] = 0;
        make(&t, &view, 0);
        struct values v = values_at(&t, at);
        assert_true(fabs(v.x - v.truth) <= fabs(v.line - v.truth) + 1e-15);
    }
}

/* By how far the normals may lean from one direction. */
static const double cones[] = {10, 30, 50, 80};
static struct count counts[4];

static int count_all(void **state)
{
    (void)state;
    make_samples();
    for (int i = 0; i < 4; i++)
        counts[i] = count_worse(cones[i]);
    return 0;
}

/* The paper's claim does not hold, but nearly. The share is what this generator gives, rounded up. */
static void over_a_triangle_it_is_seldom_and_little(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        assert_true(counts[i].worse > 0);
        assert_true(counts[i].worse < .0025 * TRIANGLES);
        assert_true(counts[i].ratio <= 1.07);
    }
}

/* As it is seen, with Gouraud's corners clamped too. */
static void clamped_it_is_not_below_100_degrees(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++)
        assert_int_equal(counts[i].clamped_worse, 0);
    assert_true(counts[3].clamped_worse > 0 && counts[3].clamped_worse < .01 * TRIANGLES);
    assert_true(counts[3].clamped_degrees > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(in_the_middle_of_an_edge_x_is_never_worse),
        cmocka_unit_test(over_a_triangle_it_is_seldom_and_little),
        cmocka_unit_test(clamped_it_is_not_below_100_degrees),
    };
    return cmocka_run_group_tests(tests, count_all, NULL);
}

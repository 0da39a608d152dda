/* SPDX-License-Identifier: MIT */
/* X-shading's error grows with the angle between the normals of an edge as the paper's Fig. 3 says. */
#include "reference/curve.h"
#include "reference/method.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The figure's curve in four digits. */
static void the_middle_vector_is_as_long_as_the_paper_draws(void **state)
{
    static const struct {
        double degrees, norm;
    } figure[] = {{0, 1}, {20, .9997}, {41.4, .9939}, {45, .9915}, {60, .9743}, {90, .8839}, {120, .6875}};
    (void)state;
    for (size_t i = 0; i < sizeof figure / sizeof *figure; i++) {
        double c = cos(figure[i].degrees * acos(-1) / 360), norm = curve_x(figure[i].degrees).norm;
        print_message("%5.1f degrees: norm %.4f\n", figure[i].degrees, norm);
        assert_true(fabs(norm - figure[i].norm) <= 5e-5);
        assert_true(fabs(norm - c * (3 - c * c) / 2) < 1e-12);
    }
}

/* In the middle of an edge the method itself makes N.L of the light along the bisector, which is that norm. */
static void x_draws_that_norm(void **state)
{
    static const struct decode_material material = {.diffuse = {1, 1, 1}, .shininess = 1};
    struct decode_view view = {.light_count = 1, .lights = {{.vector = {0, 0, 1}, .colour = {1, 1, 1}}}};
    (void)state;
    for (int degrees = 0; degrees <= 120; degrees++) {
        struct shading shading;
        double half = degrees * acos(-1) / 360, bend[3] = {pow(sin(half), 2)}, place[3][2] = {{0}}, colour[3];
        struct decode_vertex corner[3] = {{.normal = {sin(half), 0, cos(half)}},
                                          {.normal = {-sin(half), 0, cos(half)}}};
        corner[2] = corner[0];
        bend[1] = bend[0];
        shading_material(&shading, &view, &material, 1);
        shading_setup(&shading, methods + REFERENCE_X, corner, bend, place);
        shading.method->pixel(&shading, (double[3]){.5, .5, 0}, colour);
        assert_true(fabs(colour[0] - curve_x(degrees).norm) < 1e-12);
    }
}

/* With the cube of the angle, at large angles faster; the line's with its square. The true middle is better at every
 * angle, and the line worse. */
static void the_error_grows_with_the_angle(void **state)
{
    struct curve_point last = curve_x(1);
    (void)state;
    for (int degrees = 2; degrees <= 120; degrees++) {
        struct curve_point p = curve_x(degrees);
        assert_true(p.error > last.error && p.norm < last.norm);
        assert_true(p.six_error < p.error && p.error < p.linear_error);
        last = p;
    }
    for (int degrees = 15; degrees <= 120; degrees *= 2) {
        struct curve_point p = curve_x(degrees), q = curve_x(degrees / 2.);
        assert_true(p.error > 8 * q.error && p.error < 10.5 * q.error);
        assert_true(p.linear_error > 3.7 * q.linear_error && p.linear_error < 4 * q.linear_error);
        print_message("%3d degrees: x %.3f, six %.3f, gouraud %.3f of 255\n", degrees, 255 * p.error, 255 * p.six_error,
                      255 * p.linear_error);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_middle_vector_is_as_long_as_the_paper_draws),
        cmocka_unit_test(x_draws_that_norm),
        cmocka_unit_test(the_error_grows_with_the_angle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

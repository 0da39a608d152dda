/* SPDX-License-Identifier: MIT */
/* The bounds that decide what is left out, against X-shading's polynomial in double precision. */
#include "plan/bounds.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#define GRID 24 /* barycentric steps a side */

/* A triangle as it should be, and as the renderer has it. */
struct shading {
    double value[3], bulge[3]; /* of edges 0-1, 1-2, 2-0 */
    int32_t value_q14[3];
    uint16_t bend_q16[3];
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* What the packer and a vertex record make of normals and a light. */
static struct shading shading_of(double normal[3][3], const double light[3])
{
    struct shading s;
    for (int k = 0; k < 3; k++) {
        s.value[k] = dot(normal[k], light);
        double v = floor(s.value[k] * 16384 + .5);
        s.value_q14[k] = (int32_t)(v > 16383 ? 16383 : v);
    }
    for (int k = 0; k < 3; k++) {
        double minus_k = (1 - dot(normal[k], normal[(k + 1) % 3])) / 2, bend = floor(minus_k * 65536 + .5);
        s.bulge[k] = -(s.value[k] + s.value[(k + 1) % 3]) * minus_k;
        s.bend_q16[k] = (uint16_t)(bend > 65535 ? 65535 : bend);
    }
    return s;
}

/* Three normals within `angle` of a common one. */
static void random_normals(double normal[3][3], double angle)
{
    double axis[3];
    random_direction(axis, 3);
    for (int k = 0; k < 3; k++) {
        double aside[3], side = 0, along = cos(angle * random_fraction()), up;
        random_direction(aside, 3);
        up = dot(aside, axis);
        for (int i = 0; i < 3; i++) {
            aside[i] -= up * axis[i];
            side += aside[i] * aside[i];
        }
        for (int i = 0; i < 3; i++)
            normal[k][i] = axis[i] * along + aside[i] * sqrt((1 - along * along) / side);
    }
}

/* The highest value over the triangle and the furthest from linear, both in Q14. */
static void extremes(const struct shading *s, double *high, double *bend)
{
    *high = -1e9;
    *bend = 0;
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; i + j <= GRID; j++) {
            double l[3] = {i / (double)GRID, j / (double)GRID, (GRID - i - j) / (double)GRID}, off = 0;
            for (int k = 0; k < 3; k++)
                off += s->bulge[k] * l[k] * l[(k + 1) % 3];
            double phi = (dot(s->value, l) - off) * 16384;
            *high = phi > *high ? phi : *high;
            *bend = fabs(off) * 16384 > *bend ? fabs(off) * 16384 : *bend;
        }
}

/* Returns how much of the promised bend is used. */
static double check(const struct shading *s)
{
    double high, bend;
    extremes(s, &high, &bend);
    struct bounds range = bounds_of(s->value_q14);
    int32_t most = bounds_bend(range, bounds_curl(s->bend_q16));
    if (bend >= most)
        fail_msg("values %d %d %d, bends %u %u %u: %.2f from linear, not below %d", s->value_q14[0], s->value_q14[1],
                 s->value_q14[2], s->bend_q16[0], s->bend_q16[1], s->bend_q16[2], bend, most);
    if (high > range.high + most)
        fail_msg("values %d %d %d, bends %u %u %u: %.2f, above %d", s->value_q14[0], s->value_q14[1], s->value_q14[2],
                 s->bend_q16[0], s->bend_q16[1], s->bend_q16[2], high, range.high + most);
    return bend / most;
}

static void no_value_exceeds_the_bound(void **state)
{
    (void)state;
    random_seed(21);
    for (int i = 0; i < 40000; i++) {
        double normal[3][3], light[3];
        random_normals(normal, random_magnitude(1e-3, 3.14159265358979));
        random_direction(light, 3);
        struct shading s = shading_of(normal, light);
        check(&s);
    }
}

static void no_value_exceeds_the_bound_where_normals_face_each_other(void **state)
{
    (void)state;
    random_seed(22);
    for (int i = 0; i < 10000; i++) {
        double normal[3][3], light[3];
        random_direction(normal[0], 3);
        random_direction(normal[2], 3);
        random_direction(light, 3);
        for (int k = 0; k < 3; k++) {
            normal[1][k] = -normal[0][k];
            if (i & 1)
                normal[2][k] = normal[0][k];
            if (i & 2)
                light[k] = normal[0][k];
        }
        struct shading s = shading_of(normal, light);
        check(&s);
    }
}

/* Three normals evenly about the light, all at one angle to it: each bulge is largest at the triangle's centre. */
static void the_bound_on_the_bend_is_nearly_reached(void **state)
{
    (void)state;
    for (int degrees = 10; degrees <= 60; degrees += 5) {
        double normal[3][3], light[3] = {0, 0, 1}, angle = degrees * 3.14159265358979 / 180;
        for (int k = 0; k < 3; k++) {
            normal[k][0] = sin(angle) * cos(k * 2.0943951023932);
            normal[k][1] = sin(angle) * sin(k * 2.0943951023932);
            normal[k][2] = cos(angle);
        }
        struct shading s = shading_of(normal, light);
        assert_true(check(&s) > .94);
    }
}

static void the_range_is_that_of_the_corners(void **state)
{
    (void)state;
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    static const int32_t sets[][3] = {{-16384, 5, 16383}, {-3, -2, -1}, {7, 7, 9}, {4, 9, 9}, {0, 0, 0}};
    for (size_t i = 0; i < sizeof sets / sizeof *sets; i++)
        for (int j = 0; j < 6; j++) {
            int32_t v[3];
            for (int k = 0; k < 3; k++)
                v[k] = sets[i][order[j][k]];
            struct bounds range = bounds_of(v);
            assert_int_equal(range.low, sets[i][0]);
            assert_int_equal(range.high, sets[i][2]);
        }
}

/* The largest values that scene.h allows: nothing overflows, nothing is less than two thirds. */
static void the_curl_is_at_least_two_thirds_of_the_largest_bend(void **state)
{
    (void)state;
    for (uint32_t bend = 0; bend <= 65535; bend++)
        for (int at = 0; at < 3; at++) {
            uint16_t bends[3] = {0, 0, 0};
            bends[at] = (uint16_t)bend;
            int32_t curl = bounds_curl(bends);
            assert_true(3 * curl >= (int32_t)bend && curl < 1 << 15);
            const struct bounds both = {-16384, 16383}, dark = {-16384, -16384};
            int32_t most = bounds_bend(both, curl);
            assert_true(6 * most >= (int32_t)bend && most <= 16384);
            assert_int_equal(bounds_bend(dark, curl), most);
        }
}

static void a_highlight_is_nothing_at_the_floor_of_its_power(void **state)
{
    (void)state;
    for (unsigned n = 1; n <= FX_POWER_MAX_EXPONENT; n++) {
        struct fx_power power;
        fx_power_build(&power, n);
        int32_t floor_q14 = bounds_power_floor(&power);
        assert_true(fx_power(&power, (q30_t)((uint32_t)floor_q14 << 16) - 1) == 0);
        if (floor_q14 > 0) /* just below it, what is left out cannot be seen: half of 1/255 */
            assert_true(pow(floor_q14 / 16384., n) * 255 < .5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_value_exceeds_the_bound),
        cmocka_unit_test(no_value_exceeds_the_bound_where_normals_face_each_other),
        cmocka_unit_test(the_bound_on_the_bend_is_nearly_reached),
        cmocka_unit_test(the_range_is_that_of_the_corners),
        cmocka_unit_test(the_curl_is_at_least_two_thirds_of_the_largest_bend),
        cmocka_unit_test(a_highlight_is_nothing_at_the_floor_of_its_power),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

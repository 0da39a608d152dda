/* SPDX-License-Identifier: MIT */
/* The bounds of plan/bump.h, against the errors of random triangles of unit vectors. */
#include "plan/bump.h"

#include "plan/curve.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "random.h"

#define LATTICE 12

/* Three unit vectors, their linear and quadratic interpolation, and the truth. */
struct vectors {
    double corner[3][3], middle[3][3];
    uint16_t bend[3];
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void make_unit(double v[3])
{
    const double length = sqrt(dot(v, v));
    for (int k = 0; k < 3; k++)
        v[k] /= length;
}

/* Around one direction, or at right angles (0); false if they span more than is promised for. */
static bool make(struct vectors *t, double spread)
{
    double axis[3];
    random_direction(axis, 3);
    for (int i = 0; i < 3; i++) {
        random_direction(t->corner[i], 3);
        for (int k = 0; k < 3; k++)
            t->corner[i][k] = spread > 0 ? axis[k] + spread * t->corner[i][k] : i == k;
        make_unit(t->corner[i]);
    }
    for (int i = 0; i < 3; i++) {
        const double *a = t->corner[i], *b = t->corner[(i + 1) % 3], bend = (1 - dot(a, b)) / 2;
        if (bend > .5)
            return false;
        t->bend[i] = (uint16_t)ceil(bend * 65536);
        for (int k = 0; k < 3; k++)
            t->middle[i][k] = a[k] + b[k];
        make_unit(t->middle[i]);
    }
    return true;
}

static void interpolate(const struct vectors *t, const double at[3], double linear[3], double bent[3])
{
    for (int k = 0; k < 3; k++) {
        linear[k] = at[0] * t->corner[0][k] + at[1] * t->corner[1][k] + at[2] * t->corner[2][k];
        bent[k] = linear[k];
        for (int i = 0; i < 3; i++)
            bent[k] +=
                4 * at[i] * at[(i + 1) % 3] * (t->middle[i][k] - (t->corner[i][k] + t->corner[(i + 1) % 3][k]) / 2);
    }
}

static double spread_of(int n)
{
    static const double spreads[] = {.1, .2, .4, .6, 0};
    return spreads[n % 5];
}

static void no_quadratic_vector_is_farther_from_its_unit_than_the_tables_say(void **state)
{
    (void)state;
    random_seed(7);
    for (int n = 0; n < 20000; n++) {
        struct vectors t;
        if (!make(&t, spread_of(n)))
            continue;
        uint32_t most = 0, sum = 0;
        for (int i = 0; i < 3; i++) {
            most = t.bend[i] > most ? t.bend[i] : most;
            sum += t.bend[i];
        }
        const double s = fmax(.75 * most, (most + sum) / 4.);
        const double far = plan_bump_distance(most) / 65536., along = plan_bump_length((uint32_t)ceil(s)) / 65536.;
        for (int i = 0; i <= LATTICE; i++)
            for (int j = 0; i + j <= LATTICE; j++) {
                const double at[3] = {(LATTICE - i - j) / (double)LATTICE, i / (double)LATTICE, j / (double)LATTICE};
                double unit[3], bent[3], off[3];
                interpolate(&t, at, unit, bent);
                make_unit(unit);
                for (int k = 0; k < 3; k++)
                    off[k] = bent[k] - unit[k];
                assert_true(sqrt(dot(off, off)) <= far);
                assert_true(fabs(dot(bent, unit) - 1) <= along);
            }
    }
}

static double shine(double s, unsigned n)
{
    return s > 0 ? pow(fmin(s, 1), n) : 0;
}

/* Under one light, H' another triangle's: what a pixel is off by, over normals towards its worst. */
static void no_pixel_is_off_by_more_than_planned(void **state)
{
    static struct fx_power power;
    static const unsigned exponents[] = {1, 5, 20, 50, 200};
    (void)state;
    random_seed(11);
    for (int n = 0; n < 4000; n++) {
        struct vectors t[2];
        const unsigned exponent = exponents[n / 5 % 5];
        if (!make(&t[0], spread_of(n)) || !make(&t[1], spread_of(n / 25)))
            continue;
        fx_power_build(&power, exponent);
        struct plan_surface s = {.power = &power, .budget = 512, .lights = 1, .highlights = 1};
        s.light[0].diffuse = 150 << 8;
        s.light[0].specular = 80 << 8;
        uint16_t bend[2][3];
        memcpy(bend[0], t[0].bend, sizeof bend[0]);
        memcpy(bend[1], t[1].bend, sizeof bend[1]);
        struct plan_bump plan = {0, 0};
        plan_bump_light(&plan, &s, 0, (const uint16_t(*)[3])bend, 0);
        for (int sample = 0; sample < 60; sample++) {
            const double a = random_fraction(), b = random_fraction() * (1 - a), at[3] = {1 - a - b, a, b};
            double dots[3][2], normal[3];
            for (int which = 0; which < 2; which++) {
                double linear[3], bent[3], unit[3], axis[3];
                interpolate(&t[which], at, linear, bent);
                memcpy(unit, linear, sizeof unit);
                make_unit(unit);
                random_direction(axis, 3);
                for (int k = 0; k < 3; k++) /* near H' a highlight shows */
                    normal[k] = unit[k] + axis[k] * (sample % 3) / (1 + .3 * exponent);
                make_unit(normal);
                dots[0][which] = dot(normal, unit);
                dots[1][which] = dot(normal, linear);
                dots[2][which] = dot(normal, bent);
            }
            for (int way = 1; way < 3; way++) {
                const double off = 150 * fabs(fmax(0, dots[way][0]) - fmax(0, dots[0][0])) +
                                   80 * fabs(shine(dots[way][1], exponent) - shine(dots[0][1], exponent));
                assert_true(off <= (way == 1 ? plan.linear : plan.quadratic) / 256.);
            }
        }
    }
}

static void a_larger_budget_takes_a_cheaper_way(void **state)
{
    (void)state;
    const struct plan_bump plan = {900, 300};
    uint16_t error;
    struct plan_surface s = {.budget = 899};
    assert_int_equal(plan_bump_choose(&plan, &s, &error), PLAN_BUMP_QUADRATIC);
    assert_int_equal(error, 300);
    s.budget = 900;
    assert_int_equal(plan_bump_choose(&plan, &s, &error), PLAN_BUMP_LINEAR);
    assert_int_equal(error, 900);
    s.budget = 299;
    assert_int_equal(plan_bump_choose(&plan, &s, &error), PLAN_BUMP_NORMALISED);
    assert_int_equal(error, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_quadratic_vector_is_farther_from_its_unit_than_the_tables_say),
        cmocka_unit_test(no_pixel_is_off_by_more_than_planned),
        cmocka_unit_test(a_larger_budget_takes_a_cheaper_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

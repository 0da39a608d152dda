/* SPDX-License-Identifier: MIT */
/* The set-ups that `make bench-setup` compares: each against the six samples, the integers against double. */
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "tests/setups/real.h"

static double value_at(const struct real_quadratic *q, double x, double y)
{
    return q->a * x * x + q->b * y * y + q->c * x * y + q->d * x + q->e * y + q->f;
}

static struct real_quadratic real_of_polynomial(const struct polynomial *p)
{
    return (struct real_quadratic){(int32_t)p->a * 0x1p-30, (int32_t)p->b * 0x1p-30, (int32_t)p->c * 0x1p-30,
                                   (int32_t)p->d * 0x1p-30, (int32_t)p->e * 0x1p-30, (int32_t)p->f * 0x1p-30};
}

/* The quadratic through six samples, by its Lagrange form in barycentric coordinates: no set-up at all. */
static double six_samples_at(const struct real_samples *s, double u, double v)
{
    double w = 1 - u - v;
    return s->i1 * w * (2 * w - 1) + s->i2 * u * (2 * u - 1) + s->i3 * v * (2 * v - 1) + 4 * s->i12 * w * u +
           4 * s->i23 * u * v + 4 * s->i13 * v * w;
}

/* Inside the triangle, its corners and edges too. */
static void random_point(double *u, double *v)
{
    *u = random_between(0, 8) / 8.;
    *v = random_between(0, 8) / 8. * (1 - *u);
}

/* X eq. 29-31 from the bulges: I12 = (I1 + I2)(5 - N1.N2) / 8 = (I1 + I2) / 2 - a12 / 4. */
static struct real_samples six_of_x(const struct real_samples *x)
{
    struct real_samples s = *x;
    s.i12 = (s.i1 + s.i2) / 2 - x->i12 / 4;
    s.i23 = (s.i2 + s.i3) / 2 - x->i23 / 4;
    s.i13 = (s.i1 + s.i3) / 2 - x->i13 / 4;
    return s;
}

static int is_x(const char *name)
{
    return name[0] == 'x';
}

/* Any six numbers, any triangle: an honest 1e-9, of rounding alone (heights of 8 pixels at least). */
static void every_way_goes_through_any_six_samples(void **state)
{
    (void)state;
    random_seed(51);
    for (uint32_t n = 0; n < 5000; n++) {
        struct setup_case integer;
        setup_case_make(&integer, n);
        struct real_case c = real_of(&integer);
        struct real_samples given = {random_real(-1, 1), random_real(-1, 1), random_real(-1, 1),
                                     random_real(-1, 1), random_real(-1, 1), random_real(-1, 1)};
        for (unsigned k = 0; k < REAL_SETUPS; k++) {
            struct real_samples six = is_x(real_setups[k].name) ? six_of_x(&given) : given;
            struct real_quadratic q;
            assert_int_equal(real_setups[k].solve(&c, &given, &q), 1);
            for (int j = 0; j < 8; j++) {
                double u, v;
                random_point(&u, &v);
                double wanted = six_samples_at(&six, u, v);
                double got = value_at(&q, u * c.x1 + v * c.x2, u * c.y1 + v * c.y2);
                assert_true(fabs(got - wanted) < 1e-9);
            }
        }
    }
}

/* With samples of normals of length 1, and X with its approximation of them, which is what it saves the roots by. */
static void samples_are_those_of_normalised_and_of_approximated_normals(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 5000; n++) {
        struct setup_case integer;
        setup_case_make(&integer, n);
        struct real_case c = real_of(&integer);
        for (unsigned k = 0; k < REAL_SETUPS; k++) {
            struct real_samples s;
            real_setups[k].sample(&c, &s);
            double sum[3], length = 0, dot = 0, light = 0;
            for (int i = 0; i < 3; i++) {
                sum[i] = c.n[0][i] + c.n[1][i];
                length += sum[i] * sum[i];
                dot += c.n[0][i] * c.n[1][i];
                light += sum[i] * c.l[i];
            }
            double wanted = light / sqrt(length);
            if (is_x(real_setups[k].name)) { /* eq. 28; the mesh's k has 16 bits */
                s = six_of_x(&s);
                wanted = light * (5 - dot) / 8;
            }
            assert_true(fabs(s.i12 - wanted) < (real_setups[k].name[1] ? 0x1p-18 : 1e-12));
        }
    }
}

/*
 * In display units (256 = full intensity), over the triangle: 1/128 is the rounding of corner values to Q14, as much
 * that of d and e. Seiler's e and c by substitution add up what their divisions by y1, a fourth of the height, make of
 * the others' last places.
 */
static double allowed(const char *name)
{
    return name[0] == 's' ? 1 / 35. : 1 / 55.;
}

static void integers_agree_with_double_precision(void **state)
{
    (void)state;
    assert_int_equal(setup_integer_count, REAL_SETUPS);
    random_seed(52);
    for (unsigned k = 0; k < setup_integer_count; k++) {
        double worst = 0;
        assert_string_equal(setup_integers[k].name, real_setups[k].name);
        for (uint32_t n = 0; n < 20000; n++) {
            struct setup_case integer;
            struct polynomial p;
            struct real_quadratic wanted;
            setup_case_make(&integer, n);
            struct real_case c = real_of(&integer);
            assert_int_equal(setup_integers[k].setup(&integer, &p), 1);
            assert_int_equal(real_setups[k].setup(&c, &wanted), 1);
            struct real_quadratic got = real_of_polynomial(&p);
            for (int j = 0; j < 8; j++) {
                double u, v;
                random_point(&u, &v);
                double x = u * c.x1 + v * c.x2, y = u * c.y1 + v * c.y2;
                worst = fmax(worst, 256 * fabs(value_at(&got, x, y) - value_at(&wanted, x, y)));
            }
        }
        print_message("%s: at most %.5f display units off\n", setup_integers[k].name, worst);
        if (worst > allowed(setup_integers[k].name))
            fail_msg("%s is off by %.5f display units", setup_integers[k].name, worst);
    }
}

/* No side longer than twice the height over it. */
static int is_stout(const struct real_case *c)
{
    double x = c->x2 - c->x1, y = c->y2 - c->y1;
    double longest = fmax(c->x1 * c->x1 + c->y1 * c->y1, fmax(c->x2 * c->x2 + c->y2 * c->y2, x * x + y * y));
    return 2 * fabs(c->x1 * c->y2 - c->x2 * c->y1) >= longest;
}

/*
 * Any shape that a polynomial holds, to 250 pixels, in any turn: the ways without a division by a coordinate, from the
 * same six samples. The thinnest are allowed 1/5 display unit as the renderer's are (shade/plane.c), the stout have the
 * bound above.
 */
static void those_without_special_cases_hold_for_any_shape(void **state)
{
    (void)state;
    double worst[2] = {0}; /* of the stout; of all */
    long level = 0, tested[2] = {0};
    random_seed(53);
    for (int n = 0; n < 100000; n++) {
        struct setup_case integer;
        setup_case_make(&integer, (uint32_t)n);
        int reach = 64 << random_between(0, 5);
        for (int k = 0; k < 3; k++) {
            integer.place[k][0] = (int16_t)random_between(-reach, reach);
            integer.place[k][1] = (int16_t)random_between(-reach, reach);
        }
        if (n & 1)
            integer.place[1][1] = integer.place[0][1];
        for (unsigned k = 0; k < setup_integer_count; k++) {
            const char *name = setup_integers[k].name;
            int divides = name[0] == 's' || (name[0] == 'a' && !name[5]);
            struct polynomial p;
            struct real_samples six;
            struct real_case c = real_of(&integer);
            if (divides || !setup_integers[k].setup(&integer, &p))
                continue;
            real_setups[k].sample(&c, &six);
            if (is_x(name))
                six = six_of_x(&six);
            struct real_quadratic got = real_of_polynomial(&p);
            double u, v;
            random_point(&u, &v);
            double off =
                256 * fabs(value_at(&got, u * c.x1 + v * c.x2, u * c.y1 + v * c.y2) - six_samples_at(&six, u, v));
            int stout = is_stout(&c);
            worst[0] = stout ? fmax(worst[0], off) : worst[0];
            worst[1] = fmax(worst[1], off);
            tested[0] += stout;
            tested[1]++;
            level += c.y1 == 0;
        }
    }
    print_message("%ld stout ones at most %.5f display units off, %ld in all %.5f, %ld with y1 = 0\n", tested[0],
                  worst[0], tested[1], worst[1], level);
    assert_true(tested[0] > 40000 && level > 50000);
    assert_true(worst[0] < 1 / 55.);
    assert_true(worst[1] < 1 / 5.);
}

/* Moved to a pixel's centre, and from N.L as a vertex record has it. */
static void the_renderers_own_is_the_same_quadratic(void **state)
{
    (void)state;
    double worst = 0;
    for (uint32_t n = 0; n < 5000; n++) {
        struct setup_case integer;
        struct polynomial p;
        struct real_quadratic wanted;
        struct plane plane;
        setup_case_make(&integer, n);
        struct real_case c = real_of(&integer);
        const int16_t *const place[3] = {integer.place[0], integer.place[1], integer.place[2]};
        assert_int_equal(setup_renderer(&integer, &p), 1);
        assert_int_equal(plane_setup(&plane, place, SETUP_SIZE, SETUP_SIZE), 1);
        assert_int_equal(real_x_k(&c, &wanted), 1);
        struct real_quadratic got = real_of_polynomial(&p);
        for (int j = 0; j < 8; j++) {
            double u, v;
            random_point(&u, &v);
            double x = u * c.x1 + v * c.x2, y = u * c.y1 + v * c.y2;
            double value = value_at(&got, x - plane.fx / 16., y - plane.fy / 16.);
            worst = fmax(worst, 256 * fabs(value - value_at(&wanted, x, y)));
        }
    }
    print_message("at most %.5f display units off\n", worst);
    assert_true(worst < 1 / 55.);
}

static void those_that_divide_by_y1_have_no_answer_where_it_is_0(void **state)
{
    (void)state;
    int none = 0;
    for (uint32_t n = 0; n < 1000; n++) {
        struct setup_case integer;
        setup_case_make(&integer, n);
        integer.place[1][1] = integer.place[0][1];
        for (unsigned k = 0; k < setup_integer_count; k++) {
            const char *name = setup_integers[k].name;
            int wanted = name[0] != 's' && !(name[0] == 'a' && !name[5]);
            struct polynomial p;
            struct real_quadratic q;
            struct real_case c = real_of(&integer);
            assert_int_equal(setup_integers[k].setup(&integer, &p), wanted);
            assert_int_equal(real_setups[k].setup(&c, &q), wanted);
            none += !wanted;
        }
    }
    assert_int_equal(none, 2000);
}

/* |A u + B v + C|^2, which the increments are to reproduce. */
static double square_at(const struct real_case *c, double x, double y)
{
    double w = 1 / (c->x1 * c->y2 - c->x2 * c->y1), u = (x * c->y2 - y * c->x2) * w, v = (y * c->x1 - x * c->y1) * w;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double n = c->n[0][i] + u * (c->n[1][i] - c->n[0][i]) + v * (c->n[2][i] - c->n[0][i]);
        sum += n * n;
    }
    return sum;
}

static void increments_of_both_triangles_reproduce_the_square(void **state)
{
    (void)state;
    for (uint32_t n = 0; n < 500; n++) {
        struct setup_case integer;
        setup_case_make(&integer, n);
        struct real_case c = real_of(&integer);
        for (unsigned k = 0; k < STEP_SETUPS; k++) {
            struct step_variables v;
            step_setups[k].setup(&c, &v);
            for (int edge = 0; edge < step_setups[k].edges; edge++) {
                double x = edge ? c.x1 : 0, y = edge ? c.y1 : 0;
                double dx = edge                        ? (c.x2 - c.x1) / (c.y2 - c.y1)
                            : step_setups[k].edges == 1 ? c.x2 / c.y2
                                                        : c.x1 / c.y1;
                struct step_edge e = v.edge[edge];
                for (int row = 0; row < 6; row++, x += dx, y++) {
                    double value = e.value, right = e.right;
                    for (int i = 0; i < 6; i++) {
                        assert_true(fabs(value - square_at(&c, x + i, y)) < 1e-10);
                        value += right;
                        right += v.right_second;
                    }
                    e.value += e.step;
                    e.step += e.second;
                    e.right += e.right_step;
                }
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_way_goes_through_any_six_samples),
        cmocka_unit_test(samples_are_those_of_normalised_and_of_approximated_normals),
        cmocka_unit_test(integers_agree_with_double_precision),
        cmocka_unit_test(those_without_special_cases_hold_for_any_shape),
        cmocka_unit_test(the_renderers_own_is_the_same_quadratic),
        cmocka_unit_test(those_that_divide_by_y1_have_no_answer_where_it_is_0),
        cmocka_unit_test(increments_of_both_triangles_reproduce_the_square),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

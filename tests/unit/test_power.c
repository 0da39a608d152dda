/* SPDX-License-Identifier: MIT */
/* The forms of the highlight's power: against their formulas, and the formulas against the power. */
#include "random.h"
#include "shade/power.h"

#include "glint.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

static const unsigned exponents[] = {1, 2, 3, 5, 8, 16, 17, 20, 50, 128, 200, 512, 1023};

#define COUNT(array) (sizeof array / sizeof *array)

static const struct {
    const struct glint_power *power;
    double gamma;
    double most; /* 1/255 at n = 50, as glint.h says */
} free_forms[] = {{&glint_power_4, 4, 17.5}, {&glint_power_8, 8, 7.6}, {&glint_power_16, 16, 3}};

static double truth(double s, unsigned n)
{
    return s <= 0 ? 0 : s >= 1 ? 1 : pow(s, n);
}

static double formula(double s, unsigned n, double gamma)
{
    return s <= 0 ? 0 : pow(fmax(0, 1 - n / gamma * (1 - fmin(1, s))), gamma);
}

/* Samples of -1.1..1.1, closer together towards 1. */
static int32_t sample(int i)
{
    double t = random_fraction();
    return (int32_t)lrint((i & 1 ? 1 - pow(10, -6 * t) : 2.2 * t - 1.1) * 0x1p30);
}

static void the_exact_form_is_the_power_rounded(void **state)
{
    (void)state;
    for (size_t e = 0; e < COUNT(exponents); e++)
        for (int i = 0; i < 20000; i++) {
            int32_t s = sample(i), value = s;
            glint_power_exact.run(exponents[e], &value, 1);
            double wanted = truth(s * 0x1p-30, exponents[e]) * 0x1p15;
            if (fabs(value - wanted) > .5 + 1e-6)
                fail_msg("%d^%u is %d / 32768, not %.3f", s, exponents[e], value, wanted);
        }
}

/* Up to five roundings to 16 bits: below 2^-12. */
static void the_free_forms_are_their_formula(void **state)
{
    (void)state;
    for (size_t f = 0; f < COUNT(free_forms); f++)
        for (size_t e = 0; e < COUNT(exponents); e++)
            for (int i = 0; i < 20000; i++) {
                int32_t s = sample(i), value = s;
                free_forms[f].power->run(exponents[e], &value, 1);
                double wanted = formula(s * 0x1p-30, exponents[e], free_forms[f].gamma) * 0x1p15;
                if (value < 0 || value > 32768 || fabs(value - wanted) > 8)
                    fail_msg("g %.0f: %d^%u is %d / 32768, not %.3f", free_forms[f].gamma, s, exponents[e], value,
                             wanted);
            }
}

static void the_free_forms_err_by_what_is_written(void **state)
{
    (void)state;
    for (size_t f = 0; f < COUNT(free_forms); f++) {
        double worst = 0;
        for (int i = 0; i <= 100000; i++) {
            int32_t value = (int32_t)((int64_t)i * (1 << 30) / 100000);
            double wanted = truth(value * 0x1p-30, 50) * 255;
            free_forms[f].power->run(50, &value, 1);
            worst = fmax(worst, fabs(value / 32768. * 255 - wanted));
        }
        print_message("g %.0f: off by at most %.2f of 1/255 at n = 50\n", free_forms[f].gamma, worst);
        assert_true(worst < free_forms[f].most + .05 && worst > free_forms[f].most - .5);
    }
}

/* What set-up makes of a triangle's values, evaluated at random places, and the rest of the power. The folding itself
 * keeps 31 - down bits; the place is exact. */
static void folding_changes_nothing(void **state)
{
    (void)state;
    for (size_t f = 0; f < COUNT(free_forms); f++)
        for (size_t e = 0; e < COUNT(exponents); e++)
            for (int i = 0; i < 5000; i++) {
                int32_t value[3], bulge[3], folded[3], bent[3];
                for (int k = 0; k < 3; k++) {
                    value[k] = random_between(-16384, 16384);
                    bulge[k] = random_between(-(1 << 26), 1 << 26);
                }
                unsigned down = free_forms[f].power->fold(exponents[e], value, bulge, folded, bent);
                double a = random_fraction(), b = random_fraction() * (1 - a), c = 1 - a - b;
                double s = (value[0] * a + value[1] * b + value[2] * c) / 16384 -
                           (bulge[0] * a * b + bulge[1] * b * c + bulge[2] * c * a) * 0x1p-28;
                int32_t got = (int32_t)lrint(folded[0] * a + folded[1] * b + folded[2] * c -
                                             4 * (bent[0] * a * b + bent[1] * b * c + bent[2] * c * a));
                free_forms[f].power->run_folded(exponents[e], down, &got, 1);
                double wanted = formula(s, exponents[e], free_forms[f].gamma) * 0x1p15;
                if (fabs(s) > 0x1p-16 && fabs(got - wanted) > 8) /* where n < g there is a step at 0 */
                    fail_msg("g %.0f n %u: s %.4f gives %d, not %.3f", free_forms[f].gamma, exponents[e], s, got,
                             wanted);
            }
}

/* With s down to -1.09 the result is within 1 + 2.09 n / g, in the loop's bound 2.125: the format holds that and is no
 * wider than it must. At n = 120 g the bound is 2^8 itself. */
static void folding_goes_down_as_far_as_it_must(void **state)
{
    (void)state;
    for (size_t f = 0; f < COUNT(free_forms); f++)
        for (unsigned n = 1; n < 1024; n++) {
            const int32_t value[3] = {0, 0, 0}, bulge[3] = {0, 0, 0};
            int32_t folded[3], bent[3];
            const unsigned down = free_forms[f].power->fold(n, value, bulge, folded, bent);
            const double most = n / free_forms[f].gamma;
            assert_true(exp2(down) >= 1 + 2.09 * most);
            assert_true(down == 1 || exp2(down - 1) < 1 + 2.125 * most);
        }
}

/* Values are a buffer's: what stands behind them is not theirs. */
static void only_the_values_asked_for_are_written(void **state)
{
    (void)state;
    for (size_t f = 0; f <= COUNT(free_forms); f++)
        for (int count = 0; count < 3; count++) {
            int32_t value[4] = {1 << 29, 1 << 29, 1 << 29, 1 << 29};
            (f ? free_forms[f - 1].power : &glint_power_exact)->run(2, value, count);
            for (int i = 0; i < 4; i++)
                assert_int_equal(value[i] == 1 << 29, i >= count);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_exact_form_is_the_power_rounded),
        cmocka_unit_test(the_free_forms_are_their_formula),
        cmocka_unit_test(the_free_forms_err_by_what_is_written),
        cmocka_unit_test(folding_changes_nothing),
        cmocka_unit_test(folding_goes_down_as_far_as_it_must),
        cmocka_unit_test(only_the_values_asked_for_are_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

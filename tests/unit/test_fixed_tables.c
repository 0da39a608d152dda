/* SPDX-License-Identifier: MIT */
/* The tables are private to fixed.c: this program takes it in whole, instead of its object from the library. */
#include "fixed/fixed.c"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static void every_reciprocal_is_its_formula(void **state)
{
    (void)state;
    for (int i = 0; i < 256; i++)
        assert_int_equal(recip_table[i], lround(0x1p18 / (2 * i + 513)) - 256);
}

static void every_root_is_its_formula(void **state)
{
    (void)state;
    for (int i = 0; i < 192; i++)
        assert_int_equal(rsqrt_table[i], lround(sqrt(0x1p23 / (2 * (i + 64) + 1))));
}

/* Newton's divided differences in z = x^2 through the six points, multiplied out. */
static void every_sine_coefficient_is_its_formula(void **state)
{
    (void)state;
    const long double pi = 3.14159265358979323846264338327950288L;
    long double z[SIN_TERMS], d[SIN_TERMS], c[SIN_TERMS] = {0};
    for (int j = 0; j < SIN_TERMS; j++) {
        long double x = cosl(pi * j / 11);
        z[j] = x * x;
        d[j] = sinl(pi / 2 * x) / x;
    }
    for (int order = 1; order < SIN_TERMS; order++)
        for (int j = SIN_TERMS - 1; j >= order; j--)
            d[j] = (d[j] - d[j - 1]) / (z[j] - z[j - order]);
    for (int j = SIN_TERMS - 1; j >= 0; j--) { /* c = c (z - z[j]) + d[j] */
        for (int k = SIN_TERMS - 1; k > 0; k--)
            c[k] = c[k - 1] - z[j] * c[k];
        c[0] = d[j] - z[j] * c[0];
    }
    for (int k = 0; k < SIN_TERMS; k++)
        assert_int_equal(sin_coefficient[k], llroundl(ldexpl(k & 1 ? -c[k] : c[k], 31 + k)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_reciprocal_is_its_formula),
        cmocka_unit_test(every_root_is_its_formula),
        cmocka_unit_test(every_sine_coefficient_is_its_formula),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

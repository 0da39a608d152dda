/* SPDX-License-Identifier: MIT */
/* The parts that `make report` compares are the renderer's own where they say so, and better with every term. */
#include "tests/choices/parts.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "random.h"

#define PLACES 200000

static uint32_t any(uint32_t from)
{
    return from + (uint32_t)((double)(UINT32_MAX - from) * random_fraction());
}

static void the_own_reciprocal_is_the_renderers(void **state)
{
    (void)state;
    random_seed(1);
    for (int i = 0; i < PLACES; i++) {
        uint32_t m = any(1u << 31);
        assert_int_equal(parts_reciprocals[PARTS_RECIPROCAL_OWN].run(m), fx_recip_norm(m));
    }
}

static void the_own_root_is_the_renderers(void **state)
{
    (void)state;
    random_seed(2);
    for (int i = 0; i < PLACES; i++) {
        uint32_t m = any(1u << 30);
        assert_int_equal(parts_roots[PARTS_ROOT_OWN].run(m), fx_rsqrt_norm(m));
    }
}

static void the_own_power_is_the_renderers(void **state)
{
    static const unsigned exponents[] = {1, 5, 20, 50, 200, 1023};
    (void)state;
    random_seed(3);
    for (unsigned e = 0; e < sizeof exponents / sizeof *exponents; e++) {
        struct fx_power own;
        struct parts_table table;
        fx_power_build(&own, exponents[e]);
        parts_power_build(&table, exponents[e], PARTS_POWER_OWN);
        for (int i = 0; i < PLACES / 10; i++) {
            q30_t s = (q30_t)((int64_t)any(0) - (1ll << 31));
            assert_int_equal(parts_power(&table, s, PARTS_POWER_OWN, 0), fx_power(&own, s));
        }
    }
}

/* The largest error of a series, in bits. */
static double bits_of(parts_function *run, uint32_t from, double top, double exponent)
{
    double most = 0;
    random_seed(4);
    for (int i = 0; i < PLACES / 4; i++) {
        uint32_t m = any(from);
        most = fmax(most, fabs(run(m) * pow(m, exponent) / top - 1));
    }
    return -log2(most);
}

static void every_term_of_a_series_is_worth_five_bits(void **state)
{
    (void)state;
    for (unsigned i = 1; i < PARTS_RECIPROCAL_OWN + 1; i++)
        assert_true(bits_of(parts_reciprocals[i].run, 1u << 31, 0x1p63, 1) >
                    bits_of(parts_reciprocals[i - 1].run, 1u << 31, 0x1p63, 1) + 5);
    for (unsigned i = 1; i < PARTS_ROOTS; i++)
        assert_true(bits_of(parts_roots[i].run, 1u << 30, 0x1p46, .5) >
                    bits_of(parts_roots[i - 1].run, 1u << 30, 0x1p46, .5) + 5);
    assert_true(bits_of(parts_reciprocals[PARTS_RECIPROCALS - 1].run, 1u << 31, 0x1p63, 1) > 30.9);
}

static void twice_the_steps_are_never_worse(void **state)
{
    (void)state;
    for (int nearest = 0; nearest <= 1; nearest++) {
        double before = 1;
        for (unsigned bits = PARTS_POWER_LEAST; bits <= PARTS_POWER_MOST; bits++) {
            struct parts_table table;
            double most = 0;
            parts_power_build(&table, 20, bits);
            for (int i = 0; i <= 4096; i++)
                most = fmax(most, fabs(parts_power(&table, i << 18, bits, nearest) / 32768. - pow(i / 4096., 20)));
            assert_true(most <= before + 1. / 32768);
            before = most;
        }
        assert_true(before < (nearest ? .005 : .0001));
    }
}

static int begin(void **state)
{
    (void)state;
    parts_begin();
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_own_reciprocal_is_the_renderers),
        cmocka_unit_test(the_own_root_is_the_renderers),
        cmocka_unit_test(the_own_power_is_the_renderers),
        cmocka_unit_test(every_term_of_a_series_is_worth_five_bits),
        cmocka_unit_test(twice_the_steps_are_never_worse),
    };
    return cmocka_run_group_tests(tests, begin, NULL);
}

/* SPDX-License-Identifier: MIT */
#include "tests/exhaustive/fixed_truth.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

#include <cmocka.h>

FX_WRAPS static uint32_t random_bits(void)
{
    static uint32_t x = 2463534242u;
    x ^= x << 13;
    x ^= x >> 17;
    return x ^= x << 5;
}

/* Values at which carries and signs turn over. */
static const uint32_t corner[] = {0u,          1u,          2u,          0x7fffu,     0x8000u,     0xffffu,
                                  0x10000u,    0x10001u,    0x7fff7fffu, 0x7fffffffu, 0x80000000u, 0x80000001u,
                                  0xffff0000u, 0xffff8000u, 0xfffffffeu, 0xffffffffu};
#define CORNERS (sizeof corner / sizeof *corner)

static void constants_round_to_nearest(void **state)
{
    (void)state;
    assert_int_equal(Q14(1, 1), 16384);
    assert_int_equal(Q16(1, 3), 21845);
    assert_int_equal(Q16(2, 3), 43691);
    assert_int_equal(Q16(-2, 3), -43691);
    assert_int_equal(Q15(1, 65536), 1);
    assert_int_equal(Q15(-1, 65536), -1);
    assert_int_equal(Q22(255, 1), 255 << 22);
    assert_int_equal(Q30(-2, 1), INT32_MIN);
}

static void check_products(uint32_t a, uint32_t b)
{
    uint32_t u = (uint32_t)((uint64_t)a * b >> 32);
    int32_t s = (int32_t)((int64_t)(int32_t)a * (int32_t)b >> 32);
    assert_int_equal(fx_mulhi_u32(a, b), u);
    assert_int_equal(fx_mulhi_u32_narrow(a, b), u);
    assert_int_equal(fx_mulhi_s32((int32_t)a, (int32_t)b), s);
    assert_int_equal(fx_mulhi_s32_narrow((int32_t)a, (int32_t)b), s);
}

static void the_high_word_is_that_of_the_64_bit_product(void **state)
{
    (void)state;
    for (size_t i = 0; i < CORNERS; i++)
        for (size_t j = 0; j < CORNERS; j++)
            check_products(corner[i], corner[j]);
    for (int i = 0; i < 1000000; i++) {
        uint32_t a = random_bits(), b = random_bits();
        check_products(a, b);
        check_products(a >> (b & 31), b);
    }
}

static void leading_zeros_are_counted_at_every_length(void **state)
{
    (void)state;
    for (unsigned n = 0; n < 32; n++) {
        uint32_t top = 0x80000000u >> n, fill = top | (top - 1), some = top | ((top - 1) & random_bits());
        assert_int_equal(fx_clz(top), n);
        assert_int_equal(fx_clz(fill), n);
        assert_int_equal(fx_clz(some), n);
        assert_int_equal(fx_clz_narrow(top), n);
        assert_int_equal(fx_clz_narrow(fill), n);
        assert_int_equal(fx_clz_narrow(some), n);
    }
}

static void check_division(int32_t num, int32_t den)
{
    int32_t q, r, nq, nr;
    fx_divmod_floor(num, den, &q, &r);
    fx_divmod_floor_narrow(num, den, &nq, &nr);
    assert_true(r >= 0 && r < den);
    assert_true((int64_t)q * den + r == num);
    assert_int_equal(nq, q);
    assert_int_equal(nr, r);
}

static void floor_division_leaves_a_remainder_below_the_divisor(void **state)
{
    (void)state;
    const int32_t most = (1 << 30) - 1, widest = 1 << 19;
    for (int32_t num = -300; num <= 300; num++)
        for (int32_t den = 1; den <= 64; den++)
            check_division(num, den);
    for (int32_t i = 0; i < 64; i++)
        for (int32_t j = 0; j < 64; j++) {
            check_division(most - i, widest - j);
            check_division(i - most, widest - j);
            check_division(most - i, 1 + j);
            check_division(i - most, 1 + j);
        }
    for (int i = 0; i < 1000000; i++) {
        uint32_t bits = random_bits();
        int32_t num = (int32_t)random_bits() / 2 / (1 << (bits & 15));
        check_division(num == -most - 1 ? 0 : num, 1 + (int32_t)((bits >> 13) >> (bits >> 4 & 15)));
    }
}

static double worst(double (*error)(uint32_t), uint64_t first, uint64_t end, unsigned step)
{
    double most = 0;
    for (uint64_t i = first; i < end; i += 1 + random_bits() % step)
        most = fmax(most, fabs(error((uint32_t)i)));
    return fmax(most, fabs(error((uint32_t)(end - 1))));
}

static void reciprocals_keep_their_documented_error(void **state)
{
    (void)state;
    assert_int_equal(fx_recip_norm(0x80000000u), 0xffffffffu);
    assert_true(worst(truth_recip, 1ull << 31, (1ull << 31) + 100000, 1) <= TRUTH_RECIP_BOUND);
    assert_true(worst(truth_recip, (1ull << 32) - 100000, 1ull << 32, 1) <= TRUTH_RECIP_BOUND);
    assert_true(worst(truth_recip, 1ull << 31, 1ull << 32, 200) <= TRUTH_RECIP_BOUND);
}

static void reciprocal_roots_keep_their_documented_error(void **state)
{
    (void)state;
    assert_true(worst(truth_rsqrt, 1ull << 30, (1ull << 30) + 100000, 1) <= TRUTH_RSQRT_BOUND);
    assert_true(worst(truth_rsqrt, (1ull << 32) - 100000, 1ull << 32, 1) <= TRUTH_RSQRT_BOUND);
    assert_true(worst(truth_rsqrt, 1ull << 30, 1ull << 32, 300) <= TRUTH_RSQRT_BOUND);
}

static void sines_keep_their_documented_error(void **state)
{
    (void)state;
    assert_true(worst(truth_sin, 0, 1ull << 32, 500) <= TRUTH_SIN_BOUND);
}

static void quarter_turns_are_exact(void **state)
{
    (void)state;
    const q30_t one = (q30_t)1 << 30, sine[] = {0, one, 0, -one};
    for (unsigned quarter = 0; quarter < 4; quarter++) {
        assert_int_equal(fx_sin(quarter << 30), sine[quarter]);
        assert_int_equal(fx_cos(quarter << 30), sine[(quarter + 1) & 3]);
    }
}

/* FNV-1a over a function's values: within its error there are others, but each machine is to have these. */
static uint32_t bits_of(uint32_t (*function)(uint32_t), uint32_t first)
{
    uint64_t hash = 14695981039346656037u;
    for (uint64_t x = first; x < 1ull << 32; x += 1021)
        hash = (hash ^ function((uint32_t)x)) * 1099511628211u;
    return (uint32_t)(hash >> 32);
}

static uint32_t sine_bits(uint32_t turn)
{
    return (uint32_t)fx_sin(turn);
}

static uint32_t exponential_bits(uint32_t x)
{
    return fx_exp2_minus(x >> 11);
}

static void the_values_have_the_bits_of_every_machine(void **state)
{
    (void)state;
    assert_int_equal(bits_of(fx_recip_norm, 1u << 31), 0x85852c48u);
    assert_int_equal(bits_of(fx_rsqrt_norm, 1u << 30), 0x6f9ce2a5u);
    assert_int_equal(bits_of(sine_bits, 0), 0x5aef8cf4u);
    assert_int_equal(bits_of(exponential_bits, 0), 0x49758556u);
}

static void every_power_table_is_rounded_to_nearest(void **state)
{
    (void)state;
    for (unsigned n = 1; n <= FX_POWER_MAX_EXPONENT; n++) {
        struct fx_power table;
        fx_power_build(&table, n);
        assert_int_equal(table.exponent, n);
        assert_true(table.octave <= FX_POWER_MAX_OCTAVE);
        assert_true(powl(1 - ldexpl(1, -table.octave), n) < 0x1p-9L);
        assert_false(powl(1 - ldexpl(1, -table.octave - 1), n) < 0x1p-9L);
        for (unsigned i = 0; i <= FX_POWER_STEPS; i++) {
            long double s = 1 - ldexpl(FX_POWER_STEPS - i, -7 - table.octave);
            assert_int_equal(table.value[i], floorl(32768 * powl(s, n) + .5L));
        }
        assert_int_equal(table.value[FX_POWER_STEPS], 32768);
        assert_int_equal(table.value[FX_POWER_STEPS + 1], 32768);
    }
}

static void powers_keep_their_documented_error_and_never_fall(void **state)
{
    (void)state;
    const q30_t one = (q30_t)1 << 30;
    for (unsigned n = 1; n <= FX_POWER_MAX_EXPONENT; n++) {
        struct fx_power table;
        fx_power_build(&table, n);
        q30_t start = one - (one >> table.octave), stride = one >> table.octave >> 10;
        uint32_t last = 0;
        for (unsigned i = 0; i < 1024; i++) {
            q30_t s = start + (q30_t)i * stride + (q30_t)(random_bits() % (unsigned)stride);
            assert_true(fabs(truth_power(&table, s)) <= TRUTH_POWER_INSIDE);
            assert_true(fx_power(&table, s) >= last);
            last = fx_power(&table, s);
            q30_t below = (q30_t)(random_bits() >> 2);
            assert_true(below >= start ||
                        (fx_power(&table, below) == 0 && truth_power(&table, below) > -TRUTH_POWER_BOUND));
        }
        assert_true(start == 0 || fabs(truth_power(&table, start - 1)) < TRUTH_POWER_BOUND);
    }
}

static void powers_are_0_below_and_1_above_the_unit_range(void **state)
{
    (void)state;
    const q30_t one = (q30_t)1 << 30;
    for (unsigned n = 1; n <= FX_POWER_MAX_EXPONENT; n++) {
        struct fx_power table;
        fx_power_build(&table, n);
        assert_int_equal(fx_power(&table, INT32_MIN), 0);
        assert_int_equal(fx_power(&table, -one - 1), 0);
        assert_int_equal(fx_power(&table, -1), 0);
        assert_int_equal(fx_power(&table, 0), 0);
        assert_in_range(fx_power(&table, one - 1), 32767, 32768);
        assert_int_equal(fx_power(&table, one), 32768);
        assert_int_equal(fx_power(&table, one + 1), 32768);
        assert_int_equal(fx_power(&table, INT32_MAX), 32768);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants_round_to_nearest),
        cmocka_unit_test(the_high_word_is_that_of_the_64_bit_product),
        cmocka_unit_test(leading_zeros_are_counted_at_every_length),
        cmocka_unit_test(floor_division_leaves_a_remainder_below_the_divisor),
        cmocka_unit_test(reciprocals_keep_their_documented_error),
        cmocka_unit_test(reciprocal_roots_keep_their_documented_error),
        cmocka_unit_test(sines_keep_their_documented_error),
        cmocka_unit_test(quarter_turns_are_exact),
        cmocka_unit_test(the_values_have_the_bits_of_every_machine),
        cmocka_unit_test(every_power_table_is_rounded_to_nearest),
        cmocka_unit_test(powers_keep_their_documented_error_and_never_fall),
        cmocka_unit_test(powers_are_0_below_and_1_above_the_unit_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* The checked build's operations, compiled so whatever build this is: each kind of trap fires beyond its range, and not
 * at its ends. */
#ifndef GLINT_CHECKED
#define GLINT_CHECKED
#endif
#include "fixed/divide.c"
#include "fixed/exponential.c"
#include "fixed/fixed.c"
#include "fixed/power.c"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

static jmp_buf trapped;
static struct {
    const char *file, *broken;
    int line, count;
    int64_t a, b;
} told;

void fx_trap(const char *file, int line, const char *broken, int64_t a, int64_t b)
{
    told.file = file;
    told.line = line;
    told.broken = broken;
    told.a = a;
    told.b = b;
    told.count++;
    longjmp(trapped, 1);
}

static volatile int64_t sink; /* so that no compiler leaves out what is only to trap */

/* Whether `expression` traps. */
#define TRAPS(expression)                 \
    (__extension__({                      \
        const int before = told.count;    \
        if (!setjmp(trapped))             \
            sink = (int64_t)(expression); \
        told.count != before;             \
    }))

#define HOLDS(name, least, most)         \
    do {                                 \
        volatile int64_t x = (least);    \
        assert_false(TRAPS(name(x)));    \
        assert_true(name(x) == (least)); \
        x = (int64_t)(least)-1;          \
        assert_true(TRAPS(name(x)));     \
        assert_true(told.a == x);        \
        x = (most);                      \
        assert_false(TRAPS(name(x)));    \
        assert_true(name(x) == (most));  \
        x = (int64_t)(most) + 1;         \
        assert_true(TRAPS(name(x)));     \
        assert_true(told.a == x);        \
    } while (0)

static void a_value_that_does_not_fit_traps_at_either_end(void **state)
{
    (void)state;
    HOLDS(fx_s8, INT8_MIN, INT8_MAX);
    HOLDS(fx_u8, 0, UINT8_MAX);
    HOLDS(fx_s16, INT16_MIN, INT16_MAX);
    HOLDS(fx_u16, 0, UINT16_MAX);
    HOLDS(fx_s32, INT32_MIN, INT32_MAX);
    HOLDS(fx_u32, 0, UINT32_MAX);
}

static void the_sign_of_64_bits_traps_too(void **state)
{
    (void)state;
    int64_t x = 0;
    volatile uint64_t u = INT64_MAX;
    assert_false(TRAPS(fx_u64(x)));
    x = -1;
    assert_true(TRAPS(fx_u64(x)));
    assert_false(TRAPS(fx_s64(x)));
    assert_false(TRAPS(fx_s64(u)));
    u++;
    assert_true(TRAPS(fx_s64(u)));
    assert_false(TRAPS(fx_u64(u)));
    u = UINT64_MAX;
    assert_true(TRAPS(fx_s32(u))); /* which would be -1 */
}

static void a_trap_tells_place_reason_and_value(void **state)
{
    (void)state;
    const int32_t wide = 40000;
    assert_true(TRAPS(fx_s16(wide))), assert_int_equal(told.line, __LINE__);
    assert_non_null(strstr(told.file, "test_checked.c"));
    assert_string_equal(told.broken, "int16_t holds wide");
    assert_true(told.a == 40000);
}

static void a_value_is_computed_once(void **state)
{
    (void)state;
    int count = 0;
    assert_int_equal(fx_u8(++count), 1);
    assert_int_equal(fx_wrap_u8(++count), 2);
    assert_int_equal(count, 2);
}

static void a_left_shift_that_loses_bits_traps(void **state)
{
    (void)state;
    assert_int_equal(fx_shl(-3, 4), -48);
    assert_true(fx_shl(-1, 31) == INT32_MIN);
    assert_false(TRAPS(fx_shl(0x3fffffff, 1)));
    assert_true(TRAPS(fx_shl(0x40000000, 1)));
    assert_true(TRAPS(fx_shl(-0x40000001, 1)));
    assert_true(TRAPS(fx_shl(1, 31)));
    assert_true(TRAPS(fx_shl(0, 32)));
}

static void marked_steps_wrap_and_never_trap(void **state)
{
    (void)state;
    uint32_t x = 0xffffffffu;
    uint64_t y = UINT64_MAX;
    assert_int_equal(fx_wrap_add(x, 2u), 1);
    assert_int_equal(fx_wrap_sub(0u, x), 1);
    assert_int_equal(fx_wrap_mul(x, x), 1);
    assert_int_equal(fx_wrap_shl(x, 31), 0x80000000u);
    fx_wrap_inc(&x, 3);
    assert_int_equal(x, 2);
    assert_true(fx_wrap_add(y, 2u) == 1 && fx_wrap_mul(y, y) == 1 && fx_wrap_shl(y, 63) == UINT64_C(1) << 63);
    assert_int_equal(fx_wrap_s16(40000), 40000 - 65536);
    assert_int_equal(fx_wrap_u8(-1), 255);
    assert_true(fx_within(-7, 7) && fx_within(7, 7) && !fx_within(8, 7) && !fx_within(-8, 7));
    assert_true(!fx_within(INT32_MIN, INT32_MAX) && fx_within(-INT32_MAX, INT32_MAX));
}

static void reciprocals_trap_below_their_range(void **state)
{
    (void)state;
    assert_false(TRAPS(fx_recip_norm(0x80000000u)));
    assert_true(TRAPS(fx_recip_norm(0x7fffffffu)));
    assert_false(TRAPS(fx_rsqrt_norm(0x40000000u)));
    assert_true(TRAPS(fx_rsqrt_norm(0x3fffffffu)));
    assert_false(TRAPS(fx_clz(1)));
    assert_true(TRAPS(fx_clz(0)));
}

static int64_t quotient(int32_t num, int32_t den)
{
    int32_t q, r;
    fx_divmod_floor(num, den, &q, &r);
    return q;
}

static int64_t quotient_narrow(int32_t num, int32_t den)
{
    int32_t q, r;
    fx_divmod_floor_narrow(num, den, &q, &r);
    return q;
}

static void divisions_trap_outside_their_ranges(void **state)
{
    (void)state;
    const int32_t most = (1 << 30) + (1 << 19);
    static int64_t (*const form[])(int32_t, int32_t) = {quotient, quotient_narrow};
    for (volatile int i = 0; i < 2; i++) {
        assert_false(TRAPS(form[i](most, 1)));
        assert_false(TRAPS(form[i](-most, 1 << 30)));
        assert_true(TRAPS(form[i](most + 1, 1)));
        assert_true(TRAPS(form[i](-most - 1, 1)));
        assert_true(TRAPS(form[i](1, 0)));
        assert_true(TRAPS(form[i](1, (1 << 30) + 1)));
    }
    assert_false(TRAPS(fx_divide_u64(UINT64_MAX, UINT64_MAX)));
    assert_true(TRAPS(fx_divide_u64(1, 0)));
    assert_false(TRAPS(fx_divide_s64(-INT64_MAX, -INT64_MAX)));
    assert_true(TRAPS(fx_divide_s64(INT64_MIN, 1)));
    assert_true(TRAPS(fx_divide_s64(1, INT64_MIN)));
    assert_true(TRAPS(fx_divide_s64(1, 0)));
}

static void clamps_trap_on_shifts_beyond_the_word(void **state)
{
    (void)state;
    unsigned bits = 22, down = 9;
    assert_false(TRAPS(fx_saturated(1, bits, down)));
    assert_true(TRAPS(fx_saturated(1, bits, down + 1)));
    assert_true(TRAPS(fx_saturated(1, 0 * bits, down)));
}

static int64_t build(struct fx_power *table, unsigned n)
{
    fx_power_build(table, n);
    return table->octave;
}

static void powers_trap_outside_their_exponents(void **state)
{
    (void)state;
    struct fx_power table;
    assert_true(TRAPS(build(&table, 0)));
    assert_true(TRAPS(build(&table, FX_POWER_MAX_EXPONENT + 1)));
    assert_true(TRAPS(fx_power_exact(0, 1 << 29)));
    assert_true(TRAPS(fx_power_exact(FX_POWER_MAX_EXPONENT + 1, 1 << 29)));
    assert_false(TRAPS(fx_power_exact(FX_POWER_MAX_EXPONENT, 1 << 29)));
    assert_false(TRAPS(build(&table, FX_POWER_MAX_EXPONENT)));
    assert_false(TRAPS(fx_power(&table, 1 << 29)));
    table.octave = FX_POWER_MAX_OCTAVE + 1;
    assert_true(TRAPS(fx_power(&table, 1 << 29)));
}

/* What no macro sees: the compiler's own traps, where this build has them. */
#if defined(__has_feature)
#if __has_feature(undefined_behavior_sanitizer)
#define SANITIZED 1
#endif
#endif
#ifndef SANITIZED
#define SANITIZED 0
#endif

static volatile uint32_t top = 0xffffffffu;
static volatile int32_t large = INT32_MAX / 2 + 1;
static void wrap(void)
{
    top = top + 1;
}
static void shift_out(void)
{
    top = top << 1;
}
static void convert(void)
{
    const uint16_t half = top;
    sink = half;
}
static void change_sign(void)
{
    const int32_t minus = top;
    sink = minus;
}
static void overflow(void)
{
    sink = large * (SANITIZED ? 2 : 1); /* undefined: not for a compiler that does not trap it */
}
static void wrap_marked(void)
{
    top = fx_wrap_add(top, 1);
}

static int dies(void (*work)(void))
{
    const pid_t child = fork();
    if (!child) {
        close(STDERR_FILENO);
        work();
        _exit(0);
    }
    int status = 0;
    assert_true(waitpid(child, &status, 0) == child);
    return status != 0;
}

static void unmarked_losses_end_a_sanitized_program(void **state)
{
    (void)state;
    assert_int_equal(dies(wrap), SANITIZED);
    assert_int_equal(dies(shift_out), SANITIZED);
    assert_int_equal(dies(convert), SANITIZED);
    assert_int_equal(dies(change_sign), SANITIZED);
    assert_int_equal(dies(overflow), SANITIZED);
    assert_int_equal(dies(wrap_marked), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_value_that_does_not_fit_traps_at_either_end),
        cmocka_unit_test(the_sign_of_64_bits_traps_too),
        cmocka_unit_test(a_trap_tells_place_reason_and_value),
        cmocka_unit_test(a_value_is_computed_once),
        cmocka_unit_test(a_left_shift_that_loses_bits_traps),
        cmocka_unit_test(marked_steps_wrap_and_never_trap),
        cmocka_unit_test(reciprocals_trap_below_their_range),
        cmocka_unit_test(divisions_trap_outside_their_ranges),
        cmocka_unit_test(clamps_trap_on_shifts_beyond_the_word),
        cmocka_unit_test(powers_trap_outside_their_exponents),
        cmocka_unit_test(unmarked_losses_end_a_sanitized_program),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

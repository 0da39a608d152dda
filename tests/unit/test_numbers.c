/* SPDX-License-Identifier: MIT */
/* Numbers of command lines: what is one, and what only looks like one. */
#include "host/numbers.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>
#include <stdio.h>

static void whole_numbers_are_read_within_their_range(void **state)
{
    static const uint32_t edges[] = {0, 1, 9, 10, 255, 65535, 65536, 4294967294u, 4294967295u};
    (void)state;
    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) {
        uint32_t value = 77, edge = edges[i];
        char text[16];
        snprintf(text, sizeof text, "%u", (unsigned)edge);
        assert_true(numbers_whole(text, edge, edge, &value));
        assert_int_equal(value, edge);
        value = 77;
        assert_true(edge == UINT32_MAX || !numbers_whole(text, edge + 1, UINT32_MAX, &value));
        assert_true(edge == 0 || !numbers_whole(text, 0, edge - 1, &value));
        assert_int_equal(value, 77);
    }
}

static void what_is_no_number_changes_nothing(void **state)
{
    static const char *const texts[] = {
        "", "-1", "+1", " 1", "1 ", "1.0", "0x10", "1e3", "one", "1\n", "/", "4294967296", "18446744073709551616"};
    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        uint32_t value = 77;
        assert_false(numbers_whole(texts[i], 0, UINT32_MAX, &value));
        assert_int_equal(value, 77);
    }
}

static void digits_end_where_something_else_begins(void **state)
{
    uint32_t value = 0;
    const char text[] = "007kHz";
    (void)state;
    assert_ptr_equal(numbers_digits(text, &value), text + 3);
    assert_int_equal(value, 7);
    assert_null(numbers_digits(text + 3, &value));
}

static void a_size_is_two_numbers(void **state)
{
    static const char *const texts[] = {"",      "3",     "3x",    "x2",   "0x2", "3x0",         "3x2x1",
                                        "321x2", "3x321", "3 x 2", "3x-2", "3X2", "4294967299x2"};
    uint16_t width = 7, height = 8;
    (void)state;
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        assert_false(numbers_size(texts[i], 320, &width, &height));
    assert_int_equal(width, 7);
    assert_int_equal(height, 8);
    assert_true(numbers_size("320x1", 320, &width, &height));
    assert_int_equal(width, 320);
    assert_int_equal(height, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_numbers_are_read_within_their_range),
        cmocka_unit_test(what_is_no_number_changes_nothing),
        cmocka_unit_test(digits_end_where_something_else_begins),
        cmocka_unit_test(a_size_is_two_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

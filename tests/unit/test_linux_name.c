/* SPDX-License-Identifier: MIT */
/* The serial number that a USB host is told, from what a machine has. */
#include "boards/linux/name.h"
#include "linux/files.h"

#include <errno.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

static const char *tree, *machine; /* files, or null */

int files_get(const char *path, char *text, size_t size)
{
    const char *file = strstr(path, "devicetree") ? tree : strcmp(path, "/etc/machine-id") == 0 ? machine : NULL;
    snprintf(text, size, "%s", file ? file : "");
    return file ? 0 : -ENOENT;
}

static const char *serial(void)
{
    static char text[64];
    name_serial(text, sizeof text);
    return text;
}

static void a_pi_has_one(void **state)
{
    (void)state;
    tree = "00000000a1b2c3d4";
    machine = "0123456789abcdef0123456789abcdef";
    assert_string_equal(serial(), "00000000a1b2c3d4");
}

static void elsewhere_it_is_a_sum_of_the_installation_s_id(void **state)
{
    char first[64];
    (void)state;
    tree = NULL;
    machine = "0123456789abcdef0123456789abcdef";
    strcpy(first, serial());
    assert_int_equal(strspn(first, "0123456789abcdef"), 8);
    assert_null(strstr(machine, first)); /* the id itself is not to be told */
    assert_string_equal(serial(), first);
    machine = "1123456789abcdef0123456789abcdef";
    assert_string_not_equal(serial(), first);
}

static void where_there_is_none_it_is_0(void **state)
{
    (void)state;
    tree = machine = NULL;
    assert_string_equal(serial(), "0");
    tree = machine = ""; /* not yet set up */
    assert_string_equal(serial(), "0");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pi_has_one),
        cmocka_unit_test(elsewhere_it_is_a_sum_of_the_installation_s_id),
        cmocka_unit_test(where_there_is_none_it_is_0),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

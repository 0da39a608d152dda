/* SPDX-License-Identifier: MIT */
/* The renderer's functions of one number over whole domains, as far as that takes less than 2 seconds; the rest is
 * `make test-exhaustive`. */
#include "tests/exhaustive/unary.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static void no_argument_passes_the_bound(void **state)
{
    const struct sweep *sweep = *state;
    assert_int_equal(sweep_run(sweep, sweep->quick), 0);
}

int main(void)
{
    struct CMUnitTest tests[UNARY_SWEEPS];
    char name[UNARY_SWEEPS][64];
    size_t count = 0;
    for (size_t i = 0; i < UNARY_SWEEPS; i++)
        if (unary_sweeps[i].quick) {
            snprintf(name[count], sizeof name[count], "no_argument_passes_the_bound_of %s", unary_sweeps[i].name);
            tests[count] =
                (struct CMUnitTest)cmocka_unit_test_prestate(no_argument_passes_the_bound, (void *)&unary_sweeps[i]);
            tests[count].name = name[count];
            count++;
        }
    return _cmocka_run_group_tests("exhausted", tests, count, NULL, NULL);
}

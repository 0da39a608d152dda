/* SPDX-License-Identifier: MIT */
/* What a plan promises of a triangle holds: random triangles, materials, lights and budgets (plan_case.h). */
#include "plan_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static const double widest[] = {20, 45, 90, 170}; /* degrees between normals */

static const char *const rung_names[PLAN_RUNGS] = {"dark", "constant", "gouraud", "linear", "six", "duff", "phong"};

static struct plan_case_counts run(double share)
{
    struct plan_case_counts counts = {0};
    random_seed(7);
    for (size_t i = 0; i < sizeof widest / sizeof *widest; i++)
        plan_case_run(&counts, widest[i], 25000, 12, share);
    return counts;
}

static void no_pixel_is_off_by_more_than_its_plan_says(void **state)
{
    (void)state;
    const struct plan_case_counts counts = run(1);
    for (int r = 0; r < PLAN_PHONG; r++) {
        print_message("%-8s %6lu planned, %lu beyond; the worst error is %.2f of its bound\n", rung_names[r],
                      counts.planned[r], counts.beyond[r], counts.closest[r]);
        assert_true(counts.planned[r] > 100);
        assert_int_equal(counts.beyond[r], 0);
    }
}

/* The same triangles would find a bound that is wrong by a tenth. */
static void smaller_bounds_would_be_seen_to_fail(void **state)
{
    (void)state;
    const struct plan_case_counts counts = run(.9);
    for (int r = PLAN_CONSTANT; r <= PLAN_SIX; r++)
        assert_true(counts.beyond_most[r] > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pixel_is_off_by_more_than_its_plan_says),
        cmocka_unit_test(smaller_bounds_would_be_seen_to_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

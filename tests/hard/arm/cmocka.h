/* SPDX-License-Identifier: MIT */
/* Of cmocka, what test_pictures.c takes, for a machine that has no such library: the first failure ends the program. */
#ifndef HARD_CMOCKA_H
#define HARD_CMOCKA_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define fail_msg(...) (printf("FAIL %s:%d: ", __FILE__, __LINE__), printf(__VA_ARGS__), printf("\n"), exit(1))
#define assert_true(x)                 \
    do {                               \
        if (!(x))                      \
            fail_msg("%s", "not " #x); \
    } while (0)
#define assert_int_equal(a, b)       assert_true((intmax_t)(a) == (intmax_t)(b))
#define assert_non_null(p)           assert_true((p) != NULL)
#define assert_memory_equal(a, b, n) assert_true(memcmp(a, b, n) == 0)
#define print_message                printf

struct CMUnitTest {
    const char *name;
    void (*run)(void **state);
};
#define cmocka_unit_test(test) \
    {                          \
#test, test            \
    }
#define cmocka_run_group_tests(tests, up, down) cmocka_run(tests, sizeof tests / sizeof *tests)

static inline int cmocka_run(const struct CMUnitTest *tests, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        tests[i].run(NULL);
        printf("ok %s\n", tests[i].name);
        fflush(stdout);
    }
    return 0;
}

#endif

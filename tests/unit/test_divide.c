/* SPDX-License-Identifier: MIT */
/* Divisions in software, the renderer's of 64 bits and the boards' of 32, against the desktop's. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "cortexm/divide.c"
#include "fixed/fixed.h"
#include "random.h"

/* What libgcc has on a board. */
uint64_t __aeabi_uidivmod(uint32_t n, uint32_t d)
{
    return (uint64_t)(n % d) << 32 | n / d;
}

enum { ROUNDS = 200000 };

static const int64_t edges[] = {
    0, 1, 2, 3, 1000, INT32_MAX, 1ll << 31, 1ll << 32, 1ll << 61, 1ll << 62, INT64_MAX - 1, INT64_MAX, UINT32_MAX};
enum { EDGES = sizeof edges / sizeof *edges };

static void check_64(int64_t n, int64_t d)
{
    assert_true(fx_divide_s64(n, d) == n / d);
    assert_true(fx_divide_s64(-n, d) == -n / d);
    assert_true(fx_divide_s64(n, -d) == n / -d);
    assert_true(fx_divide_s64(-n, -d) == -n / -d);
    assert_true(fx_divide_u64((uint64_t)n * 2 + 1, (uint64_t)d) == ((uint64_t)n * 2 + 1) / (uint64_t)d);
}

static void check_32(uint32_t n, uint32_t d)
{
    if (n == 1u << 31 && d == UINT32_MAX)
        return; /* overflows */
    const uint64_t both = __aeabi_idivmod((int32_t)n, (int32_t)d);
    assert_int_equal((int32_t)(uint32_t)both, (int32_t)n / (int32_t)d);
    assert_int_equal((int32_t)(uint32_t)(both >> 32), (int32_t)n % (int32_t)d);
    assert_int_equal((int32_t)(uint32_t)__aeabi_idiv((int32_t)n, (int32_t)d), (int32_t)n / (int32_t)d);
}

static void edges_divide_as_by_the_operator(void **state)
{
    (void)state;
    for (int i = 0; i < EDGES; i++)
        for (int j = 1; j < EDGES; j++) {
            check_64(edges[i], edges[j]);
            if ((uint32_t)edges[j]) {
                check_32((uint32_t)edges[i], (uint32_t)edges[j]);
                check_32(0u - (uint32_t)edges[i], (uint32_t)edges[j]);
                check_32((uint32_t)edges[i], 0u - (uint32_t)edges[j]);
            }
        }
}

static void numbers_of_every_size_divide_as_by_the_operator(void **state)
{
    (void)state;
    random_seed(1);
    for (int i = 0; i < ROUNDS; i++) {
        const unsigned down_n = (unsigned)random_between(0, 62), down_d = (unsigned)random_between(0, 61);
        const uint64_t n = (uint64_t)random_bits() << 32 | random_bits(),
                       d = (uint64_t)random_bits() << 32 | random_bits();
        check_64((int64_t)(n >> 1 >> down_n), (int64_t)(d >> 1 >> down_d | 1));
        check_32((uint32_t)n >> down_n / 2, (uint32_t)d >> down_d / 2 | 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges_divide_as_by_the_operator),
        cmocka_unit_test(numbers_of_every_size_divide_as_by_the_operator),
    };
    return cmocka_run_group_tests(tests, 0, 0);
}

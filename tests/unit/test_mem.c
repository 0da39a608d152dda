/* SPDX-License-Identifier: MIT */
/* The boards' mem*, taken in under other names, against the desktop's. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

#define memcpy  device_memcpy
#define memmove device_memmove
#define memset  device_memset
#define memcmp  device_memcmp
#include "cortexm/mem.c"
#undef memcpy
#undef memmove
#undef memset
#undef memcmp

enum { ROOM = 48, MOST = 17 };

static void fill(unsigned char *bytes)
{
    for (int i = 0; i < ROOM; i++)
        bytes[i] = (unsigned char)(i * 37 + 11);
}

/* Every alignment of both ends and every distance, either way, up to memory that does not overlap. */
static void memory_moves_over_itself(void **state)
{
    _Alignas(8) unsigned char ours[ROOM], theirs[ROOM];
    (void)state;
    for (size_t to = 0; to < ROOM - MOST; to++)
        for (size_t from = 0; from < ROOM - MOST; from++)
            for (size_t size = 0; size <= MOST; size++) {
                fill(ours);
                fill(theirs);
                assert_ptr_equal(device_memmove(ours + to, ours + from, size), ours + to);
                memmove(theirs + to, theirs + from, size);
                assert_memory_equal(ours, theirs, ROOM);
            }
}

static void memory_is_copied_set_and_compared_at_every_alignment(void **state)
{
    _Alignas(8) unsigned char source[ROOM], ours[ROOM], theirs[ROOM];
    (void)state;
    fill(source);
    for (size_t to = 0; to < 8; to++)
        for (size_t from = 0; from < 8; from++)
            for (size_t size = 0; size <= MOST; size++) {
                memset(theirs, 0, ROOM);
                device_memset(ours, 0x100, ROOM);
                assert_ptr_equal(device_memcpy(ours + to, source + from, size), ours + to);
                memcpy(theirs + to, source + from, size);
                assert_memory_equal(ours, theirs, ROOM);
                assert_int_equal(device_memcmp(ours + to, source + from, size), 0);
                ours[to + size] = 9, theirs[to + size] = 200;
                assert_int_equal(device_memcmp(ours + to, theirs + to, size + 1), -1);
                assert_int_equal(device_memcmp(theirs + to, ours + to, size + 1), 1);
                device_memset(ours + to, 0x1A5, size);
                memset(theirs + to, 0xA5, size);
                theirs[to + size] = 9;
                assert_memory_equal(ours, theirs, ROOM);
            }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_moves_over_itself),
        cmocka_unit_test(memory_is_copied_set_and_compared_at_every_alignment),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

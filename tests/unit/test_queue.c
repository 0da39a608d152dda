/* SPDX-License-Identifier: MIT */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "random.h"
#include "view/queue.h"

static void bytes_leave_in_the_order_they_came(void **state)
{
    (void)state;
    random_seed(5);
    for (uint32_t room = 1; room < 40; room++) {
        uint8_t bytes[40], piece[64];
        size_t put = 0, taken = 0;
        struct queue queue = {.bytes = bytes, .room = room};
        bytes[room] = 99;
        for (int i = 0; i < 400; i++) {
            size_t held = put - taken, count = random_bits() % (queue_free(&queue) + 1);
            assert_int_equal(queue_free(&queue), room - held);
            for (size_t k = 0; k < count; k++)
                piece[k] = (uint8_t)(put++ & 255);
            queue_put(&queue, piece, count);
            held += count;
            size_t size = random_bits() % sizeof piece, got = queue_take(&queue, piece, size);
            assert_int_equal(got, size < held ? size : held);
            for (size_t k = 0; k < got; k++)
                assert_int_equal(piece[k], taken++ & 255);
        }
        assert_int_equal(bytes[room], 99);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bytes_leave_in_the_order_they_came)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

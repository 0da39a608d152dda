/* SPDX-License-Identifier: MIT */
/* glint-view's port to a device on USB while two of libusb's calls fail, through a pull and a stall. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "usb_case.h"

#include "tests/faults/pairs.h"

/* Whether the second device's bytes came. */
static bool run(const struct seam *seam)
{
    struct port port;
    struct reader reader = {0};
    bool good = false;
    case_begin();
    machine.seam = *seam;
    machine.unplugs_at = 30;
    machine.stalls_at = 12;
    machine_plug(0, "A1");
    case_listen();
    if (port_open(&port, "usb:", NULL) == CLI_DONE) {
        port_ask(&port, STREAM_KEY_PLEASE, 0);
        good = reader_run(&reader, &port, 2, 100000);
        port_close(&port);
    }
    case_heard();
    return good;
}

/* Either all bytes come, in their order, or there is one message and an end; and nothing is held. What two looks in a
 * row cannot do is told as well, and mended by the third. */
static void two_calls_that_fail_are_told_or_mended(void **state)
{
    (void)state;
    unsigned told = 0;
    assert_true(run(&(struct seam){0}));
    struct pairs pairs = pairs_of(machine.seam.calls, pairs_most(500));
    case_end();
    for (struct seam next; pairs_next(&pairs, &next);) {
        const bool good = run(&next);
        assert_in_range(case_lines("\n"), good ? 0 : 1, 1);
        told += good && case_told[0];
        case_end();
    }
    assert_in_range(told, 0, 1 + pairs.tried / 500); /* one look alone is not told */
    print_message("%u runs, of which %u told of both\n", pairs.tried, told);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_calls_that_fail_are_told_or_mended)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

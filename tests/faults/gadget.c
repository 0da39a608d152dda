/* SPDX-License-Identifier: MIT */
/* A link to a USB host, opened, used and closed, while two of the calls that make a machine a USB device fail. */
#include "gadget_case.h"

#include "tests/faults/pairs.h"

static int run(void)
{
    int result = open_usb(NULL);
    if (!result) {
        usb_connect();
        if (meet())
            put(1, 1000);
        usb_disconnect();
    }
    usb_stream_close(&usb);
    return result;
}

static void assert_all_closed(void)
{
    for (int i = 0; i <= USB_STOP; i++)
        assert_int_equal(usb_machine.open[i], 0);
}

/* One message if it did not open, nothing open, and the next time nothing is in the way. */
static void two_calls_that_fail_are_told_or_mended(void **state)
{
    (void)state;
    usb_start(got);
    assert_int_equal(run(), 0);
    struct pairs pairs = pairs_of(usb_machine.seam.calls, pairs_most(300));
    for (struct seam next; pairs_next(&pairs, &next);) {
        usb_start(got);
        usb_machine.configfs = 0;
        usb_machine.seam = next;
        int result = run();
        const char *end = strchr(told, '\n');
        if (result ? result != HAL_E_IO || !end || end[1] : told[0])
            fail_msg("calls %d and %d of %lu: result %d, told '%s'", next.fails_at, next.then_at, pairs.calls, result,
                     told);
        assert_all_closed();
        assert_int_equal(open_quiet(NULL), 0);
        assert_string_equal(told, "");
        close_usb(NULL);
    }
    print_message("%u runs\n", pairs.tried);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_calls_that_fail_are_told_or_mended)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

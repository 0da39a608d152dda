/* SPDX-License-Identifier: MIT */
/* glint-device, whole, on a machine two of whose calls fail: GPIO lines, the SPI device, memory of the kernel's. The
 * includer has taken hal/linux/gpio_v1.c or gpio_v2.c in. */
#ifndef LINUX_PAIRS_H
#define LINUX_PAIRS_H

#include "linux_case.h"

#include "tests/faults/pairs.h"

static const struct wiring {
    const char *options;
    enum model_kind kind;
} wirings[] = {{CASE_SPIDEV, MODEL_ST7789}, {CASE_BANGED, MODEL_SSD0323}, {CASE_ILI9341, MODEL_ILI9341}};

static uint16_t good[320 * 240];

/* It ends by itself, with the picture as it should be or with exit code 3; with a message for each fault at the most,
 * and one at the least if there is no picture. Nothing is held, and unless it was just that which failed, the panel is
 * dark and in reset. */
static void two_calls_that_fail_are_told_or_mended(void **state)
{
    (void)state;
    unsigned runs = 0;
    for (size_t w = 0; w < sizeof wirings / sizeof *wirings; w++) {
        machine_start(wirings[w].kind);
        assert_int_equal(case_run(wirings[w].options), 0);
        memcpy(good, machine.seen, sizeof good);
        struct pairs pairs = pairs_of(machine.seam.calls, pairs_most(400));
        for (struct seam next; pairs_next(&pairs, &next);) {
            machine_start(wirings[w].kind);
            machine.seam = next;
            int code = case_run(wirings[w].options), told = case_messages();
            if ((code != 0 && code != 3) || told > 2 || (code == 3 && told < 1))
                fail_msg("wiring %zu, calls %d and %d of %lu: code %d, told '%s'", w, next.fails_at, next.then_at,
                         pairs.calls, code, case_told);
            if (code == 0 && memcmp(machine.seen, good, sizeof good) != 0)
                fail_msg("wiring %zu, calls %d and %d of %lu: another picture", w, next.fails_at, next.then_at,
                         pairs.calls);
            assert_int_equal(machine.taken | machine.chips | machine.descriptors, 0);
            if (machine.levels >> RESET & 1 || machine.levels >> BACKLIGHT & 1)
                fail_msg("wiring %zu, calls %d and %d of %lu: left on", w, next.fails_at, next.then_at, pairs.calls);
        }
        runs += pairs.tried;
    }
    print_message("%u runs\n", runs);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_calls_that_fail_are_told_or_mended)};
    /* the program's serial line: nobody asks for anything */
    return freopen("/dev/null", "r", stdin) ? cmocka_run_group_tests(tests, case_scene, NULL) : 1;
}

#endif

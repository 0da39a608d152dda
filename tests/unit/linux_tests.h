/* SPDX-License-Identifier: MIT */
/* The tests of test_linux_v1.c and test_linux_v2.c: the same over both libgpiods. */
#ifndef LINUX_TESTS_H
#define LINUX_TESTS_H

#include "linux/wires.h"
#include "linux_case.h"

static const struct wiring {
    const char *options;
    enum model_kind kind;
} wirings[] = {{CASE_SPIDEV, MODEL_ST7789}, {CASE_BANGED, MODEL_SSD0323}, {CASE_ILI9341, MODEL_ILI9341}};
#define WIRINGS 3

static uint16_t good[320 * 240];

/* An undisturbed run: the picture, and how many calls it takes. */
static int undisturbed(const struct wiring *wiring)
{
    machine_start(wiring->kind);
    assert_int_equal(case_run(wiring->options), 0);
    assert_string_equal(case_told, "");
    assert_int_equal(machine.panel.faults, 0);
    assert_int_equal(machine.shown, 1);
    assert_all_given_back();
    memcpy(good, machine.seen, sizeof good);
    return machine.seam.calls;
}

/* Every call is tried; of a panel's by GPIO lines, which takes 16 calls a byte, the first, the last, and every 499th:
 * an odd number, so that each half of each bit has its turn. */
static int next_call(const struct wiring *wiring, int call, int calls)
{
    return wiring->kind != MODEL_SSD0323 || call < 120 || call > calls - 60 ? 1 : 499;
}

static void pictures_reach_the_panel_by_spidev_and_by_gpio_lines(void **state)
{
    (void)state;
    for (int w = 0; w < WIRINGS; w++) {
        undisturbed(&wirings[w]);
        unsigned lit = 0;
        for (unsigned i = 0; i < 320 * 240; i++)
            lit += good[i] != 0;
        assert_in_range(lit, 32 * 24 / 5, 32 * 24);
    }
}

/* Whichever call fails, once: the program goes on, or ends with one message; the picture is right in the end. */
static void any_call_that_fails_once_is_told_or_mended(void **state)
{
    (void)state;
    for (int w = 0; w < WIRINGS; w++) {
        int calls = undisturbed(&wirings[w]);
        for (int k = 1; k <= calls; k += next_call(&wirings[w], k, calls)) {
            machine_start(wirings[w].kind);
            machine.seam.fails_at = k;
            int code = case_run(wirings[w].options);
            if (case_messages() > 1 || (code != 0 && (code != 3 || case_messages() != 1)))
                fail_msg("wiring %d, call %d of %d: code %d, told '%s'", w, k, calls, code, case_told);
            assert_all_given_back();
            if (code == 0 && memcmp(machine.seen, good, sizeof good) != 0)
                fail_msg("wiring %d, call %d of %d: another picture", w, k, calls);
        }
    }
}

static void calls_that_fail_from_some_time_on_end_with_one_message(void **state)
{
    (void)state;
    for (int w = 0; w < WIRINGS; w++) {
        int calls = undisturbed(&wirings[w]);
        for (int k = 1; k <= calls; k += next_call(&wirings[w], k, calls)) {
            machine_start(wirings[w].kind);
            machine.seam.fails_at = k;
            machine.seam.fails_on = 1;
            int code = case_run(wirings[w].options);
            if (code != 3 || case_messages() != 1)
                fail_msg("wiring %d, from call %d of %d: code %d, told '%s'", w, k, calls, code, case_told);
            assert_int_equal(machine.taken, 0);
            assert_int_equal(machine.chips, 0);
            assert_int_equal(machine.descriptors, 0);
        }
    }
}

static void pieces_are_as_long_as_the_kernel_takes_them(void **state)
{
    (void)state;
    undisturbed(&wirings[0]);
    assert_in_range(machine.largest, 32 * 6 * 2, MACHINE_BUFSIZ); /* a band in one piece */
    machine_start(MODEL_ST7789);
    machine.limit = 100; /* less than the module says */
    assert_int_equal(case_run(CASE_SPIDEV), 0);
    assert_string_equal(case_told, "");
    assert_in_range(machine.largest, 50, 100);
    assert_memory_equal(machine.seen, good, sizeof good);
}

/* While the wire is held, a band is taken, and its memory is the caller's again. */
static void a_band_is_taken_before_it_is_sent(void **state)
{
    static struct wires wires;
    const struct wires_config config = {.chip = "pinctrl-test", .spi = MACHINE_SPI, .dc = {"dc", 0}, .speed = 1000000};
    uint16_t band[64];
    (void)state;
    machine_start(MODEL_ST7789);
    machine.levels |= 1u << RESET;
    machine.panel.command = 0x2C, machine.panel.format = 5, machine.panel.asleep = 0, machine.panel.on = 1;
    machine.panel.inverted = 1;
    assert_int_equal(wires_open(&wires, &config), 0);
    pthread_mutex_lock(&machine_wire);
    for (int i = 0; i < 64; i++)
        band[i] = (uint16_t)(0x1234 + i);
    assert_int_equal(wires.ops.pixels(&wires.bus, band, 2, 64, 1, 128), 0);
    memset(band, 0, sizeof band);
    assert_int_equal(machine.panel.bytes, 0);
    pthread_mutex_unlock(&machine_wire);
    assert_int_equal(wires.ops.wait(&wires.bus), 0);
    assert_int_equal(machine.panel.bytes, 128);
    for (unsigned i = 0; i < 64; i++)
        assert_int_equal(machine.panel.memory[0][i], 0x1234 + i);
    assert_int_equal(wires_close(&wires), 0);
}

/* Rows apart, longer than both buffers together, and a row again and again: all arrive in order. */
static void rows_of_any_length_and_distance_arrive(void **state)
{
    static struct wires wires;
    static uint16_t pixels[240 * 320];
    const struct wires_config config = {.chip = "pinctrl-test", .spi = MACHINE_SPI, .dc = {"dc", 0}, .speed = 1000000};
    (void)state;
    machine_start(MODEL_ST7789);
    machine.levels |= 1u << RESET;
    machine.panel.command = 0x2C, machine.panel.format = 5;
    assert_int_equal(wires_open(&wires, &config), 0);
    for (unsigned i = 0; i < 240 * 320; i++)
        pixels[i] = (uint16_t)(i * 40503u);
    assert_int_equal(wires.ops.pixels(&wires.bus, pixels, 2, 240, 320, 480), 0);
    assert_int_equal(wires.ops.wait(&wires.bus), 0);
    assert_memory_equal(machine.panel.memory, pixels, sizeof pixels);
    assert_int_equal(wires.ops.pixels(&wires.bus, pixels, 2, 240, 160, 960), 0); /* every other row */
    assert_int_equal(wires.ops.pixels(&wires.bus, pixels, 2, 240, 160, 0), 0);   /* the first */
    assert_int_equal(wires.ops.wait(&wires.bus), 0);
    for (unsigned y = 0; y < 320; y++)
        assert_memory_equal(machine.panel.memory[y], y < 160 ? pixels + 480 * y : pixels, 480);
    assert_int_equal(wires_close(&wires), 0);
}

static void mode_and_speed_are_the_device_s(void **state)
{
    (void)state;
    machine_start(MODEL_ST7789);
    assert_int_equal(case_run(CASE_SPIDEV " --spi-mode 3 --speed 62.5M"), 0);
    assert_int_equal(machine.mode, 3);
    assert_int_equal(machine.speed, 62500000);
}

static void what_is_missing_is_named(void **state)
{
    static const struct {
        const char *options, *told;
    } cases[] = {
        {CASE_SPIDEV " --chip nowhere", "there is no GPIO chip 'nowhere'"},
        {CASE_SPIDEV " --dc nothing", "GPIO chip 'pinctrl-test' has no line 'nothing'"},
        {CASE_SPIDEV " --dc 16", "has no line 16, only 0 to 15"},
        {CASE_SPIDEV " --keys a=nothing", "has no line 'nothing'"},
        {CASE_SPIDEV " --reset 4", "GPIO line 4 is to be two things"},
        {CASE_SPIDEV " --keys a=5", "GPIO line 5 of 'pinctrl-test' is taken by"},
        {CASE_SPIDEV " --spi /dev/spidev9.9", "/dev/spidev9.9: No such file or directory; is SPI on"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        machine_start(MODEL_ST7789);
        assert_int_equal(case_run(cases[i].options), 3);
        assert_tells(cases[i].told);
        assert_all_given_back();
        assert_int_equal(machine.panel.bytes, 0);
    }
}

static void a_chip_of_several_names_is_found_by_any(void **state)
{
    static const char *const names[] = {"pinctrl-test", "gpiochip0", "/dev/gpiochip0", "nowhere,pinctrl-test"};
    char options[1024];
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        machine_start(MODEL_ST7789);
        snprintf(options, sizeof options, CASE_SPIDEV " --chip %s", names[i]);
        assert_int_equal(case_run(options), 0);
    }
}

static void who_has_a_line_is_told(void **state)
{
    (void)state;
    machine_start(MODEL_ST7789);
    machine.holder[RESET] = "spi0 CS0";
    assert_int_equal(case_run(CASE_SPIDEV), 3);
    assert_tells("GPIO line 5 of 'pinctrl-test' is taken by 'spi0 CS0'");
    assert_all_given_back();
}

static void a_right_that_is_missing_is_explained(void **state)
{
    (void)state;
    machine_start(MODEL_ST7789);
    machine.refuses = EACCES;
    assert_int_equal(case_run(CASE_SPIDEV), 3);
    assert_tells("Permission denied; /dev/gpiochip* want root, or the group");
    assert_all_given_back();
    machine_start(MODEL_ST7789);
    machine.seam.fails_at = 1;
    machine.seam.reason = EACCES;
    assert_int_equal(case_run(CASE_SPIDEV), 3);
    assert_tells("/dev/spidev0.0: Permission denied; it wants root, or the group");
    assert_all_given_back();
}

static void a_panel_wired_upside_down_is_dark_the_other_way(void **state)
{
    (void)state;
    machine_start(MODEL_ST7789);
    assert_int_equal(case_run(CASE_SPIDEV " --backlight !light"), 0);
    assert_int_equal(machine.levels >> BACKLIGHT & 1, 1);
    assert_int_equal(machine.levels >> RESET & 1, 0);
}

static void off_leaves_a_panel_dark_and_in_reset(void **state)
{
    (void)state;
    machine_start(MODEL_ST7789);
    machine.levels |= 1u << RESET | 1u << BACKLIGHT; /* what a crash left */
    assert_int_equal(case_run(CASE_SPIDEV " --off"), 0);
    assert_all_given_back();
    assert_int_equal(machine.panel.bytes, 0);
}

/* --- buttons --------------------------------------------------------------------------------------------------------
 */

static void keys_begin(int high)
{
    static struct problem problem;
    struct keys_config config = {.chip = "pinctrl-test",
                                 .count = 2,
                                 .line = {"key-a", "key-up"},
                                 .button = {HAL_A, HAL_UP},
                                 .high = (uint8_t)high};
    machine_start(MODEL_ST7789);
    if (high)
        machine.levels = 0;
    assert_int_equal(keys_open(&config, &problem), 0);
}

static uint32_t buttons_after(uint32_t us)
{
    machine.now += us;
    return input_buttons();
}

static void a_press_counts_at_once_and_its_bounce_does_not(void **state)
{
    (void)state;
    for (int high = 0; high < 2; high++) {
        keys_begin(high);
        assert_int_equal(buttons_after(1000), 0);
        for (int i = 0; i < 5; i++) /* ends pressed */
            machine_press(KEY_A, (i & 1) == !high ? 1 : 0);
        assert_int_equal(buttons_after(0), HAL_A);
        machine_press(KEY_A, !high);
        assert_int_equal(buttons_after(2000), HAL_A); /* still bouncing */
        machine_press(KEY_A, high);
        assert_int_equal(buttons_after(KEYS_SETTLE_US), HAL_A);
        machine_press(KEY_A, !high);
        assert_int_equal(buttons_after(50000), 0);
        assert_int_equal(buttons_after(KEYS_SETTLE_US), 0);
        keys_close();
    }
}

static void a_press_between_two_looks_is_told_once(void **state)
{
    (void)state;
    keys_begin(0);
    machine_press(KEY_UP, 0);
    machine_press(KEY_UP, 1);
    assert_int_equal(buttons_after(16000), HAL_UP);
    assert_int_equal(buttons_after(16000), 0);
    keys_close();
}

static void an_edge_that_was_lost_is_made_good_by_the_level(void **state)
{
    (void)state;
    keys_begin(0);
    machine_press(KEY_A, 0);
    machine.levels |= 1u << KEY_A; /* released, and the kernel had no room to note it */
    assert_int_equal(buttons_after(0), HAL_A);
    assert_int_equal(buttons_after(KEYS_SETTLE_US), 0);
    keys_close();
}

/* --- signals: last, as there is no way back --------------------------------------------------------------------------
 */

static void a_signal_in_mid_frame_leaves_the_panel_dark_and_in_reset(void **state)
{
    (void)state;
    undisturbed(&wirings[0]);
    machine_start(MODEL_ST7789);
    machine.quits_in_picture = 1;
    assert_int_equal(case_run(CASE_SPIDEV " --frames 1000000"), 0);
    assert_string_equal(case_told, "");
    assert_int_equal(machine.shown, 1);
    assert_memory_equal(machine.seen, good, sizeof good); /* whole: the frame was finished */
    assert_all_given_back();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_reach_the_panel_by_spidev_and_by_gpio_lines),
        cmocka_unit_test(any_call_that_fails_once_is_told_or_mended),
        cmocka_unit_test(calls_that_fail_from_some_time_on_end_with_one_message),
        cmocka_unit_test(pieces_are_as_long_as_the_kernel_takes_them),
        cmocka_unit_test(a_band_is_taken_before_it_is_sent),
        cmocka_unit_test(rows_of_any_length_and_distance_arrive),
        cmocka_unit_test(mode_and_speed_are_the_device_s),
        cmocka_unit_test(what_is_missing_is_named),
        cmocka_unit_test(a_chip_of_several_names_is_found_by_any),
        cmocka_unit_test(who_has_a_line_is_told),
        cmocka_unit_test(a_right_that_is_missing_is_explained),
        cmocka_unit_test(a_panel_wired_upside_down_is_dark_the_other_way),
        cmocka_unit_test(off_leaves_a_panel_dark_and_in_reset),
        cmocka_unit_test(a_press_counts_at_once_and_its_bounce_does_not),
        cmocka_unit_test(a_press_between_two_looks_is_told_once),
        cmocka_unit_test(an_edge_that_was_lost_is_made_good_by_the_level),
        cmocka_unit_test(a_signal_in_mid_frame_leaves_the_panel_dark_and_in_reset),
    };
    /* the program's serial line: nobody asks for anything */
    return freopen("/dev/null", "r", stdin) ? cmocka_run_group_tests(tests, case_scene, NULL) : 1;
}

#endif

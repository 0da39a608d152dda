/* SPDX-License-Identifier: MIT */
/* What glint-device is told: options and board files. */
#include "boards/linux/settings.h"
#include "boards/linux/values.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "listen.h"

#define ARGUMENTS 80
#define ZEROS_16  "0000000000000000"

static const uint32_t no_blob[1], no_length;
const struct program_scene program_scenes[] = {{"demo", no_blob, &no_length}, {"other", no_blob, &no_length}};
const unsigned program_scene_count = 2;

/* app_usual() without the rest of the program. */
void app_usual(struct app_start *start)
{
    *start = (struct app_start){.control = {.running = 1, .figures = 1, .budget = 4}};
}

static struct settings settings;
static char words[1024], told[1024];

/* Reads options parted by spaces: the exit code or -1, and what was told. */
static int reads(const char *options)
{
    char *arguments[ARGUMENTS] = {"glint-device"};
    int count = 1;
    free(settings.text);
    snprintf(words, sizeof words, "%s", options);
    for (char *word = strtok(words, " "); word && count < ARGUMENTS - 1; word = strtok(NULL, " "))
        arguments[count++] = word;
    const struct listen errors = listen_begin(STDERR_FILENO);
    int code = settings_read(&settings, count, arguments);
    listen_end(&errors, told, sizeof told);
    return code;
}

static void write_board(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

#define LEAST "--board /dev/null --panel st7789 --chip c --dc 4 --spi /dev/s "

static void options_reach_their_settings(void **state)
{
    (void)state;
    assert_int_equal(reads(LEAST
                           "--size 135x240 --rotate 270 --bgr --invert=off --offset-x 52 --offset-y 40 --whole=on "
                           "--refresh 0 --spi-mode 3 --speed 62.5M --reset none --backlight !light "
                           "--keys up=1,y=key-y --keys-high --scene other --method phong --budget 9 --fps 50 "
                           "--dither --figures=off --still --time 1500 --step 40 --frames 7"),
                     -1);
    assert_string_equal(told, "");
    assert_ptr_equal(settings.controller, &panel_st7789);
    assert_int_equal(settings.width, 135);
    assert_int_equal(settings.height, 240);
    assert_int_equal(settings.rotation, 270);
    assert_int_equal(settings.bgr, 1);
    assert_int_equal(settings.invert, 0);
    assert_int_equal(settings.offset_x, 52);
    assert_int_equal(settings.offset_y, 40);
    assert_int_equal(settings.whole, 1);
    assert_int_equal(settings.refresh, 0);
    assert_int_equal(settings.wires.mode, 3);
    assert_int_equal(settings.wires.speed, 62500000);
    assert_string_equal(settings.wires.chip, "c");
    assert_string_equal(settings.wires.spi, "/dev/s");
    assert_string_equal(settings.wires.dc.line, "4");
    assert_null(settings.wires.reset.line);
    assert_string_equal(settings.wires.backlight.line, "light");
    assert_int_equal(settings.wires.backlight.inverted, 1);
    assert_int_equal(settings.keys.count, 2);
    assert_int_equal(settings.keys.button[1], HAL_Y);
    assert_string_equal(settings.keys.line[1], "key-y");
    assert_int_equal(settings.keys.high, 1);
    assert_int_equal(settings.start.control.scene, 1);
    assert_string_equal(glint_choices[settings.start.control.method].name, "phong");
    assert_int_equal(settings.start.control.budget, 9);
    assert_int_equal(settings.dithers, 1);
    assert_int_equal(settings.dither, 1);
    assert_int_equal(settings.start.period_us, 20000);
    assert_int_equal(settings.start.control.figures, 0);
    assert_int_equal(settings.start.control.running, 0);
    assert_int_equal(settings.start.control.moment_ms, 1500);
    assert_int_equal(settings.start.step_us, 40000);
    assert_int_equal(settings.start.pictures, 7);
    assert_int_equal(settings.task, SETTINGS_PLAY);
}

static void pictures_go_over_usb_with_a_panel_or_without(void **state)
{
    (void)state;
    assert_int_equal(reads(LEAST), -1);
    assert_int_equal(settings.usb, 0);
    assert_int_equal(settings.dithers, 0);
    assert_int_equal(reads(LEAST "--stream usb --udc fe980000.usb --usb-serial A-1"), -1);
    assert_int_equal(settings.usb, 1);
    assert_int_equal(settings.bare, 0);
    assert_string_equal(settings.udc, "fe980000.usb");
    assert_string_equal(settings.serial, "A-1");
    assert_int_equal(reads("--board /dev/null --stream usb --panel none --chip c --keys a=1"), -1);
    assert_string_equal(told, "");
    assert_int_equal(settings.bare, 1);
    assert_int_equal(settings.width, 240);
    assert_int_equal(settings.height, 240);
    assert_int_equal(settings.keys.count, 0); /* no pins are touched */
    assert_null(settings.udc);
    assert_null(settings.serial);
    assert_int_equal(reads("--board /dev/null --stream usb --panel none --size 320x200"), -1);
    assert_int_equal(settings.width, 320);
    assert_int_equal(reads(LEAST "--panel none --panel st7789"), -1);
    assert_int_equal(settings.bare, 0);
}

static void a_glass_is_its_panel_s_usual_one_unless_said(void **state)
{
    (void)state;
    assert_int_equal(reads(LEAST "--panel ssd0323"), -1);
    assert_int_equal(settings.width, 128);
    assert_int_equal(settings.height, 64);
    assert_int_equal(reads(LEAST "--panel ili9341"), -1);
    assert_int_equal(settings.height, 320);
}

static void values_that_will_not_do_are_refused_with_what_would(void **state)
{
    static const char *const bad[] = {
        "--panel st7735",
        "--size 0x5",
        "--size 240",
        "--size 321x1",
        "--rotate 45",
        "--bgr=maybe",
        "--offset-x 320",
        "--offset-y -1",
        "--refresh 65536",
        "--spi-mode 4",
        "--speed 0",
        "--speed 62.5",
        "--speed 5G",
        "--speed 1.5x",
        "--speed 99999M",
        "--dc !",
        "--keys up",
        "--keys up=",
        "--keys jump=4",
        "--sck !4",
        "--scene nothing",
        "--method nothing",
        "--budget 0",
        "--budget 256",
        "--fps 0",
        "--fps 1001",
        "--figures=no",
        "--time x",
        "--step 0",
        "--frames 0",
        "--speed 1.1234567M",
        "--frames 10000000",
        "--keys up=1,,a=2",
        "--test-pattern=2",
        "--speed 4.M",
        "--stream tcp",
        "--udc a/b",
        "--usb-serial \x7f",
        "--usb-serial \xc3\xa4",
    };
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char options[256], wanted[64];
        snprintf(options, sizeof options, LEAST "%s", bad[i]);
        if (reads(options) != SETTINGS_BAD_USAGE)
            fail_msg("'%s' was taken", bad[i]);
        snprintf(wanted, sizeof wanted, "will not do for %.*s: ", (int)strcspn(bad[i], " ="), bad[i]);
        if (!strstr(told, wanted) || strchr(told, '\n')[1])
            fail_msg("'%s' told: %s", bad[i], told);
    }
}

static void what_is_needed_is_asked_for(void **state)
{
    static const struct {
        const char *options, *told;
    } cases[] = {
        {"--board /dev/null", "--panel is needed"},
        {"--board /dev/null --panel st7789", "--chip is needed"},
        {"--board /dev/null --panel st7789 --chip c", "--dc is needed"},
        {"--board /dev/null --panel st7789 --chip c --dc 1", "--spi DEVICE, or --sck and --mosi, is needed"},
        {LEAST "--size 240x240 --offset-y 81", "reach beyond the panel's memory of 240x320"},
        {LEAST "--panel ssd0323 --size 63x64", "have to be even"},
        {LEAST "--panel ssd0323 --bgr", "no colours"},
        {LEAST "more", "'more' is no option"},
        {"--board /dev/null --panel none", "with --panel none, --stream usb is needed"},
        {"--board /dev/null --panel none --stream usb --off", "want a panel"},
        {"--board /dev/null --panel none --stream usb --test-pattern", "want a panel"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_int_equal(reads(cases[i].options), SETTINGS_BAD_USAGE);
        if (!strstr(told, cases[i].told))
            fail_msg("'%s' told: %s", cases[i].options, told);
    }
}

static void boards_files_are_good(void **state)
{
    static const struct {
        const char *name;
        unsigned keys;
        int bare;
    } boards[] = {
        {"pi-zero-waveshare13", 8, 0}, {"pi-zero-displayhatmini", 4, 0}, {"pi-zero-usb", 0, 1}, {"linux-virt", 2, 0}};
    (void)state;
    for (size_t i = 0; i < sizeof boards / sizeof *boards; i++) {
        char options[128];
        snprintf(options, sizeof options, "--board boards/%s/board.conf", boards[i].name);
        assert_int_equal(reads(options), -1);
        assert_string_equal(told, "");
        assert_int_equal(settings.keys.count, boards[i].keys);
        assert_ptr_equal(settings.controller, boards[i].bare ? NULL : &panel_st7789);
        assert_int_equal(settings.usb, boards[i].bare);
    }
}

static void help_is_there_whatever_the_board_file(void **state)
{
    (void)state;
    assert_int_equal(reads("--board /nowhere --help"), -1);
    assert_int_equal(settings.task, SETTINGS_HELP);
    assert_string_equal(told, "");
    assert_int_equal(reads("--board /dev/null --list"), -1);
    assert_int_equal(settings.task, SETTINGS_LIST);
}

static void a_command_line_overrides_its_board_file(void **state)
{
    (void)state;
    assert_int_equal(reads("--rotate 90 --board boards/pi-zero-waveshare13/board.conf --dc 7"), -1);
    assert_int_equal(settings.rotation, 90);
    assert_string_equal(settings.wires.dc.line, "7");
    assert_string_equal(settings.wires.reset.line, "27");
}

static void a_bad_board_file_is_told_with_its_line(void **state)
{
    static const struct {
        const char *text, *told;
    } cases[] = {
        {"panel st7789\n\n# ...\nrotat 90\n", ":4: there is no such option; `glint-device --help` has them\n"},
        {"panel st7789\r\nrotate 91 # no\n", ":2: this will not do: 0, 90, 180 or 270"},
        {"dc\n", ":1: a value is needed: data/command"},
        {"board other", ":1: a board file names no other"},
        {"bgr maybe", ":1: this will not do: red and blue"},
    };
    char path[] = "/tmp/glint-board-XXXXXX", options[64], wanted[128];
    (void)state;
    close(mkstemp(path));
    snprintf(options, sizeof options, "--board %s", path);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        write_board(path, cases[i].text);
        assert_int_equal(reads(options), SETTINGS_BAD_DATA);
        snprintf(wanted, sizeof wanted, "%s%s", path, cases[i].told);
        if (strncmp(told, wanted, strlen(wanted)) != 0)
            fail_msg("told: %s", told);
    }
    unlink(path);
    assert_int_equal(reads(options), SETTINGS_DEVICE);
    assert_non_null(strstr(told, "No such file"));
}

static void hertz_have_fractions_and_units(void **state)
{
    uint32_t hertz;
    (void)state;
    assert_true(values_hertz("62.5M", &hertz) && hertz == 62500000);
    assert_true(values_hertz("0.4M", &hertz) && hertz == 400000);
    assert_true(values_hertz("500k", &hertz) && hertz == 500000);
    assert_true(values_hertz("4000000", &hertz) && hertz == 4000000);
    assert_true(values_hertz("1.234567M", &hertz) && hertz == 1234567);
    /* 10^64 is 0 modulo 2^64 */
    assert_false(values_hertz("1." ZEROS_16 ZEROS_16 ZEROS_16 ZEROS_16 "M", &hertz));
    assert_false(values_hertz("4295M", &hertz));
    assert_false(values_hertz("", &hertz));
}

static int let_go(void **state)
{
    (void)state;
    free(settings.text);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(options_reach_their_settings),
        cmocka_unit_test(pictures_go_over_usb_with_a_panel_or_without),
        cmocka_unit_test(a_glass_is_its_panel_s_usual_one_unless_said),
        cmocka_unit_test(values_that_will_not_do_are_refused_with_what_would),
        cmocka_unit_test(what_is_needed_is_asked_for),
        cmocka_unit_test(boards_files_are_good),
        cmocka_unit_test(help_is_there_whatever_the_board_file),
        cmocka_unit_test(a_command_line_overrides_its_board_file),
        cmocka_unit_test(a_bad_board_file_is_told_with_its_line),
        cmocka_unit_test(hertz_have_fractions_and_units),
    };
    return cmocka_run_group_tests(tests, NULL, let_go);
}

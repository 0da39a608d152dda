/* SPDX-License-Identifier: MIT */
/* A session with a window: what the device is asked for, and what the window shows. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "record_case.h"
#include "view_case.h"

static struct options options;

static int begin(void **state)
{
    options = (struct options){.input = "usb:", .budget = OPTIONS_NONE, .pause = OPTIONS_NONE};
    return record_case_enter(state);
}

static void quit(void)
{
    it.controls->quit = true;
}

/* Some of what stands in a line over the picture. */
static bool says(enum overlay_place place, const char *words)
{
    for (unsigned i = 0; i < it.text[place].count; i++)
        if (strstr(it.text[place].lines[i], words))
            return true;
    return false;
}

static void tap(unsigned turn)
{
    if (turn == 0)
        case_draw(1, 0, false, true);
    if (turn == 3)
        case_key('a'); /* down and up between two looks */
    if (turn == 6) {
        assert_int_equal(case_asked(0, STREAM_BUTTONS, 16), 1);
        assert_int_equal(it.asked[it.asked_count - 1].type, STREAM_BUTTONS);
        assert_int_equal(it.asked[it.asked_count - 1].value, 0);
        case_press('b');
    }
    if (turn == 7) { /* one that comes and goes beside one that is held */
        case_key(CONTROLS_UP);
        case_release('b');
        case_press('b');
    }
    if (turn == 9) {
        assert_int_equal(case_asked(0, STREAM_BUTTONS, 32 | 1), 1);
        assert_int_equal(it.asked[it.asked_count - 1].value, 32);
        controls_leave(it.controls); /* as when another window has the keyboard */
    }
    if (turn == 11) {
        assert_int_equal(it.asked[it.asked_count - 1].value, 0);
        quit();
    }
}

static void a_tap_is_told_however_short(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, tap), CLI_DONE);
}

static unsigned asked_before;

static void stop_twice(unsigned turn)
{
    if (turn == 0)
        case_draw(1, 0, false, true);
    if (turn == 2 || turn == 4)
        case_key('p');
    if (turn == 4)
        asked_before = it.asked_count;
    if (turn == 6) {
        assert_int_equal(case_asked(0, STREAM_PAUSE, 1), 1);
        assert_int_equal(case_asked(asked_before, STREAM_PAUSE, 0), 1);
        quit();
    }
}

static void who_asks_twice_to_stop_wants_it_to_go_on(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, stop_twice), CLI_DONE);
}

static void replug(unsigned turn)
{
    struct port *port = &it.session.port;
    if (turn == 0)
        case_draw(1, 0, false, true);
    if (turn == 3) {
        assert_false(it.dim);
        port->there = false;
    }
    if (turn == 5) {
        assert_true(it.dim);
        assert_true(says(OVERLAY_MIDDLE, "waiting for"));
        port->there = true;
        port->connections++;
    }
    if (turn == 8) { /* it is back, and has sent nothing so far: what is seen is old */
        assert_true(it.dim);
        assert_int_equal(it.pixel, 1);
        assert_int_equal(case_asked(asked_before, STREAM_KEY_PLEASE, 0), 1);
        case_draw(2, 0, false, true);
    }
    if (turn == 4)
        asked_before = it.asked_count;
    if (turn == 10) {
        assert_int_equal(it.pixel, 2);
        assert_false(it.dim);
        assert_int_equal(it.text[OVERLAY_MIDDLE].count, 0);
        quit();
    }
}

static void the_old_picture_stays_dim_until_there_is_a_new_one(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, replug), CLI_DONE);
}

/* A loss: a band that is missing. */
static void lose(unsigned turn)
{
    if (turn == 0)
        case_draw(1, 0, false, true);
    if (turn == 2) {
        assert_int_equal(case_asked(0, STREAM_KEY_PLEASE, 0), 1); /* at first */
        it.stream.sequence++;
        case_draw(2, 0, false, false);
        it.asked_count = 0;
    }
    if (turn > 2 && turn < 250) {
        assert_int_equal(it.pixel, 1);
        case_draw(3, 0, false, false);
    }
    if (turn == 250) { /* of 4 ms, and never what refers to the lost one */
        assert_in_range(case_asked(0, STREAM_KEY_PLEASE, 0), 3, 5);
        case_draw(4, 0, false, true);
    }
    if (turn == 251)
        it.asked_count = 0;
    if (turn == 400) {
        assert_int_equal(it.pixel, 4);
        assert_int_equal(case_asked(0, STREAM_KEY_PLEASE, 0), 0);
        quit();
    }
    it.now += 4;
}

static void after_a_loss_a_key_frame_is_asked_for_until_it_comes(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, lose), CLI_DONE);
}

static void hold(unsigned turn)
{
    if (turn % 2 == 0)
        case_draw((uint8_t)(turn / 2), 0, false, turn == 0);
    if (turn == 10)
        case_key(' ');
    if (turn == 21)
        case_key('.');
    if (turn == 31)
        case_key(' ');
    if (turn >= 12 && turn <= 21)
        assert_int_equal(it.pixel, 4);
    if (turn >= 23 && turn <= 31)
        assert_int_equal(it.pixel, 10);
    if (turn == 41) {
        assert_int_equal(it.pixel, 19);
        quit();
    }
}

static void a_device_goes_on_while_its_picture_is_held(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, hold), CLI_DONE);
}

/* Buttons are told every 500 ms and answered 100 ms later or a little more; the device after it answers nothing so far.
 */
static void answer(unsigned turn)
{
    struct port *port = &it.session.port;
    double told = it.session.live.told;
    if (turn == 400)
        port->connections++;
    if (turn % 20 == 0 && it.now >= told + 100 && it.now < told + 200)
        it.stream.heard = it.sequence;
    if (turn % 20 == 0)
        case_draw(1, 0, false, turn == 0 || turn == 400);
    if (turn == 390) {
        assert_in_range(it.session.live.meter.latency_ms, 100, 200);
        assert_in_range(case_asked(0, STREAM_BUTTONS, 0), 6, 8);
    }
    if (turn == 402)
        assert_true(it.session.live.meter.latency_ms == 0.);
    if (turn == 410)
        quit();
    it.now += 4;
}

static void latency_is_of_the_device_that_is_there(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, answer), CLI_DONE);
}

/* While the window was drawn, or its picture written, more pictures came than a pipe holds. */
static void fall_behind(unsigned turn)
{
    if (turn == 0)
        case_draw(1, 0, false, true);
    for (unsigned i = 0; turn == 2 && i < 3000; i++)
        case_draw((uint8_t)i, 0, false, false);
    if (turn == 4) {
        assert_int_equal(it.pixel, (uint8_t)2999);
        assert_int_equal(it.shown, 2);
        quit();
    }
}

static void a_window_that_was_slow_shows_the_newest_picture(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, fall_behind), CLI_DONE);
}

static void film_without_pictures(unsigned turn)
{
    if (turn == 0)
        case_draw(1, 0, false, true);
    if (turn == 2 || turn == 4)
        case_key('v');
    if (turn == 6) {
        assert_false(says(OVERLAY_BOTTOM, "saved"));
        assert_true(says(OVERLAY_BOTTOM, "no picture"));
        quit();
    }
}

static void a_film_without_pictures_is_not_called_saved(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, film_without_pictures), CLI_DONE);
    assert_int_equal(record_case_files(), 0);
}

static void film_with_wishes(unsigned turn)
{
    if (turn == 1)
        case_key('v');
    if (turn == 4)
        case_key('m'); /* for a method that the device never goes to */
    if (turn < 9)
        case_draw((uint8_t)turn, 0, false, turn == 0);
    if (turn == 10)
        case_key('v');
    if (turn == 11) {
        assert_int_equal(it.session.pictures, 9);
        quit();
    }
}

static void what_is_asked_for_by_keys_leaves_no_gap_in_a_film(void **state)
{
    (void)state;
    assert_int_equal(case_run(&options, film_with_wishes), CLI_DONE);
    assert_int_equal(record_case_files(), 1);
}

static void film_of_a_long_name(unsigned turn)
{
    if (turn == 0)
        case_draw(1, 0, false, true);
    if (turn == 2)
        case_key('v');
    if (turn == 3) {
        assert_true(says(OVERLAY_BOTTOM, "saved ./././"));
        quit();
    }
}

static void a_long_name_is_told_as_far_as_it_goes(void **state)
{
    static char path[400];
    (void)state;
    for (unsigned i = 0; i < 300; i++)
        path[i] = "./"[i & 1];
    snprintf(path + 300, 100, "film.png");
    options.record = path;
    assert_int_equal(case_run(&options, film_of_a_long_name), CLI_DONE);
    assert_int_equal(record_case_files(), 1);
}

#define LIVE_CASE(name) cmocka_unit_test_setup_teardown(name, begin, record_case_leave)

int main(void)
{
    const struct CMUnitTest tests[] = {
        LIVE_CASE(a_tap_is_told_however_short),
        LIVE_CASE(who_asks_twice_to_stop_wants_it_to_go_on),
        LIVE_CASE(the_old_picture_stays_dim_until_there_is_a_new_one),
        LIVE_CASE(after_a_loss_a_key_frame_is_asked_for_until_it_comes),
        LIVE_CASE(a_device_goes_on_while_its_picture_is_held),
        LIVE_CASE(latency_is_of_the_device_that_is_there),
        LIVE_CASE(a_window_that_was_slow_shows_the_newest_picture),
        LIVE_CASE(a_film_without_pictures_is_not_called_saved),
        LIVE_CASE(what_is_asked_for_by_keys_leaves_no_gap_in_a_film),
        LIVE_CASE(a_long_name_is_told_as_far_as_it_goes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

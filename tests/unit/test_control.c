/* SPDX-License-Identifier: MIT */
/* What buttons do, without a board. */
#include "app/control.h"
#include "input.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>
#include <string.h>

#define PERIOD 16667u
#define SHOWN  (CONTROL_DRAW | CONTROL_REPORT)

static struct control begin(uint32_t buttons)
{
    struct control c = {.scenes = 3, .methods = 20, .method = 2, .budget = CONTROL_BUDGET, .figures = 1};
    control_start(&c, buttons);
    return c;
}

/* Pressed at one step and released at the next: all effects. */
static unsigned tap(struct control *c, uint32_t buttons)
{
    unsigned effect = control_step(c, buttons, PERIOD);
    return effect | control_step(c, 0, PERIOD);
}

/* The menu open on a line. */
static void open_on(struct control *c, enum control_line line)
{
    if (!c->menu)
        assert_int_equal(tap(c, HAL_A), SHOWN);
    while (c->line != line)
        assert_int_equal(tap(c, HAL_DOWN), SHOWN);
}

static void nothing_happens_without_buttons(void **state)
{
    (void)state;
    struct control c = begin(0), before = c;
    for (int i = 0; i < 100; i++)
        assert_int_equal(control_step(&c, 0, PERIOD), 0);
    assert_memory_equal(&c, &before, sizeof c);
}

static void the_animation_goes_on_by_time_not_by_step(void **state)
{
    (void)state;
    random_seed(61);
    for (int i = 0; i < 100; i++) {
        struct control c = begin(0);
        uint64_t us = 0;
        c.running = 1;
        for (int j = 0; j < 1000; j++) {
            uint32_t step = (uint32_t)random_magnitude(1, 2e6);
            us += step;
            assert_int_equal(control_step(&c, 0, step), CONTROL_DRAW);
            assert_int_equal(c.moment_ms, us / 1000);
        }
    }
}

/* A quarter turn a second, less than an angle's unit lost, however long the steps are. */
static void held_arrows_turn_by_time(void **state)
{
    (void)state;
    static const struct {
        uint32_t buttons;
        int right, up;
    } ways[] = {{HAL_RIGHT, 1, 0},
                {HAL_LEFT, -1, 0},
                {HAL_UP, 0, 1},
                {HAL_DOWN, 0, -1},
                {HAL_UP | HAL_LEFT, -1, 1},
                {HAL_UP | HAL_DOWN, 0, 0},
                {HAL_LEFT | HAL_RIGHT | HAL_DOWN, 0, -1}};
    random_seed(62);
    for (unsigned i = 0; i < 7 * 50; i++) {
        struct control c = begin(0);
        uint32_t us = 0, buttons = ways[i % 7].buttons;
        int right = ways[i % 7].right, up = ways[i % 7].up;
        control_step(&c, buttons, 5000); /* newly pressed: since when is not known */
        assert_true(c.yaw == 0 && c.pitch == 0);
        for (int j = 0; j < 300; j++) {
            uint32_t step = (uint32_t)random_between(1, 100000);
            us += step;
            assert_int_equal(control_step(&c, buttons, step), right || up ? CONTROL_DRAW : 0);
            int way = (int)((uint64_t)us * 16384 / 1000000);
            assert_int_equal(c.yaw, (uint16_t)(right * way));
            assert_int_equal(c.pitch, (uint16_t)(up * way));
        }
        assert_int_equal(control_step(&c, 0, PERIOD), SHOWN); /* told when it ends */
        uint16_t yaw = c.yaw, pitch = c.pitch;
        assert_int_equal(control_step(&c, 0, PERIOD), 0);
        assert_true(c.yaw == yaw && c.pitch == pitch);
    }
}

static void a_long_step_turns_by_a_second_at_most(void **state)
{
    (void)state;
    struct control c = begin(0);
    control_step(&c, HAL_RIGHT, PERIOD);
    control_step(&c, HAL_RIGHT, UINT32_MAX);
    assert_int_equal(c.yaw, 16384);
}

static void the_menu_takes_the_arrows(void **state)
{
    (void)state;
    struct control c = begin(0);
    assert_int_equal(tap(&c, HAL_A), SHOWN);
    assert_true(c.menu && c.line == CONTROL_LINE_SCENE);
    for (unsigned i = 1; i <= CONTROL_LINES; i++) {
        assert_int_equal(tap(&c, HAL_DOWN), SHOWN);
        assert_int_equal(c.line, i % CONTROL_LINES);
    }
    assert_int_equal(tap(&c, HAL_UP), SHOWN);
    assert_int_equal(c.line, CONTROL_LINES - 1);
    assert_true(c.yaw == 0 && c.pitch == 0);
    assert_int_equal(tap(&c, HAL_A), SHOWN);
    assert_false(c.menu);
    tap(&c, HAL_DOWN);
    assert_int_equal(c.line, CONTROL_LINES - 1);
    assert_int_not_equal(c.pitch, 0);
    tap(&c, HAL_A);
    assert_int_equal(c.line, CONTROL_LINES - 1); /* where it was */
}

static void scene_and_method_go_round(void **state)
{
    (void)state;
    struct control c = begin(0);
    open_on(&c, CONTROL_LINE_SCENE);
    static const uint16_t scenes[] = {1, 2, 0, 1};
    for (int i = 0; i < 4; i++) {
        assert_int_equal(tap(&c, HAL_RIGHT), SHOWN | CONTROL_READY);
        assert_int_equal(c.scene, scenes[i]);
    }
    tap(&c, HAL_LEFT);
    tap(&c, HAL_LEFT);
    assert_int_equal(c.scene, 2);
    open_on(&c, CONTROL_LINE_METHOD);
    for (unsigned i = 1; i <= 20; i++) {
        assert_int_equal(tap(&c, HAL_RIGHT), SHOWN | CONTROL_READY);
        assert_int_equal(c.method, (2 + i) % 20);
    }
    for (unsigned i = 1; i <= 20; i++) {
        tap(&c, HAL_LEFT);
        assert_int_equal(c.method, (22 - i) % 20);
    }
}

static void the_budget_has_ends_and_takes_any_value_between(void **state)
{
    (void)state;
    struct control c = begin(0);
    open_on(&c, CONTROL_LINE_BUDGET);
    for (unsigned from = 1; from < 256; from++)
        for (int up = 0; up < 2; up++) {
            c.budget = (uint8_t)from;
            for (int i = 0; i < 12; i++) {
                unsigned before = c.budget;
                assert_int_equal(tap(&c, up ? HAL_RIGHT : HAL_LEFT), SHOWN | CONTROL_READY);
                if (before >= 64 && up)
                    assert_int_equal(c.budget, 64);
                else if (before == 1 && !up)
                    assert_int_equal(c.budget, 1);
                else
                    assert_true(up ? c.budget > before && c.budget <= 2 * before : c.budget < before);
            }
            assert_int_equal(c.budget, up ? 64 : 1);
        }
}

static void motion_stops_and_time_goes_in_steps(void **state)
{
    (void)state;
    struct control c = begin(0);
    c.running = 1;
    c.moment_ms = 1234;
    open_on(&c, CONTROL_LINE_TIME);
    uint32_t moment = c.moment_ms;
    control_step(&c, HAL_RIGHT, 0);
    assert_false(c.running);
    assert_int_equal(c.moment_ms, moment + 100);
    control_step(&c, 0, PERIOD);
    for (unsigned i = 0; i < 20; i++)
        tap(&c, HAL_LEFT);
    assert_int_equal(c.moment_ms, 0);
    open_on(&c, CONTROL_LINE_MOTION);
    assert_int_equal(control_step(&c, HAL_RIGHT, PERIOD), SHOWN);
    assert_true(c.running);
    control_step(&c, 0, PERIOD);
    assert_int_equal(control_step(&c, HAL_LEFT, PERIOD), SHOWN);
    assert_false(c.running);
    control_step(&c, HAL_LEFT, 2000000);
    assert_false(c.running); /* held, it stays so */
}

static void turn_and_info_and_screen_do_as_they_say(void **state)
{
    (void)state;
    struct control c = begin(0);
    c.yaw = 1;
    c.pitch = 65535;
    open_on(&c, CONTROL_LINE_TURN);
    assert_int_equal(tap(&c, HAL_RIGHT), SHOWN);
    assert_true(c.yaw == 0 && c.pitch == 0);
    open_on(&c, CONTROL_LINE_INFO);
    assert_int_equal(tap(&c, HAL_LEFT), SHOWN);
    assert_false(c.figures);
    tap(&c, HAL_RIGHT);
    assert_true(c.figures);
    open_on(&c, CONTROL_LINE_SCREEN);
    assert_int_equal(tap(&c, HAL_LEFT), SHOWN | CONTROL_REPAINT);
    assert_false(c.test);
}

static void a_held_arrow_repeats_in_the_menu(void **state)
{
    (void)state;
    struct control c = begin(0);
    open_on(&c, CONTROL_LINE_METHOD);
    control_step(&c, HAL_RIGHT, PERIOD);
    unsigned changes = 0, first = 0;
    for (unsigned ms = 10; ms <= 2000; ms += 10)
        if (control_step(&c, HAL_RIGHT, 10000) && changes++ == 0)
            first = ms;
    assert_int_equal(first, 500);
    assert_int_equal(changes, 1 + 1500 / 150);
    assert_int_equal(c.method, 2 + 1 + changes);
    control_step(&c, 0, PERIOD);
    assert_int_equal(control_step(&c, 0, 2000000), 0);
}

static void shortcuts_work_in_and_out_of_the_menu(void **state)
{
    (void)state;
    for (int menu = 0; menu < 2; menu++) {
        struct control c = begin(0);
        if (menu)
            open_on(&c, CONTROL_LINE_TIME);
        assert_int_equal(tap(&c, HAL_B) & CONTROL_REPORT, CONTROL_REPORT);
        assert_true(c.running);
        tap(&c, HAL_B);
        assert_false(c.running);
        assert_int_equal(tap(&c, HAL_X), SHOWN | CONTROL_READY);
        assert_int_equal(c.method, 3);
        assert_int_equal(tap(&c, HAL_Y), SHOWN | CONTROL_READY);
        assert_int_equal(c.scene, 1);
    }
}

static void what_is_held_at_the_start_does_nothing(void **state)
{
    (void)state;
    const uint32_t all = HAL_UP | HAL_DOWN | HAL_LEFT | HAL_RIGHT | HAL_A;
    struct control c = begin(all);
    assert_false(c.test); /* several: lines that are low until they are used */
    assert_int_equal(control_step(&c, all, PERIOD), 0);
    assert_int_equal(control_step(&c, all & ~(uint32_t)HAL_A, PERIOD), 0);
    assert_int_equal(control_step(&c, HAL_RIGHT, PERIOD), 0);
    assert_int_equal(control_step(&c, HAL_RIGHT | HAL_A, PERIOD), SHOWN);
    assert_true(c.menu && c.yaw == 0);
}

static void one_button_held_at_the_start_shows_the_test_until_released(void **state)
{
    (void)state;
    for (uint32_t button = HAL_UP; button <= HAL_Y; button <<= 1) {
        uint32_t other = button == HAL_A ? HAL_B : HAL_A;
        struct control c = begin(button);
        c.running = 1;
        assert_int_equal(c.test, button);
        assert_int_equal(control_step(&c, button, PERIOD), 0);
        assert_int_equal(control_step(&c, button | other, PERIOD), 0);
        assert_int_equal(control_step(&c, other, PERIOD), SHOWN);
        assert_int_equal(c.test, 0);
        assert_int_equal(c.moment_ms, 0);
        assert_int_equal(control_step(&c, other, PERIOD), CONTROL_DRAW); /* pressed in the test, it means nothing */
        assert_int_equal(control_step(&c, 0, PERIOD), CONTROL_DRAW);
        assert_int_equal(tap(&c, other), SHOWN);
    }
}

static void the_menu_shows_the_test_while_right_is_held(void **state)
{
    (void)state;
    struct control c = begin(0);
    open_on(&c, CONTROL_LINE_SCREEN);
    assert_int_equal(control_step(&c, HAL_RIGHT, PERIOD) & SHOWN, SHOWN);
    for (int i = 0; i < 100; i++) {
        assert_true(c.test);
        assert_int_equal(control_step(&c, HAL_RIGHT, PERIOD), 0);
    }
    assert_int_equal(control_step(&c, 0, PERIOD), SHOWN);
    assert_false(c.test);
    assert_true(c.menu);
}

/* Whatever is pressed, indices and values stay in their ranges. */
static void any_buttons_keep_the_state_valid(void **state)
{
    (void)state;
    random_seed(63);
    for (int i = 0; i < 200; i++) {
        struct control c = begin(random_bits() & 255);
        c.scenes = (uint16_t)random_between(1, 4);
        c.methods = (uint16_t)random_between(1, 20);
        c.method = 0;
        for (int j = 0; j < 2000; j++) {
            control_step(&c, random_bits() & random_bits() & 255, random_bits() >> random_between(0, 31));
            assert_true(c.scene < c.scenes && c.method < c.methods && c.line < CONTROL_LINES && c.budget);
            assert_true(c.running <= 1 && c.figures <= 1 && c.menu <= 1);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_happens_without_buttons),
        cmocka_unit_test(the_animation_goes_on_by_time_not_by_step),
        cmocka_unit_test(held_arrows_turn_by_time),
        cmocka_unit_test(a_long_step_turns_by_a_second_at_most),
        cmocka_unit_test(the_menu_takes_the_arrows),
        cmocka_unit_test(scene_and_method_go_round),
        cmocka_unit_test(the_budget_has_ends_and_takes_any_value_between),
        cmocka_unit_test(motion_stops_and_time_goes_in_steps),
        cmocka_unit_test(turn_and_info_and_screen_do_as_they_say),
        cmocka_unit_test(a_held_arrow_repeats_in_the_menu),
        cmocka_unit_test(shortcuts_work_in_and_out_of_the_menu),
        cmocka_unit_test(what_is_held_at_the_start_does_nothing),
        cmocka_unit_test(one_button_held_at_the_start_shows_the_test_until_released),
        cmocka_unit_test(the_menu_shows_the_test_while_right_is_held),
        cmocka_unit_test(any_buttons_keep_the_state_valid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

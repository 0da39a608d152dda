/* SPDX-License-Identifier: MIT */
/* What the window's keys do. */
#include "view/controls.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static void press(struct controls *c, int key)
{
    controls_press(c, key, false, false);
    controls_release(c, key);
}

static void buttons_are_held_until_they_are_released(void **state)
{
    static const int keys[] = {CONTROLS_UP, CONTROLS_DOWN, CONTROLS_LEFT, CONTROLS_RIGHT, 'a', 'b', 'x', 'y'};
    struct controls c = {0};
    (void)state;
    for (unsigned i = 0; i < 8; i++) {
        controls_press(&c, keys[i], false, false);
        assert_int_equal(c.buttons, (2u << i) - 1);
    }
    controls_press(&c, 'a', false, true); /* held long enough to repeat */
    controls_release(&c, CONTROLS_LEFT);
    assert_int_equal(c.buttons, 0xFB);
    controls_release(&c, CONTROLS_LEFT);
    assert_int_equal(c.buttons, 0xFB);
    controls_leave(&c);
    assert_int_equal(c.buttons, 0);
    assert_int_equal(c.taps, 0xFF); /* which are to be told yet */
}

static void rotation_goes_round(void **state)
{
    struct controls c = {0};
    (void)state;
    for (unsigned i = 1; i <= 5; i++) {
        press(&c, 'r');
        assert_int_equal(c.rotation, i & 3);
    }
    controls_press(&c, 'r', true, false);
    controls_press(&c, 'r', true, false);
    assert_int_equal(c.rotation, 3);
    controls_press(&c, 'r', false, true); /* repeats turn no further */
    assert_int_equal(c.rotation, 3);
}

static void escape_leaves_fullscreen_before_it_ends(void **state)
{
    struct controls c = {0};
    (void)state;
    press(&c, CONTROLS_F11);
    assert_true(c.fullscreen);
    press(&c, CONTROLS_ESCAPE);
    assert_false(c.fullscreen);
    assert_false(c.quit);
    press(&c, CONTROLS_ESCAPE);
    assert_true(c.quit);
    c = (struct controls){.fullscreen = true};
    press(&c, 'q');
    assert_true(c.quit);
}

static void a_step_holds_the_picture(void **state)
{
    struct controls c = {0};
    (void)state;
    press(&c, '.');
    controls_press(&c, '.', false, true); /* held, it steps again and again */
    assert_true(c.paused);
    assert_int_equal(c.steps, 2);
    press(&c, ' ');
    assert_false(c.paused);
    assert_int_equal(c.steps, 0);
    press(&c, ' ');
    assert_true(c.paused);
}

static void figures_are_few_or_all(void **state)
{
    struct controls c = {.figures = true};
    (void)state;
    controls_press(&c, 'o', true, false);
    assert_true(c.figures && c.details);
    press(&c, 'o');
    assert_true(!c.figures && c.details);
    press(&c, 'o');
    assert_true(c.figures && c.details);
    controls_press(&c, 'o', true, false);
    assert_true(c.figures && !c.details);
}

static void requests_add_up_until_they_are_made(void **state)
{
    struct controls c = {0};
    (void)state;
    press(&c, 'm');
    press(&c, 'm');
    controls_press(&c, 'm', true, false);
    press(&c, CONTROLS_PAGE_UP);
    press(&c, '+');
    press(&c, '=');
    press(&c, '-');
    press(&c, 'p');
    assert_int_equal(c.method, 1);
    assert_int_equal(c.scene, -1);
    assert_int_equal(c.budget, 1);
    assert_true(c.motion);
    press(&c, 'p'); /* there and back */
    assert_false(c.motion);
    press(&c, CONTROLS_PAGE_DOWN);
    assert_int_equal(c.scene, 0);
}

static void what_a_key_does_not_name_it_leaves(void **state)
{
    (void)state;
    for (int key = -1; key < 300; key++) {
        struct controls c = {0}, none = {0};
        press(&c, key);
        c.taps = 0; /* buttons leave but these */
        bool known = key == CONTROLS_ESCAPE || (key >= 256 && key <= CONTROLS_F11 && c.buttons == none.buttons) ||
                     (key > 0 && key < 128 && strchr("123456rfp sohmvw.+=-q", key));
        if (!known || (key >= CONTROLS_UP && key <= CONTROLS_RIGHT))
            assert_memory_equal(&c, &none, sizeof c);
        else
            assert_memory_not_equal(&c, &none, sizeof c);
    }
}

static void scales_are_those_of_the_digits(void **state)
{
    (void)state;
    for (int key = '0'; key <= '9'; key++) {
        struct controls c = {0};
        press(&c, key);
        assert_int_equal(c.scale, key >= '1' && key <= '6' ? key - '0' : 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(buttons_are_held_until_they_are_released),
                                       cmocka_unit_test(rotation_goes_round),
                                       cmocka_unit_test(escape_leaves_fullscreen_before_it_ends),
                                       cmocka_unit_test(a_step_holds_the_picture),
                                       cmocka_unit_test(figures_are_few_or_all),
                                       cmocka_unit_test(requests_add_up_until_they_are_made),
                                       cmocka_unit_test(what_a_key_does_not_name_it_leaves),
                                       cmocka_unit_test(scales_are_those_of_the_digits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

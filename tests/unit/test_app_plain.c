/* SPDX-License-Identifier: MIT */
/* The handheld's program on a display that is no panel: words, faults, errors, and the serial line in a link's place.
 */
#include "glint.h"
#include "pack/pack.h"
#include "view/frames.h"
#include "view/port.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "app_plain_case.h"

static void start_of(struct app_start *start, uint32_t pictures)
{
    app_usual(start);
    start->pictures = pictures;
    start->control.running = start->control.figures = 0;
}

static void a_fault_stays_until_a_button_goes_down_and_up(void **state)
{
    struct app_start start;
    (void)state;
    start_of(&start, 1);
    machine.faulted = 1;
    machine.keys[0].from_us = 0; /* held from before */
    machine.keys[0].buttons = HAL_A;
    machine.keys[1].from_us = 50000;
    machine.keys[2].from_us = 90000;
    machine.keys[2].buttons = HAL_B;
    machine.keys[3].from_us = 130000;
    machine.keys[4].from_us = UINT32_MAX;
    assert_int_equal(app_run(&board, &start), 0);
    blank();
    write_words(4, 6, "fault 3");
    write_words(4, 18, "at 00001234");
    write_words(4, 30, "from 00005678");
    write_words(4, HEIGHT - 12, "press a button");
    check_words(glass.first);
    assert_in_range(glass.first_us, 130000, 140000);
    assert_int_equal(glass.ended, 2);
    assert_int_equal(glass.kept, 1);
}

static void a_fault_that_cannot_be_shown_waits_for_nobody(void **state)
{
    struct app_start start;
    (void)state;
    start_of(&start, 1);
    machine.faulted = 1;
    glass.fails_at = 2;
    assert_int_equal(app_run(&board, &start), 0);
    assert_int_equal(glass.flushed, 2 + FLUSHES);
    assert_int_equal(glass.ended, 1);
    assert_true(machine.now_us < 50000);
}

static void a_fault_is_shown_on_a_grey_display_that_takes_bands_alone(void **state)
{
    struct app_start start;
    (void)state;
    start_of(&start, 1);
    board.format = HAL_GREY4;
    board.pack = &pack_grey4;
    display.ops = &glass_plain_ops;
    machine.faulted = 1;
    machine.keys[0].from_us = 20000;
    machine.keys[0].buttons = HAL_A;
    machine.keys[1].from_us = 40000;
    machine.keys[2].from_us = UINT32_MAX;
    assert_int_equal(app_run(&board, &start), 0);
    assert_int_equal(glass.flushed, 2 * FLUSHES);
    assert_int_equal(glass.begun, 0);
    blank();
    write_words(4, 6, "fault 3");
    write_words(4, 18, "at 00001234");
    write_words(4, 30, "from 00005678");
    write_words(4, HEIGHT - 12, "press a button");
    check_words(glass.first);
    assert_in_range(machine.now_us, 40000, 60000);
}

static void without_x_the_first_method_is_drawn_until_somebody_quits(void **state)
{
    struct app_start start;
    (void)state;
    app_usual(&start);
    assert_int_equal(start.control.method, 0);
    machine.keys[0].from_us = 200000;
    machine.keys[0].buttons = HAL_QUIT;
    machine.keys[1].from_us = UINT32_MAX;
    assert_int_equal(app_run(&board, &start), 0);
    assert_in_range(glass.ended, 9, 13); /* 16 ms each */
    assert_non_null(strstr(machine.told, "frame demo gouraud 0 ms"));
    assert_null(strstr(machine.told, "stack"));
}

static void a_scene_that_stands_is_drawn_once_and_anew_when_the_menu_says(void **state)
{
    struct app_start start;
    (void)state;
    start_of(&start, 0);
    machine.stack = 1234;
    for (unsigned i = 0; i < 7; i++) /* menu, the line before the first, redraw, away */
        machine.keys[i].from_us = 100000 * (i + 1);
    machine.keys[0].buttons = HAL_A;
    machine.keys[2].buttons = HAL_UP;
    machine.keys[4].buttons = HAL_LEFT;
    machine.keys[6].buttons = HAL_QUIT;
    machine.keys[7].from_us = UINT32_MAX;
    assert_int_equal(app_run(&board, &start), 0);
    assert_int_equal(glass.ended, 4);
    assert_non_null(strstr(machine.told, "menu screen, stack 1234\n"));
    assert_int_equal(glass.kept, 1);
}

static void x_is_the_first_method_where_it_is_there(void **state)
{
    struct app_start start;
    (void)state;
    strcpy(last_name, "x");
    app_usual(&start);
    assert_int_equal(start.control.method, 2);
    strcpy(last_name, "xy");
    app_usual(&start);
    assert_int_equal(start.control.method, 0);
}

static struct {
    uint32_t pictures, hellos, logs;
    uint16_t pixels[WIDTH * HEIGHT];
} heard;

static void hear_picture(void *context, const struct frames_picture *p)
{
    (void)context;
    heard.pictures++;
    assert_int_equal(p->width, WIDTH);
    assert_int_equal(p->height, HEIGHT);
    memcpy(heard.pixels, p->pixels, sizeof heard.pixels);
}

static void hear_hello(void *context, const char *text, uint32_t length)
{
    (void)context, (void)length;
    heard.hellos++;
    assert_string_equal(text, "model");
}

static void hear_log(void *context, const char *text, uint32_t length)
{
    (void)context;
    heard.logs++;
    assert_true(length > 10);
    assert_memory_equal(text, "frame demo", 10);
}

static void a_picture_goes_over_the_serial_line_when_it_is_asked_for(void **state)
{
    const struct frames_events events = {.picture = hear_picture, .hello = hear_hello, .log = hear_log};
    struct app_start start;
    (void)state;
    start_of(&start, 1);
    for (unsigned logs = 0; logs < 2; logs++) {
        board.log = logs ? stream_log : NULL;
        memset(&heard, 0, sizeof heard);
        frames_open(&machine.frames, &events);
        port_message(machine.says, STREAM_KEY_PLEASE, 0, 1);
        machine.says_count = STREAM_HEADER;
        assert_int_equal(app_run(&board, &start), 0);
        frames_close(&machine.frames);
        assert_int_equal(heard.hellos, 1);
        assert_int_equal(heard.pictures, 1);
        assert_int_equal(heard.logs, logs);
        assert_memory_equal(heard.pixels, glass.shown, sizeof heard.pixels);
    }
}

static void a_scene_that_breaks_after_its_check_is_named(void **state)
{
    struct text_line line = {.length = 0};
    (void)state;
    show_ready(&app);
    assert_null(app.problem);
    blobs[0][0] ^= 1;
    assert_int_equal(show_frame(&app), 0);
    report_picture(&app, &line);
    assert_string_equal(line.text, "error demo: cannot be drawn");
    blank();
    write_words(4, 12, "demo");
    write_words(4, 24, "cannot be");
    write_words(4, 30, "drawn");
    check_words(glass.shown);
}

static void a_board_without_bands_draws_nothing(void **state)
{
    (void)state;
    board.band[0] = NULL;
    show_ready(&app);
    assert_string_equal(app.problem, "no room for its vertices");
}

static void a_word_longer_than_a_line_is_cut_into_lines(void **state)
{
    (void)state;
    app.control.scene = 1;
    blobs[1][0] ^= 1;
    for (unsigned width = WIDTH; width <= WIDE; width += WIDE - WIDTH) {
        const unsigned cell = text_width(width), columns = width == WIDTH ? 14 : 159;
        board.width = (uint16_t)width;
        show_ready(&app);
        assert_int_equal(show_frame(&app), 0);
        blank();
        for (unsigned at = 0, y = 2 * text_height(width); at < LONG_NAME; at += columns, y += text_height(width)) {
            char part[LONG_NAME + 1];
            snprintf(part, sizeof part, "%.*s", (int)columns, long_name + at);
            write_words(cell, y, part);
        }
        /* of the lines below, the problem is written over */
        assert_memory_equal(glass.shown, wanted, 2u * width * 3 * text_height(width));
    }
}

static void what_found_no_room_is_among_the_figures(void **state)
{
    char text[64];
    (void)state;
    machine.tick_us = 0;
    app.control.figures = 1;
    struct glint_config config = show_config(&app);
    glint_fit_stores(&config, blobs[0]);
    config.tables = 0;
    config.max_clipped = config.max_clipped < SHOW_CLIPPED ? config.max_clipped : SHOW_CLIPPED;
    config.max_triangles = 40;
    board.memory_bytes = (uint32_t)glint_memory_needed(&config);
    show_ready(&app);
    assert_null(app.problem);
    assert_int_equal(show_frame(&app), 0);
    assert_true(app.share.frame.stats.dropped > 0);
    blank();
    snprintf(text, sizeof text, "0 us %u dropped", (unsigned)app.share.frame.stats.dropped);
    write_words(0, 0, text);
    const unsigned width = text_width(WIDTH) * (unsigned)strlen(text);
    for (unsigned y = 0; y < text_height(WIDTH); y++)
        assert_memory_equal(glass.shown + y * WIDTH, wanted + y * WIDTH, 2 * (width < WIDTH ? width : WIDTH));
}

static void the_second_cpu_leaves_the_buttons_alone(void **state)
{
    (void)state;
    canvas();
    machine.keys[0].from_us = 0;
    machine.keys[0].buttons = HAL_A;
    machine.keys[1].from_us = UINT32_MAX;
    show_overlay(&app, &paper, 1);
    assert_int_equal(app.buttons, 0);
    assert_int_equal(machine.looks, 0);
    show_overlay(&app, &paper, 0);
    assert_int_equal(app.buttons, HAL_A);
}

static void the_menu_says_what_is_on(void **state)
{
    static uint16_t menu[2][WIDTH * 60];
    (void)state;
    board.height = 60;
    app.control.line = 7;
    for (unsigned on = 0; on < 2; on++) {
        app.control.running = app.control.figures = (uint8_t)on;
        blank();
        const struct text_canvas c = canvas();
        menu_draw(&app, &c);
        memcpy(menu[on], wanted, sizeof menu[on]);
    }
    blank();
    for (unsigned line = 0; line < CONTROL_LINES; line++)
        for (unsigned y = (line + 1) * 6; y < (line + 2) * 6; y++) {
            int same = memcmp(menu[0] + y * WIDTH, menu[1] + y * WIDTH, 2 * WIDTH) == 0;
            if (line != CONTROL_LINE_MOTION && line != CONTROL_LINE_INFO)
                assert_true(same);
        }
    write_words(0, 4 * 6, "motion on");
    write_words(0, 7 * 6, "info   on");
    assert_memory_equal(menu[1] + 4 * 6 * WIDTH, wanted + 4 * 6 * WIDTH, 2 * WIDTH * 6);
    assert_memory_equal(menu[1] + 7 * 6 * WIDTH, wanted + 7 * 6 * WIDTH, 2 * WIDTH * 5); /* the sixth is the next's */
}

static void an_error_of_the_last_picture_is_told_before_the_next(void **state)
{
    (void)state;
    show_ready(&app);
    app.control.test = HAL_UP;
    atomic_store(&app.share.error, HAL_E_IO);
    assert_int_equal(show_frame(&app), HAL_E_IO);
    assert_int_equal(glass.begun, 0);
    assert_int_equal(glass.flushed, 0);
    atomic_store(&app.share.error, HAL_E_FULL);
    assert_int_equal(show_finish(&app), HAL_E_FULL);
    assert_int_equal(show_finish(&app), 0);
}

static void the_test_ends_where_the_display_fails(void **state)
{
    struct text_line line = {.length = 0};
    (void)state;
    show_ready(&app);
    app.control.test = HAL_UP;
    report_picture(&app, &line);
    assert_string_equal(line.text, "test model 64x48"); /* of a panel alone, how it is turned */
    glass.fails_at = 2;
    assert_int_equal(show_frame(&app), HAL_E_IO);
    assert_int_equal(glass.flushed, 2);
    assert_int_equal(glass.ended, 0);
    assert_int_equal(show_frame(&app), 0);
    blank();
    write_words(4, 24, "test model");
    write_words(4, 30, "64x48");
    check_words(glass.shown);
}

static void letters_end_where_the_alphabet_does(void **state)
{
    (void)state;
    assert_int_not_equal(text_glyph('z'), 0);
    assert_int_equal(text_glyph('{'), 0);
    assert_int_equal(text_glyph('['), 0);
    assert_int_equal(text_glyph('`'), 0);
    assert_int_equal(text_glyph('@'), 0);
    assert_int_equal(text_glyph('Z'), text_glyph('z'));
}

static void a_full_line_takes_no_more(void **state)
{
    struct text_line line = {.length = 0};
    (void)state;
    for (unsigned i = 0; i < sizeof line.text + 9; i++)
        text_add(&line, "m");
    assert_int_equal(line.length, sizeof line.text - 1);
    text_add_angle(&line, 12345);
    assert_int_equal(line.length, sizeof line.text - 1);
    assert_int_equal(strspn(line.text, "m"), sizeof line.text - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_fault_stays_until_a_button_goes_down_and_up, begin),
        cmocka_unit_test_setup(a_fault_that_cannot_be_shown_waits_for_nobody, begin),
        cmocka_unit_test_setup(a_fault_is_shown_on_a_grey_display_that_takes_bands_alone, begin),
        cmocka_unit_test_setup(without_x_the_first_method_is_drawn_until_somebody_quits, begin),
        cmocka_unit_test_setup(x_is_the_first_method_where_it_is_there, begin),
        cmocka_unit_test_setup(a_scene_that_stands_is_drawn_once_and_anew_when_the_menu_says, begin),
        cmocka_unit_test_setup(a_picture_goes_over_the_serial_line_when_it_is_asked_for, begin),
        cmocka_unit_test_setup(a_scene_that_breaks_after_its_check_is_named, begin),
        cmocka_unit_test_setup(a_board_without_bands_draws_nothing, begin),
        cmocka_unit_test_setup(a_word_longer_than_a_line_is_cut_into_lines, begin),
        cmocka_unit_test_setup(what_found_no_room_is_among_the_figures, begin),
        cmocka_unit_test_setup(the_second_cpu_leaves_the_buttons_alone, begin),
        cmocka_unit_test_setup(the_menu_says_what_is_on, begin),
        cmocka_unit_test_setup(an_error_of_the_last_picture_is_told_before_the_next, begin),
        cmocka_unit_test_setup(the_test_ends_where_the_display_fails, begin),
        cmocka_unit_test_setup(letters_end_where_the_alphabet_does, begin),
        cmocka_unit_test_setup(a_full_line_takes_no_more, begin),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

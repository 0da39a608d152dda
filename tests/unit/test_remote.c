/* SPDX-License-Identifier: MIT */
/* What the handheld's program does when the other end of its line asks, and the pictures that it sends there. */
#include "app/app.h"
#include "clock.h"
#include "host/displays.h"
#include "input.h"
#include "pack/pack.h"
#include "view/port.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "stream_case.h"

enum { WIDTH = 64, HEIGHT = 50, BAND_ROWS = 12, MEMORY = 150 * 1024 };

static uint32_t blob[24 * 1024 / 4], blob_length, memory[MEMORY / 4], bands[2][WIDTH * BAND_ROWS / 2], now_us;
const struct program_scene program_scenes[] = {{"demo", blob, &blob_length}, {"again", blob, &blob_length}};
const unsigned program_scene_count = 2;
static struct hal_display display = {&null_display};
static struct board board;
static struct app app;
static struct stream_case_bytes line;

uint32_t input_buttons(void)
{
    return 0;
}

uint32_t clock_us(void)
{
    return now_us += 100;
}

void clock_wait_us(uint32_t us)
{
    now_us += us;
}

static int load(void **state)
{
    struct pack_result packed;
    (void)state;
    if (pack_load("tests/scenes/demo.json", NULL, &packed) != 0 || packed.size > sizeof blob)
        return 1;
    memcpy(blob, packed.scene, packed.size);
    blob_length = (uint32_t)packed.size;
    pack_free(&packed);
    return 0;
}

static int begin(void **state)
{
    (void)state;
    board = (struct board){.name = "model",
                           .display = &display,
                           .width = WIDTH,
                           .height = HEIGHT,
                           .band_rows = BAND_ROWS,
                           .format = HAL_RGB565,
                           .pack = &pack_rgb565,
                           .dither = 1,
                           .band = {bands[0], bands[1]},
                           .memory = memory,
                           .memory_bytes = sizeof memory};
    app = (struct app){
        .board = &board,
        .control = {.scenes = 2, .methods = (uint16_t)glint_choice_count, .budget = CONTROL_BUDGET, .moment_ms = 700},
        .remote.stream = {.write = stream_case_write, .context = &line}};
    show_ready(&app);
    return 0;
}

static int end(void **state)
{
    (void)state;
    free(line.bytes);
    line = (struct stream_case_bytes){0};
    return 0;
}

static unsigned ask(enum stream_type type, uint32_t value)
{
    uint8_t message[STREAM_HEADER];
    port_message(message, type, value, 0x1234);
    return remote_hear(&app, message, sizeof message);
}

static size_t names_bytes(void)
{
    size_t bytes = 0;
    for (unsigned i = 0; i < glint_choice_count; i++)
        bytes += strlen(glint_choices[i].name) + 1;
    return bytes;
}

static void requests_do_what_the_menu_does(void **state)
{
    const unsigned ready = CONTROL_DRAW | CONTROL_REPORT | CONTROL_READY;
    (void)state;
    assert_int_equal(ask(STREAM_SCENE, 1), ready);
    assert_int_equal(app.control.scene, 1);
    assert_int_equal(ask(STREAM_METHOD, 3), ready);
    assert_int_equal(app.control.method, 3);
    assert_int_equal(ask(STREAM_BUDGET, 255), ready);
    assert_int_equal(app.control.budget, 255);
    assert_int_equal(ask(STREAM_PAUSE, 0), CONTROL_DRAW | CONTROL_REPORT);
    assert_int_equal(app.control.running, 1);
    assert_int_equal(ask(STREAM_PAUSE, 1), CONTROL_DRAW | CONTROL_REPORT);
    assert_int_equal(app.control.running, 0);
}

static void what_there_is_not_cannot_be_asked_for(void **state)
{
    (void)state;
    assert_int_equal(ask(STREAM_SCENE, 2), 0);
    assert_int_equal(ask(STREAM_SCENE, 65536), 0);
    assert_int_equal(ask(STREAM_METHOD, glint_choice_count), 0);
    assert_int_equal(ask(STREAM_BUDGET, 0), 0);
    assert_int_equal(ask(STREAM_BUDGET, 256), 0);
    assert_int_equal(ask(STREAM_PAUSE + 1, 0), 0);
    assert_int_equal(app.control.scene + app.control.method, 0);
    assert_int_equal(app.control.budget, CONTROL_BUDGET);
}

static void buttons_are_released_by_word_or_after_a_second(void **state)
{
    (void)state;
    assert_int_equal(remote_buttons(&app.remote, 16667), 0);
    assert_int_equal(ask(STREAM_BUTTONS, HAL_LEFT | HAL_A), 0);
    assert_int_equal(remote_buttons(&app.remote, 16667), HAL_LEFT | HAL_A);
    ask(STREAM_BUTTONS, HAL_LEFT);
    assert_int_equal(remote_buttons(&app.remote, 999999), HAL_LEFT);
    assert_int_equal(remote_buttons(&app.remote, 1), 0);
    assert_int_equal(remote_buttons(&app.remote, 5000000), 0);
    ask(STREAM_BUTTONS, HAL_UP);
    ask(STREAM_BUTTONS, 0);
    assert_int_equal(remote_buttons(&app.remote, 1), 0);
}

/* As one of the device's own that is pressed while a picture is drawn. */
static void a_button_that_is_released_at_once_was_pressed(void **state)
{
    (void)state;
    ask(STREAM_BUTTONS, HAL_A | HAL_QUIT);
    ask(STREAM_BUTTONS, 0);
    assert_int_equal(app.buttons, HAL_A);
    assert_int_equal(remote_buttons(&app.remote, 1), 0);
}

static void a_picture_echoes_the_last_request(void **state)
{
    const size_t hello = STREAM_HEADER + 6 + 5 + 6 + 1 + names_bytes() + STREAM_CHECK;
    (void)state;
    ask(STREAM_KEY_PLEASE, 0);
    assert_int_equal(show_frame(&app), 0);
    assert_int_equal(line.bytes[hello + STREAM_AT_TYPE], STREAM_BEGIN);
    assert_int_equal(line.bytes[hello + STREAM_AT_X], 0x34);
    assert_int_equal(line.bytes[hello + STREAM_AT_X + 1], 0x12);
}

static void nothing_is_sent_unasked(void **state)
{
    (void)state;
    assert_int_equal(show_frame(&app), 0);
    assert_int_equal(line.count, 0);
    assert_int_equal(ask(STREAM_KEY_PLEASE, 0), CONTROL_DRAW);
    assert_int_equal(show_frame(&app), 0);
    size_t once = line.count;
    assert_true(once > 0);
    assert_int_equal(show_frame(&app), 0);
    assert_int_equal(line.count, once);
}

static void the_picture_sent_is_the_renderers(void **state)
{
    static const enum glint_format formats[] = {GLINT_RGB565, GLINT_GREY4};
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct stream_case_view view;
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, formats[i]);
        f.config.flags = GLINT_DITHER;
        f.config.method = glint_choices[0].method;
        uint8_t *picture = frame_case_picture(f, blob, 700, NULL);
        begin(NULL);
        board.format = (uint8_t)formats[i];
        board.pack = formats[i] == GLINT_RGB565 ? &pack_rgb565 : &pack_grey4;
        show_ready(&app);
        ask(STREAM_KEY_PLEASE, 0);
        assert_int_equal(show_frame(&app), 0);
        stream_case_watch(&view, picture, unpack_row_bytes((enum stream_format)formats[i], WIDTH) * HEIGHT, 1);
        stream_case_take(&view, line.bytes, line.count);
        assert_int_equal(view.shown, 1);
        assert_int_equal(view.wrong, 0);
        free(picture);
        end(NULL);
    }
}

/* Words instead of a scene go out as well: the other end sees what the display shows. */
static void a_problem_is_sent_too(void **state)
{
    (void)state;
    blob[30] ^= 1;
    show_ready(&app);
    assert_non_null(app.problem);
    ask(STREAM_KEY_PLEASE, 0);
    assert_int_equal(show_frame(&app), 0);
    blob[30] ^= 1;
    const struct frames_events none = {0};
    struct frames frames;
    frames_open(&frames, &none);
    frames_push(&frames, line.bytes, line.count);
    assert_int_equal(frames.pictures, 1);
    frames_close(&frames);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(requests_do_what_the_menu_does, begin, end),
        cmocka_unit_test_setup_teardown(what_there_is_not_cannot_be_asked_for, begin, end),
        cmocka_unit_test_setup_teardown(buttons_are_released_by_word_or_after_a_second, begin, end),
        cmocka_unit_test_setup_teardown(a_button_that_is_released_at_once_was_pressed, begin, end),
        cmocka_unit_test_setup_teardown(a_picture_echoes_the_last_request, begin, end),
        cmocka_unit_test_setup_teardown(nothing_is_sent_unasked, begin, end),
        cmocka_unit_test_setup_teardown(the_picture_sent_is_the_renderers, begin, end),
        cmocka_unit_test_setup_teardown(a_problem_is_sent_too, begin, end),
    };
    return cmocka_run_group_tests(tests, load, NULL);
}

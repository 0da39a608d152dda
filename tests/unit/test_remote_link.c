/* SPDX-License-Identifier: MIT */
/* The handheld's program with a link: what is on the display goes over it, or is left out, and nobody waits. */
#include "view/frames.h"
#include "view/port.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "app_machine.h"

enum { WIDTH = 64, HEIGHT = 50, BAND_ROWS = 12, MEMORY = 150 * 1024, PICTURES = 12, PERIOD_US = 16000 };
enum { PICTURE = 2 * WIDTH * HEIGHT, BANDS = 5, MOST = PICTURE + 36 * BANDS + 116 };

static uint32_t memory[MEMORY / 4], bands[2][WIDTH * BAND_ROWS / 2], last[PICTURE / 4];
const struct program_scene program_scenes[] = {{"demo", blob, &blob_length}, {"again", blob, &blob_length}};
const unsigned program_scene_count = 2;

/* What there is of the machine. */
static char reports[4096];
void machine_write(const char *text)
{
    strncat(reports, text, sizeof reports - strlen(reports) - 1);
}
void serial_write(const void *bytes, uint32_t count)
{
    (void)bytes, (void)count;
    fail_msg("something went to the serial line");
}
uint32_t serial_read(void *bytes, uint32_t size)
{
    (void)bytes, (void)size;
    return 0;
}

/* A display that shows what it was given, or fails once. */
static uint8_t shown[PICTURE];
static uint32_t fails_in, fails_at; /* the picture, from 1 on; the row */

static int display_fails(uint32_t y);

static int display_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    (void)display, (void)width, (void)height, (void)format;
    return 0;
}

static int display_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    (void)display;
    memcpy(shown + y * stride, pixels, rows * stride);
    return display_fails(y) ? HAL_E_IO : 0;
}

static int display_close(struct hal_display *display, int keep)
{
    (void)display, (void)keep;
    return 0;
}

static const struct hal_display_ops display_ops = {
    .open = display_open, .flush = display_flush, .close = display_close};
static struct hal_display display = {&display_ops};

/* A link that answers as it is told, with a viewer at its end. */
static struct {
    struct hal_link link;
    char answers[PICTURES + 1]; /* to begin, one after the other: '-' leaves; '!' is the first of one who has come */
    uint32_t begun, taken, told;
    uint32_t breaks_in, breaks_after; /* that picture: writes are refused after so many bytes */
    uint32_t bytes;                   /* of the picture under way */
    uint8_t says[256];                /* to the device, before the picture says_at */
    uint32_t says_count, says_at;
    uint32_t talks, reads; /* talks: there is always more to read; reads: since the last picture */
    struct frames frames;
    struct {
        uint32_t number, skipped, moment_ms;
        uint16_t echo;
        uint8_t key, hello;
    } picture[PICTURES];
    uint32_t pictures, wrong, hellos, longest;
    uint16_t echo;
    char log[512];
    int still;
} line;

static int display_fails(uint32_t y)
{
    int fails = fails_in && line.begun == fails_in && y >= fails_at;
    fails_in = fails ? 0 : fails_in;
    return fails;
}

static uint32_t line_begin(struct hal_link *link, uint32_t *skipped)
{
    assert_ptr_equal(link, &line.link);
    assert_in_range(line.begun, 0, PICTURES - 1);
    char answer = line.answers[line.begun++];
    line.taken = answer == '!' || answer == '+';
    *skipped += answer == '-';
    line.bytes = 0;
    line.reads = 0;
    if (answer == '!') {
        const struct frames_events events = line.frames.events;
        frames_close(&line.frames);
        line.frames = (struct frames){0};
        frames_open(&line.frames, &events);
    }
    return line.taken;
}

static int line_write(void *link, const void *bytes, size_t size)
{
    const uint8_t *at = bytes;
    assert_ptr_equal(link, &line.link);
    assert_true(line.taken);
    if (line.begun == line.breaks_in && line.bytes + size > line.breaks_after)
        return HAL_E_IO;
    if (size == STREAM_HEADER && at[STREAM_AT_TYPE] == STREAM_BEGIN && at[0] == 0xF6) {
        line.echo = (uint16_t)(at[STREAM_AT_X] | at[STREAM_AT_X + 1] << 8);
        line.bytes = 0; /* hello has room of its own */
    }
    line.bytes += (uint32_t)size;
    line.longest = line.bytes > line.longest ? line.bytes : line.longest;
    frames_push(&line.frames, bytes, size);
    return 0;
}

static int32_t line_read(struct hal_link *link, void *bytes, uint32_t size)
{
    (void)link;
    if (line.answers[line.begun] == '!' && line.told != line.begun + 1) {
        line.told = line.begun + 1;
        return HAL_LINK_COMES;
    }
    if (line.talks) {
        assert_in_range(++line.reads, 1, 1000);
        memset(bytes, 0x55, size);
        return (int32_t)size;
    }
    if (line.begun < line.says_at)
        return 0;
    uint32_t count = line.says_count < size ? line.says_count : size;
    memcpy(bytes, line.says, count);
    memmove(line.says, line.says + count, line.says_count -= count);
    return (int32_t)count;
}

static void line_picture(void *context, const struct frames_picture *p)
{
    (void)context;
    line.wrong += memcmp(p->pixels, shown, PICTURE) != 0;
    assert_in_range(line.pictures, 0, PICTURES - 1);
    line.picture[line.pictures].number = p->number;
    line.picture[line.pictures].skipped = p->skipped;
    line.picture[line.pictures].moment_ms = p->moment_ms;
    line.picture[line.pictures].echo = line.echo;
    line.picture[line.pictures].key = p->key;
    line.picture[line.pictures++].hello = (uint8_t)line.hellos;
}

static void line_hello(void *context, const char *text, uint32_t length)
{
    (void)context, (void)length;
    assert_string_equal(text, "model");
    line.hellos++;
}

static void line_log(void *context, const char *text, uint32_t length)
{
    (void)context;
    strncat(line.log, text, length);
    strcat(line.log, "\n");
}

static int load(void **state)
{
    (void)state;
    return app_machine_load("tests/scenes/demo.json");
}

static void run(const char *answers)
{
    static const struct hal_link_ops ops = {line_read, line_begin, line_write};
    static const struct frames_events events = {line_picture, line_hello, line_log, NULL};
    const struct board board = {.name = "model",
                                .display = &display,
                                .width = WIDTH,
                                .height = HEIGHT,
                                .band_rows = BAND_ROWS,
                                .format = HAL_RGB565,
                                .pack = &pack_rgb565,
                                .band = {bands[0], bands[1]},
                                .memory = memory,
                                .memory_bytes = sizeof memory,
                                .link = &line.link,
                                .last = (uint8_t *)last,
                                .log = stream_log};
    struct app_start start;
    app_usual(&start);
    start.pictures = (uint32_t)strlen(answers) - (fails_in != 0);
    start.step_us = 40000;
    line.link.ops = &ops;
    start.control.running = !line.still;
    strcpy(line.answers, answers);
    line.frames.events = events;
    frames_open(&line.frames, &events);
    reports[0] = 0;
    assert_int_equal(app_run(&board, &start), 0);
    assert_int_equal(line.begun, strlen(answers));
    assert_int_equal(line.wrong, 0);
    frames_close(&line.frames);
}

static int forget(void **state)
{
    (void)state;
    memset(&line, 0, sizeof line);
    return 0;
}

static void say(enum stream_type type, uint32_t value, uint16_t sequence)
{
    port_message(line.says + line.says_count, type, value, sequence);
    line.says_count += STREAM_HEADER;
}

static void every_picture_is_streamed_as_it_is_shown(void **state)
{
    (void)state;
    run("!+++++++");
    assert_int_equal(line.pictures, 8);
    assert_int_equal(line.hellos, 1);
    for (uint32_t i = 0; i < 8; i++) {
        assert_int_equal(line.picture[i].number, i);
        assert_int_equal(line.picture[i].key, i == 0);
        assert_int_equal(line.picture[i].moment_ms, 40 * i);
        assert_int_equal(line.picture[i].skipped, 0);
    }
    assert_in_range(line.longest, 100, MOST);
    assert_int_equal(line.frames.lost, 0);
}

/* Those that follow refer to the last one that was sent, not to the last one shown. */
static void what_is_left_out_is_counted_and_spoils_nothing(void **state)
{
    (void)state;
    run("!+--+-+");
    assert_int_equal(line.pictures, 4);
    static const uint32_t moments[] = {0, 40, 160, 240}, skipped[] = {0, 0, 2, 3};
    for (uint32_t i = 0; i < 4; i++) {
        assert_int_equal(line.picture[i].number, i);
        assert_int_equal(line.picture[i].key, i == 0);
        assert_int_equal(line.picture[i].moment_ms, moments[i]);
        assert_int_equal(line.picture[i].skipped, skipped[i]);
    }
    assert_int_equal(line.frames.lost, 0);
}

static void who_comes_again_begins_with_hello_and_a_key_frame(void **state)
{
    (void)state;
    run("!+-!++");
    assert_int_equal(line.pictures, 5);
    assert_int_equal(line.hellos, 2);
    assert_int_equal(line.picture[2].key, 1);
    assert_int_equal(line.picture[2].hello, 2);
    assert_int_equal(line.picture[3].key, 0);
}

/* At every byte: the picture is lost, the next is a key frame, and none is wrong. */
static void a_link_that_breaks_in_a_picture_loses_that_one(void **state)
{
    (void)state;
    for (uint32_t after = 0; after < MOST; after += 37) {
        forget(NULL);
        line.breaks_in = 3;
        line.breaks_after = after;
        run("!++++");
        if (line.pictures == 5) {
            assert_true(after > 200);
            return;
        }
        assert_int_equal(line.pictures, 4);
        assert_int_equal(line.picture[2].key, 1);
        assert_int_equal(line.picture[3].key, 0);
    }
    fail_msg("no picture was short enough");
}

/* At every band: what has come of the picture is of no use, and nothing refers to it. */
static void a_display_that_fails_in_a_picture_loses_that_one(void **state)
{
    (void)state;
    for (uint32_t y = 0; y < HEIGHT; y += BAND_ROWS) {
        forget(NULL);
        fails_in = 3;
        fails_at = y;
        run("!+++++");
        assert_int_equal(line.pictures, y + BAND_ROWS < HEIGHT ? 5 : 6);
        assert_int_equal(line.picture[2].key, y + BAND_ROWS < HEIGHT);
        assert_int_equal(line.picture[3].key, y + BAND_ROWS >= HEIGHT);
    }
}

static void a_key_frame_is_sent_when_asked_for(void **state)
{
    (void)state;
    line.says_at = 2;
    say(STREAM_KEY_PLEASE, 0, 1);
    run("!+-+++");
    assert_int_equal(line.pictures, 5);
    assert_int_equal(line.picture[2].key, 1); /* not forgotten with the one that was left out */
    assert_int_equal(line.picture[2].hello, 2);
    assert_int_equal(line.picture[3].key, 0);
}

static void pictures_echo_the_last_request_of_this_connection(void **state)
{
    (void)state;
    line.says_at = 2;
    say(STREAM_BUTTONS, 0, 7);
    say(STREAM_METHOD, 1, 8);
    run("!+++!+");
    static const uint16_t echoes[] = {0, 0, 8, 8, 0, 0};
    for (int i = 0; i < 6; i++)
        assert_int_equal(line.picture[i].echo, echoes[i]);
}

static void one_who_talks_without_end_stops_nothing(void **state)
{
    (void)state;
    line.talks = 1;
    run("!++++");
    assert_int_equal(line.pictures, 5);
}

static void reports_go_over_the_link_too(void **state)
{
    (void)state;
    line.says_at = 2;
    say(STREAM_BUDGET, 9, 1);
    run("!++++");
    assert_true(strlen(reports) > 60);
    assert_string_equal(line.log, reports);
    assert_non_null(strstr(line.log, "budget 9"));
}

static void without_anybody_there_nothing_is_written(void **state)
{
    (void)state;
    run("0000");
    assert_int_equal(line.pictures, 0);
    assert_int_equal(line.hellos, 0);
}

/* A picture that stands is drawn once; who comes then, or was left behind, gets it nevertheless. */
static void a_standing_picture_reaches_everybody(void **state)
{
    (void)state;
    line.still = 1;
    line.says_at = 2;
    say(STREAM_BUDGET, 9, 1);
    run("0!--+!");
    assert_int_equal(line.pictures, 3);
    for (uint32_t i = 0; i < 3; i++)
        assert_int_equal(line.picture[i].moment_ms, 0);
    assert_int_equal(line.picture[0].hello, 1);
    assert_int_equal(line.picture[1].skipped, 2);
    assert_int_equal(line.picture[2].hello, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(every_picture_is_streamed_as_it_is_shown, forget),
        cmocka_unit_test_setup(what_is_left_out_is_counted_and_spoils_nothing, forget),
        cmocka_unit_test_setup(who_comes_again_begins_with_hello_and_a_key_frame, forget),
        cmocka_unit_test_setup(a_link_that_breaks_in_a_picture_loses_that_one, forget),
        cmocka_unit_test_setup(a_display_that_fails_in_a_picture_loses_that_one, forget),
        cmocka_unit_test_setup(a_key_frame_is_sent_when_asked_for, forget),
        cmocka_unit_test_setup(pictures_echo_the_last_request_of_this_connection, forget),
        cmocka_unit_test_setup(one_who_talks_without_end_stops_nothing, forget),
        cmocka_unit_test_setup(reports_go_over_the_link_too, forget),
        cmocka_unit_test_setup(a_standing_picture_reaches_everybody, forget),
        cmocka_unit_test_setup(without_anybody_there_nothing_is_written, forget),
    };
    return cmocka_run_group_tests(tests, load, NULL);
}

/* SPDX-License-Identifier: MIT */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "apng_case.h"
#include "listen.h"
#include "random.h"
#include "record_case.h"

static void a_single_picture_is_a_film(void **state)
{
    static const uint8_t pixel = 7;
    static const char *const names[] = {"a.png", "a.y4m"};
    const struct frames_picture picture = record_case_picture(&pixel, 1, 1, STREAM_GREY8, 1);
    struct apng_case a;
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct record record = {0};
        assert_int_equal(record_open(&record, names[i]), CLI_DONE);
        assert_int_equal(record_picture(&record, &picture), CLI_DONE);
        assert_int_equal(record_case_files(), i + 1); /* beside its name */
        assert_int_not_equal(access(names[i], F_OK), 0);
        assert_int_equal(record_close(&record, true), CLI_DONE);
        assert_int_equal(record_close(&record, true), CLI_DONE); /* harmless */
        assert_int_equal(record_picture(&record, &picture), CLI_DONE);
        assert_int_equal(record_case_files(), i + 1);
    }
    apng_case_open(&a, "a.png");
    assert_true(a.frames == 1 && apng_case_next(&a) && a.delay_ms == 0 && a.shown[0] == 7);
    assert_false(apng_case_next(&a));
    apng_case_close(&a);
}

static void without_a_picture_or_if_discarded_there_is_no_file(void **state)
{
    static const uint8_t pixel = 7;
    static const char *const names[] = {"a.png", "a.y4m"};
    const struct frames_picture picture = record_case_picture(&pixel, 1, 1, STREAM_GREY8, 1);
    (void)state;
    for (int i = 0; i < 4; i++) {
        struct record record = {0};
        assert_int_equal(record_open(&record, names[i & 1]), CLI_DONE);
        for (int k = 0; k < 3 && i >= 2; k++)
            assert_int_equal(record_picture(&record, &picture), CLI_DONE);
        assert_int_equal(record_close(&record, i < 2), CLI_DONE);
        assert_int_equal(record_case_files(), 0);
    }
}

/* Without standard error; with a path, opens before. */
static int quietly(struct record *record, const char *path, const struct frames_picture *picture)
{
    char said[80];
    const struct listen errors = listen_begin(STDERR_FILENO);
    int code = path ? record_open(record, path) : record_picture(record, picture);
    listen_end(&errors, said, sizeof said);
    return code;
}

static void another_size_or_format_ends_the_film(void **state)
{
    static const uint8_t pixels[12] = {1, 2, 3};
    static const struct frames_picture others[] = {{.pixels = pixels, .width = 3, .height = 1, .format = STREAM_GREY8},
                                                   {.pixels = pixels, .width = 2, .height = 2, .format = STREAM_GREY8},
                                                   {.pixels = pixels, .width = 2, .height = 1, .format = STREAM_GREY4}};
    const struct frames_picture picture = record_case_picture(pixels, 2, 1, STREAM_GREY8, 0);
    struct apng_case a;
    (void)state;
    for (int i = 0; i < 3; i++) {
        struct record record = {0};
        assert_int_equal(record_open(&record, "a.png"), CLI_DONE);
        assert_int_equal(record_picture(&record, &picture), CLI_DONE);
        assert_int_equal(record_picture(&record, &picture), CLI_DONE);
        assert_int_equal(quietly(&record, NULL, &others[i]), CLI_BAD_DATA);
        assert_int_equal(record_picture(&record, &picture), CLI_DONE); /* is not taken */
        apng_case_open(&a, "a.png");
        assert_true(a.frames == 2 && apng_case_next(&a) && apng_case_next(&a) && !apng_case_next(&a));
        apng_case_close(&a);
        assert_int_equal(unlink("a.png"), 0);
    }
    assert_int_equal(record_case_files(), 0);
}

static void a_film_is_told_by_its_ending(void **state)
{
    static const char *const bad[] = {"a.gif", "png", ".png", "a/.png", "a.png/b", "a.png.", "a.PNG", "", "/dev/null"};
    static const char *const good[] = {"a.png", "a.b.apng", "/a/b.y4m", "../.a.png"};
    struct record record = {0};
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_int_equal(quietly(&record, bad[i], NULL), CLI_BAD_USAGE);
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        assert_int_equal(record_open(&record, good[i]), CLI_DONE);
    assert_int_equal(record_close(&record, true), CLI_DONE);
    assert_int_equal(record_case_files(), 0);
}

static void a_film_that_cannot_be_written_leaves_nothing(void **state)
{
    static const char *const names[] = {"a.png", "a.y4m"};
    static uint8_t pixels[128 * 128];
    struct frames_picture picture = record_case_picture(pixels, 128, 128, STREAM_GREY8, 0);
    (void)state;
    random_seed(6);
    for (int i = 0; i < 2; i++) {
        struct record record = {0};
        assert_int_equal(symlink("/dev/full", names[i]), 0);
        assert_int_equal(record_open(&record, names[i]), CLI_DONE);
        int code = CLI_DONE, count = 0;
        for (; count < 9 && !code; count++) {
            for (size_t k = 0; k < sizeof pixels; k++)
                pixels[k] = (uint8_t)random_bits();
            picture.time_us += 20000;
            code = quietly(&record, NULL, &picture);
        }
        assert_int_equal(code, CLI_IO);
        assert_in_range(count, 2, 8); /* a picture of each, and the buffer of the file */
        assert_int_equal(record_close(&record, true), CLI_DONE);
        assert_int_equal(unlink(names[i]), 0);
        assert_int_equal(record_open(&record, "none/a.png"), CLI_DONE);
        assert_int_equal(quietly(&record, NULL, &picture), CLI_IO);
    }
    assert_int_equal(record_case_files(), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        RECORD_CASE(a_single_picture_is_a_film),
        RECORD_CASE(without_a_picture_or_if_discarded_there_is_no_file),
        RECORD_CASE(another_size_or_format_ends_the_film),
        RECORD_CASE(a_film_is_told_by_its_ending),
        RECORD_CASE(a_film_that_cannot_be_written_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

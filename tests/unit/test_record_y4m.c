/* SPDX-License-Identifier: MIT */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "random.h"
#include "record_case.h"

/* Reads a film of grey pictures of `width` by 1; their number. */
static size_t read_y4m(const char *path, const char *head, unsigned width, uint8_t *luma, size_t room)
{
    char line[96];
    size_t count = 0;
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_non_null(fgets(line, sizeof line, file));
    assert_string_equal(line, head);
    while (fgets(line, sizeof line, file)) {
        assert_string_equal(line, "FRAME\n");
        assert_true((count + 1) * width <= room);
        assert_int_equal(fread(luma + count++ * width, 1, width, file), width);
    }
    fclose(file);
    return count;
}

/* A picture's number, in black and white. */
static void number_in_pixels(unsigned number, uint8_t pixels[8])
{
    for (unsigned bit = 0; bit < 8; bit++)
        pixels[bit] = number >> bit & 1 ? 255 : 0;
}

static unsigned pixels_in_number(const uint8_t luma[8])
{
    unsigned number = 0;
    for (unsigned bit = 0; bit < 8; bit++) {
        assert_true(luma[bit] == 16 || luma[bit] == 235);
        number |= (unsigned)(luma[bit] == 235) << bit;
    }
    return number;
}

/* Every picture of the film is the last that begins before its own moment, half a picture's time forgiven. */
static void a_y4m_shows_what_the_device_showed_then(void **state)
{
    enum { COUNT = 200 };
    static uint8_t luma[8 * 4000];
    static const struct {
        uint32_t rate, low, high;
        const char *head;
    } cases[] = {{0, 18000, 22000, "YUV4MPEG2 W8 H1 F60:1 Ip A1:1 Cmono XCOLORRANGE=LIMITED\n"}, /* repeats */
                 {25, 1000, 30000, "YUV4MPEG2 W8 H1 F25:1 Ip A1:1 Cmono XCOLORRANGE=LIMITED\n"}, /* leaves out */
                 {50, 0, 120000, "YUV4MPEG2 W8 H1 F50:1 Ip A1:1 Cmono XCOLORRANGE=LIMITED\n"}};
    (void)state;
    random_seed(3);
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++) {
        double begins[COUNT + 1], rate = cases[c].rate ? cases[c].rate : 60;
        struct record record = {.rate = cases[c].rate};
        uint32_t first = 4294000000u, at = 0, gap = 0;
        assert_int_equal(record_open(&record, "a.y4m"), CLI_DONE);
        for (unsigned i = 0; i < COUNT; i++) {
            uint8_t pixels[8];
            struct frames_picture picture = record_case_picture(pixels, 8, 1, STREAM_GREY8, first + at);
            number_in_pixels(i, pixels);
            assert_int_equal(record_picture(&record, &picture), CLI_DONE);
            begins[i] = at * 1e-6;
            gap = i < COUNT - 1 ? (uint32_t)random_between((int)cases[c].low, (int)cases[c].high) : gap;
            at += gap;
        }
        begins[COUNT] = at * 1e-6; /* the last lasts as long as the one before */
        assert_int_equal(record_close(&record, true), CLI_DONE);
        size_t count = read_y4m("a.y4m", cases[c].head, 8, luma, sizeof luma);
        size_t ends = (size_t)floor(begins[COUNT] * rate + .5);
        size_t least = (size_t)floor(begins[COUNT - 1] * rate + .5) + 1;
        assert_int_equal(count, ends > least ? ends : least);
        for (size_t n = 0, shown = 0; n < count; n++) {
            while (shown + 1 < COUNT && begins[shown + 1] * rate <= (double)n + .5)
                shown++;
            assert_int_equal(pixels_in_number(luma + 8 * n), shown);
        }
    }
}

/* At the film's own rate, with times that are off by up to a third of a picture, none is left out or repeated. */
static void a_y4m_takes_irregular_times_as_regular(void **state)
{
    static uint8_t luma[8 * 256];
    struct record record = {0};
    (void)state;
    random_seed(4);
    assert_int_equal(record_open(&record, "a.y4m"), CLI_DONE);
    for (unsigned i = 0; i < 250; i++) {
        uint8_t pixels[8];
        uint32_t time = i * 1000000u / 60 + (i ? (uint32_t)random_between(-5000, 5000) : 0);
        struct frames_picture picture = record_case_picture(pixels, 8, 1, STREAM_GREY8, time);
        number_in_pixels(i, pixels);
        assert_int_equal(record_picture(&record, &picture), CLI_DONE);
    }
    assert_int_equal(record_close(&record, true), CLI_DONE);
    size_t count = read_y4m("a.y4m", "YUV4MPEG2 W8 H1 F60:1 Ip A1:1 Cmono XCOLORRANGE=LIMITED\n", 8, luma, sizeof luma);
    assert_in_range(count, 250, 251); /* the last may last longer */
    for (size_t n = 0; n < 250; n++)
        assert_int_equal(pixels_in_number(luma + 8 * n), n);
}

/* ITU-R BT.601-7, 2.5.1 to 2.5.3, in double precision: no sample is off by more than its rounding and 1/100. */
static void a_y4ms_colours_are_those_of_bt601(void **state)
{
    enum { SIDE = 256 };
    static uint8_t rgb[3 * SIDE * SIDE], planes[3 * SIDE * SIDE];
    struct frames_picture picture = record_case_picture(rgb, SIDE, SIDE, STREAM_RGB888, 0);
    struct record record = {0};
    char line[96];
    (void)state;
    random_seed(5);
    for (size_t i = 0; i < sizeof rgb; i++)
        rgb[i] = (uint8_t)random_bits();
    assert_int_equal(record_open(&record, "a.y4m"), CLI_DONE);
    assert_int_equal(record_picture(&record, &picture), CLI_DONE);
    assert_int_equal(record_close(&record, true), CLI_DONE);
    FILE *file = fopen("a.y4m", "rb");
    assert_non_null(fgets(line, sizeof line, file));
    assert_string_equal(line, "YUV4MPEG2 W256 H256 F60:1 Ip A1:1 C444 XCOLORRANGE=LIMITED\n");
    assert_non_null(fgets(line, sizeof line, file));
    assert_int_equal(fread(planes, 1, sizeof planes, file), sizeof planes);
    assert_int_equal(fgetc(file), EOF);
    fclose(file);
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        double r = rgb[3 * i] / 255., g = rgb[3 * i + 1] / 255., b = rgb[3 * i + 2] / 255.;
        double y = .299 * r + .587 * g + .114 * b;
        const double want[3] = {16 + 219 * y, 128 + 224 * (b - y) / 1.772, 128 + 224 * (r - y) / 1.402};
        for (int plane = 0; plane < 3; plane++)
            assert_true(fabs(planes[plane * SIDE * SIDE + i] - want[plane]) < .51);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        RECORD_CASE(a_y4m_shows_what_the_device_showed_then),
        RECORD_CASE(a_y4m_takes_irregular_times_as_regular),
        RECORD_CASE(a_y4ms_colours_are_those_of_bt601),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

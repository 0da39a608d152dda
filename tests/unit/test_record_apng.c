/* SPDX-License-Identifier: MIT */
#include "view/unpack.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "apng_case.h"
#include "random.h"
#include "record_case.h"

enum { W = 37, H = 11, BYTES = 3 * W * H };

/* A picture of its bytes, W by H, as shown. */
static void widen(enum stream_format format, const uint8_t *pixels, uint8_t *shown)
{
    size_t stride = unpack_row_bytes(format, W), samples = host_display_samples((enum hal_pixel_format)format);
    for (size_t y = 0; y < H; y++)
        host_display_widen((enum hal_pixel_format)format, pixels + y * stride, W, shown + y * W * samples);
}

/* All bytes, those of a rectangle, a few there, one, or none. */
static void change(uint8_t *pixels, enum stream_format format)
{
    int stride = (int)unpack_row_bytes(format, W), kind = random_between(0, 4);
    int left = random_between(0, stride - 1), top = random_between(0, H - 1);
    int right = kind == 1 ? left : random_between(left, stride - 1),
        bottom = kind == 1 ? top : random_between(top, H - 1);
    if (kind == 2)
        left = top = 0, right = stride - 1, bottom = H - 1;
    for (int y = top; y <= bottom && kind; y++)
        for (int x = left; x <= right; x++)
            if (kind != 3 || random_between(0, 9) == 0)
                pixels[y * stride + x] = (uint8_t)random_bits();
    for (int y = 0; y < H && format == STREAM_GREY4; y++) /* nobody sees the last half byte */
        pixels[y * stride + stride - 1] &= 0xF0;
}

/* No column and no row of the part is as it was, except that a byte of GREY4 is two columns; and there is always one.
 */
static void check_part(const struct apng_case *a, const uint8_t *before, enum stream_format format)
{
    uint32_t left = W, right = 0, top = H, bottom = 0, pair = format == STREAM_GREY4 ? 2 : 1;
    for (uint32_t y = 0; y < H; y++)
        for (uint32_t x = 0; x < W; x++)
            if (memcmp(a->shown + (y * W + x) * a->samples, before + (y * W + x) * a->samples, a->samples)) {
                left = x < left ? x : left;
                right = x >= right ? x + 1 : right;
                top = y < top ? y : top;
                bottom = y + 1;
            }
    if (left == W)
        left = top = 0, right = bottom = 1;
    left -= left % pair;
    right += right % pair;
    right = right < W ? right : W;
    assert_int_equal(a->x, left);
    assert_int_equal(a->part_width, right - left);
    assert_int_equal(a->y, top);
    assert_int_equal(a->part_height, bottom - top);
}

static void animated_png_in(enum stream_format format, const char *path)
{
    enum { COUNT = 60 };
    static uint8_t shown[COUNT][BYTES];
    uint8_t pixels[BYTES], before[BYTES] = {0};
    uint32_t at[COUNT + 1] = {0}, time = UINT32_MAX - 500000; /* runs over on the way */
    struct record record = {0};
    struct apng_case a;
    for (size_t i = 0; i < sizeof pixels; i++)
        pixels[i] = (uint8_t)random_bits();
    assert_int_equal(record_open(&record, path), CLI_DONE);
    for (int i = 0; i < COUNT; i++) {
        struct frames_picture picture = record_case_picture(pixels, W, H, format, time + at[i]);
        change(pixels, format);
        widen(format, pixels, shown[i]);
        assert_int_equal(record_picture(&record, &picture), CLI_DONE);
        at[i + 1] = at[i] + (i < COUNT - 1 ? (uint32_t)random_between(0, 40000) : at[i] - at[i - 1]);
    }
    assert_int_equal(record_close(&record, true), CLI_DONE);
    apng_case_open(&a, path);
    assert_true(a.width == W && a.height == H && a.frames == COUNT);
    for (int i = 0; i < COUNT; i++) {
        assert_true(apng_case_next(&a));
        assert_memory_equal(a.shown, shown[i], (size_t)W * H * a.samples);
        assert_int_equal(a.delay_ms, (at[i + 1] + 500) / 1000 - (at[i] + 500) / 1000);
        if (i)
            check_part(&a, before, format);
        memcpy(before, a.shown, (size_t)W * H * a.samples);
    }
    assert_false(apng_case_next(&a));
    apng_case_close(&a);
}

static void an_animated_png_gives_back_every_picture_and_moment(void **state)
{
    (void)state;
    random_seed(1);
    animated_png_in(STREAM_RGB565, "a.png");
    animated_png_in(STREAM_RGB888, "b.apng");
    animated_png_in(STREAM_GREY8, "c.png");
    animated_png_in(STREAM_GREY4, "d.png");
    assert_int_equal(record_case_files(), 4);
}

/* Five pictures' times; how long each lasts. */
static void check_delays(const uint32_t times[5], const uint32_t delays[5])
{
    static const uint8_t pixel = 1;
    struct record record = {0};
    struct apng_case a;
    assert_int_equal(record_open(&record, "a.png"), CLI_DONE);
    for (int i = 0; i < 5; i++) {
        struct frames_picture picture = record_case_picture(&pixel, 1, 1, STREAM_GREY8, times[i]);
        assert_int_equal(record_picture(&record, &picture), CLI_DONE);
    }
    assert_int_equal(record_close(&record, true), CLI_DONE);
    apng_case_open(&a, "a.png");
    for (int i = 0; i < 5; i++) {
        assert_true(apng_case_next(&a));
        assert_int_equal(a.delay_ms, delays[i]);
    }
    assert_false(apng_case_next(&a));
    apng_case_close(&a);
}

static void moments_are_rounded_not_the_time_between(void **state)
{
    (void)state;
    check_delays((uint32_t[]){0, 1400, 2800, 4200, 5600}, (uint32_t[]){1, 2, 1, 2, 1});
}

static void a_gap_and_a_device_that_began_anew_are_cut(void **state)
{
    (void)state;
    check_delays((uint32_t[]){5000, 3000005000u, 3000015000u, 20, 30020}, (uint32_t[]){2000, 10, 2000, 30, 30});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        RECORD_CASE(an_animated_png_gives_back_every_picture_and_moment),
        RECORD_CASE(moments_are_rounded_not_the_time_between),
        RECORD_CASE(a_gap_and_a_device_that_began_anew_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* A stream's picture as the window takes it: every format as its PNG has it, each way round. */
#include "view/pixels.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { WIDTH = 3, HEIGHT = 2, STRIDE = 5, BEHIND = 0x1234 };

static const uint8_t grey[] = {0, 1, 2, 3, 4, 5};
static const struct frames_picture picture = {.pixels = grey, .width = WIDTH, .height = HEIGHT, .format = STREAM_GREY8};

static uint32_t shade(unsigned grey_level)
{
    return 0xFF000000u | grey_level * 0x010101u;
}

/* `rows`: the levels as they must stand. */
static void turned(unsigned rotation, unsigned width, unsigned height, const uint8_t *rows)
{
    uint32_t out[STRIDE * STRIDE];
    for (unsigned i = 0; i < STRIDE * STRIDE; i++)
        out[i] = BEHIND;
    assert_int_equal(pixels_width(&picture, rotation), width);
    assert_int_equal(pixels_height(&picture, rotation), height);
    pixels_turn(&picture, rotation, out, STRIDE);
    for (unsigned y = 0; y < STRIDE; y++)
        for (unsigned x = 0; x < STRIDE; x++)
            assert_int_equal(out[y * STRIDE + x], x < width && y < height ? shade(rows[y * width + x]) : BEHIND);
}

static void a_picture_turns_clockwise(void **state)
{
    (void)state;
    turned(0, 3, 2, (const uint8_t[]){0, 1, 2, 3, 4, 5});
    turned(1, 2, 3, (const uint8_t[]){3, 0, 4, 1, 5, 2});
    turned(2, 3, 2, (const uint8_t[]){5, 4, 3, 2, 1, 0});
    turned(3, 2, 3, (const uint8_t[]){2, 5, 1, 4, 0, 3});
}

static void every_format_is_widened_as_in_a_file(void **state)
{
    static const uint8_t rgb565[] = {0x1F, 0x00, 0xE0, 0x07, 0x00, 0xF8, 0x10, 0x84},
                         rgb888[] = {1, 2, 3, 250, 251, 252};
    static const uint8_t grey4[] = {0x0F, 0x70};
    uint32_t out[4];
    (void)state;
    struct frames_picture p = {.pixels = rgb565, .width = 4, .height = 1, .format = STREAM_RGB565};
    pixels_turn(&p, 0, out, 4);
    assert_int_equal(out[0], 0xFF0000FF);
    assert_int_equal(out[1], 0xFF00FF00);
    assert_int_equal(out[2], 0xFFFF0000);
    assert_int_equal(out[3], 0xFF848284);
    p = (struct frames_picture){.pixels = rgb888, .width = 2, .height = 1, .format = STREAM_RGB888};
    pixels_turn(&p, 2, out, 2);
    assert_int_equal(out[0], 0xFFFAFBFC);
    assert_int_equal(out[1], 0xFF010203);
    p = (struct frames_picture){.pixels = grey4, .width = 3, .height = 1, .format = STREAM_GREY4};
    pixels_turn(&p, 1, out, 1);
    assert_int_equal(out[0], shade(0));
    assert_int_equal(out[1], shade(255));
    assert_int_equal(out[2], shade(0x77));
}

static void the_largest_picture_fits(void **state)
{
    static uint8_t pixels[2048 * 3 * 2];
    static uint32_t out[2048 * 2];
    const struct frames_picture p = {.pixels = pixels, .width = 2048, .height = 2, .format = STREAM_RGB888};
    (void)state;
    pixels[2048 * 3 * 2 - 1] = 9;
    pixels_turn(&p, 3, out, 2);
    assert_int_equal(out[1], 0xFF000009);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_picture_turns_clockwise),
                                       cmocka_unit_test(every_format_is_widened_as_in_a_file),
                                       cmocka_unit_test(the_largest_picture_fits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

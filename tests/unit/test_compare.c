/* SPDX-License-Identifier: MIT */
#include "compare/compare.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct image picture(unsigned width, unsigned height, uint8_t grey)
{
    struct image image = {width, height, malloc((size_t)3 * width * height)};
    memset(image.rgb, grey, (size_t)3 * width * height);
    return image;
}

static void assert_close(double a, double b)
{
    if (!(fabs(a - b) < 1e-9))
        fail_msg("%.12f is not %.12f", a, b);
}

static void equal_pictures_have_no_error(void **state)
{
    struct image a = picture(4, 4, 0);
    struct compare_result result;
    (void)state;
    a.rgb[3 * 5] = 9;
    compare_images(&a, &a, NULL, &result);
    assert_int_equal(result.pixels, 1);
    assert_true(isinf(result.psnr_db));
    assert_close(result.rms + result.max + result.p999, 0);
    image_free(&a);
}

/* Two pixels differ, by 3 in one channel and by 4 in all; three are covered: mean square (9 + 48) / 9. */
static void figures_are_those_of_the_covered_pixels(void **state)
{
    struct image a = picture(10, 10, 20), b = picture(10, 10, 20);
    struct compare_result result;
    (void)state;
    a.rgb[3 * 55] = 103, b.rgb[3 * 55] = 100;
    a.rgb[3 * 56] = 50, b.rgb[3 * 56] = 50;
    for (int c = 0; c < 3; c++)
        b.rgb[3 * 57 + c] = 24; /* only b covers it */
    compare_images(&a, &b, NULL, &result);
    assert_int_equal(result.pixels, 3);
    assert_close(result.rms, sqrt(57. / 9));
    assert_close(result.psnr_db, 10 * log10(255 * 255 * 9. / 57));
    assert_close(result.max, 4);
    assert_close(result.p999, 4);
    image_free(&a);
    image_free(&b);
}

/* The same scene on another display has another background; that is no difference. */
static void each_picture_has_its_own_background(void **state)
{
    struct image a = picture(10, 10, 20), b = picture(10, 10, 16);
    struct compare_result result;
    const uint8_t black[3] = {0};
    (void)state;
    a.rgb[3 * 55] = b.rgb[3 * 55] = 99;
    compare_images(&a, &b, NULL, &result);
    assert_int_equal(result.pixels, 1);
    compare_images(&a, &b, black, &result);
    assert_int_equal(result.pixels, 100);
    image_free(&a);
    image_free(&b);
}

static void the_background_is_the_most_frequent_corner(void **state)
{
    struct image a = picture(5, 4, 7);
    uint8_t rgb[3];
    (void)state;
    memset(a.rgb, 200, 3);
    memset(a.rgb + 3 * 19, 201, 3);
    compare_background(&a, rgb);
    assert_memory_equal(rgb, "\7\7\7", 3);
    image_free(&a);
}

/* Of 2000 pixels one may differ more than p999, of 1999 too, of 3000 three. */
static void p999_leaves_out_one_pixel_in_a_thousand(void **state)
{
    static double zero[3000], values[3000];
    static uint8_t mask[3000];
    struct compare_result result;
    (void)state;
    memset(mask, 1, sizeof mask);
    values[0] = 50, values[1] = 40, values[2] = 30, values[3] = 20;
    compare_values(zero, values, mask, 3000, 1, &result);
    assert_close(result.max, 50);
    assert_close(result.p999, 20);
    compare_values(zero, values, mask, 2000, 1, &result);
    assert_close(result.p999, 30);
    compare_values(zero, values, mask, 1999, 1, &result);
    assert_close(result.p999, 40);
    mask[0] = 0;
    compare_values(zero, values, mask, 1000, 1, &result);
    assert_close(result.max, 40);
    assert_close(result.p999, 40);
}

static void nothing_covered_is_no_error(void **state)
{
    struct image a = picture(2, 2, 1);
    struct compare_result result;
    (void)state;
    compare_images(&a, &a, NULL, &result);
    assert_int_equal(result.pixels, 0);
    assert_true(isinf(result.psnr_db));
    image_free(&a);
}

/* Neither covers anything, and yet they are not alike; one background given for both says that it is none for one. */
static void pictures_of_two_colours_differ_everywhere(void **state)
{
    struct image a = picture(4, 3, 0), b = picture(4, 3, 255);
    struct compare_result result;
    const uint8_t white[3] = {255, 255, 255};
    (void)state;
    for (int given = 0; given < 2; given++) {
        compare_images(&a, &b, given ? white : NULL, &result);
        assert_int_equal(result.pixels, 12);
        assert_close(result.max, 255);
        assert_close(result.p999, 255);
        assert_close(result.psnr_db, 0);
    }
    image_free(&a);
    image_free(&b);
}

/* What lies between two whole steps counts as the upper one. */
static void p999_of_values_is_rounded_up(void **state)
{
    const double a[3] = {1, 2, 3}, b[3] = {1.25, 2, 3};
    const uint8_t mask[3] = {1, 1, 1};
    struct compare_result result;
    (void)state;
    compare_values(a, b, mask, 3, 1, &result);
    assert_close(result.max, .25);
    assert_close(result.p999, 1);
}

static void a_difference_is_amplified_around_grey(void **state)
{
    struct image a = picture(1, 1, 100), b = picture(1, 1, 100);
    uint8_t rgb[3];
    (void)state;
    b.rgb[1] = 103, b.rgb[2] = 70;
    compare_difference(&a, &b, rgb);
    assert_int_equal(rgb[0], 128);
    assert_int_equal(rgb[1], 152);
    assert_int_equal(rgb[2], 0);
    image_free(&a);
    image_free(&b);
}

/* A 3 x 3 PNG of any kind, all rows alike. */
static void write_png(const char *path, int depth, int type, int interlace, const uint8_t *row)
{
    static const png_color palette[4] = {{1, 2, 3}, {40, 50, 60}, {255, 0, 128}, {9, 9, 9}};
    png_bytep rows[3];
    FILE *file = fopen(path, "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)))
        fail();
    png_init_io(png, file);
    png_set_IHDR(png, info, 3, 3, depth, type, interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (type == PNG_COLOR_TYPE_PALETTE)
        png_set_PLTE(png, info, palette, 4);
    for (int i = 0; i < 3; i++)
        rows[i] = (png_bytep)(uintptr_t)row;
    png_set_rows(png, info, rows);
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, NULL);
    png_destroy_write_struct(&png, &info);
    fclose(file);
}

static void every_kind_of_png_is_read_as_rgb(void **state)
{
    static const struct {
        int depth, type, interlace;
        uint8_t row[24], rgb[9];
    } kinds[] = {
        {1, PNG_COLOR_TYPE_GRAY, 0, {0xA0}, {255, 255, 255, 0, 0, 0, 255, 255, 255}},
        {4, PNG_COLOR_TYPE_GRAY, 1, {0x1F, 0x80}, {17, 17, 17, 255, 255, 255, 136, 136, 136}},
        {8, PNG_COLOR_TYPE_GRAY, 0, {1, 2, 200}, {1, 1, 1, 2, 2, 2, 200, 200, 200}},
        {16, PNG_COLOR_TYPE_GRAY, 0, {1, 1, 0x80, 0x80, 0xFF, 0xFF}, {1, 1, 1, 128, 128, 128, 255, 255, 255}},
        {8, PNG_COLOR_TYPE_GRAY_ALPHA, 1, {7, 0, 8, 255, 9, 128}, {7, 7, 7, 8, 8, 8, 9, 9, 9}},
        {2, PNG_COLOR_TYPE_PALETTE, 0, {0x18}, {1, 2, 3, 40, 50, 60, 255, 0, 128}},
        {8, PNG_COLOR_TYPE_RGB, 1, {1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 3, 4, 5, 6, 7, 8, 9}},
        {8, PNG_COLOR_TYPE_RGB_ALPHA, 0, {1, 2, 3, 0, 4, 5, 6, 255, 7, 8, 9, 128}, {1, 2, 3, 4, 5, 6, 7, 8, 9}},
        {16,
         PNG_COLOR_TYPE_RGB,
         0,
         {1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9},
         {1, 2, 3, 4, 5, 6, 7, 8, 9}},
    };
    char path[] = "/tmp/glint-compare-XXXXXX";
    (void)state;
    close(mkstemp(path));
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct image image;
        write_png(path, kinds[i].depth, kinds[i].type, kinds[i].interlace, kinds[i].row);
        assert_int_equal(image_read_png(path, &image), 0);
        assert_int_equal(image.width, 3);
        assert_int_equal(image.height, 3);
        for (int row = 0; row < 3; row++)
            assert_memory_equal(image.rgb + 9 * row, kinds[i].rgb, 9);
        image_free(&image);
    }
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_pictures_have_no_error),
        cmocka_unit_test(figures_are_those_of_the_covered_pixels),
        cmocka_unit_test(each_picture_has_its_own_background),
        cmocka_unit_test(the_background_is_the_most_frequent_corner),
        cmocka_unit_test(p999_leaves_out_one_pixel_in_a_thousand),
        cmocka_unit_test(nothing_covered_is_no_error),
        cmocka_unit_test(pictures_of_two_colours_differ_everywhere),
        cmocka_unit_test(p999_of_values_is_rounded_up),
        cmocka_unit_test(a_difference_is_amplified_around_grey),
        cmocka_unit_test(every_kind_of_png_is_read_as_rgb),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Pictures inside a page: what a browser would show of them. */
#include "report/picture.h"

#include "compare/image.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "pack_case.h"
#include "random.h"

enum { WIDTH = 41, HEIGHT = 23, STRIDE = 64 };

static unsigned digit(char c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = strchr(digits, c);
    assert_true(c && at);
    return (unsigned)(at - digits);
}

/* The bytes behind the comma up to the quote; returns how many. */
static size_t decode(const char *text, uint8_t *bytes)
{
    size_t size = 0;
    for (; *text != '"'; text += 4) {
        uint32_t group = digit(text[0]) << 18 | digit(text[1]) << 12;
        unsigned count = text[2] == '=' ? 1 : text[3] == '=' ? 2 : 3;
        group |= count > 1 ? digit(text[2]) << 6 : 0;
        group |= count > 2 ? digit(text[3]) : 0;
        for (unsigned i = 0; i < count; i++)
            bytes[size++] = (uint8_t)(group >> (16 - 8 * i));
    }
    return size;
}

/* Writes a picture and reads it back. */
static void show(const struct picture *picture, struct image *image)
{
    static uint8_t bytes[1 << 16];
    struct case_file file;
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    assert_true(picture_write(out, picture, "a caption"));
    assert_int_equal(fclose(out), 0);
    assert_non_null(strstr(text, "<img loading=\"lazy\" width=\"41\" height=\"23\" alt=\"a caption\" src=\"data:"));
    const char *data = strstr(text, "base64,");
    assert_non_null(data);
    size = decode(data + strlen("base64,"), bytes);
    case_write(&file, "a.png", bytes, size);
    assert_int_equal(image_read_png(file.path, image), 0);
    assert_int_equal(image->width, WIDTH);
    assert_int_equal(image->height, HEIGHT);
    case_remove(&file);
    free(text);
}

static void greys_come_back(void **state)
{
    static uint8_t pixels[HEIGHT * STRIDE];
    struct image image;
    (void)state;
    random_seed(1);
    for (size_t i = 0; i < sizeof pixels; i++)
        pixels[i] = (uint8_t)random_bits();
    show(&(struct picture){pixels + 3, STRIDE, WIDTH, HEIGHT, PICTURE_GREY}, &image);
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++)
            for (int c = 0; c < 3; c++)
                assert_int_equal(image.rgb[3 * (y * WIDTH + x) + c], pixels[3 + y * STRIDE + x]);
    image_free(&image);
}

static void colours_come_back(void **state)
{
    static uint8_t pixels[HEIGHT * 3 * STRIDE];
    struct image image;
    (void)state;
    random_seed(3);
    for (size_t i = 0; i < sizeof pixels; i++)
        pixels[i] = (uint8_t)random_bits();
    show(&(struct picture){pixels, 3 * STRIDE, WIDTH, HEIGHT, PICTURE_RGB}, &image);
    for (unsigned y = 0; y < HEIGHT; y++)
        assert_memory_equal(image.rgb + 3 * (size_t)y * WIDTH, pixels + 3 * (size_t)y * STRIDE, 3 * WIDTH);
    image_free(&image);
}

static void levels_come_back_in_their_colours(void **state)
{
    static uint8_t pixels[HEIGHT * STRIDE];
    struct image image;
    (void)state;
    random_seed(2);
    for (size_t i = 0; i < sizeof pixels; i++)
        pixels[i] = (uint8_t)random_between(0, 2 * PICTURE_LEVELS);
    show(&(struct picture){pixels, STRIDE, WIDTH, HEIGHT, PICTURE_DIFFERENCE}, &image);
    for (unsigned y = 0; y < HEIGHT; y++)
        for (unsigned x = 0; x < WIDTH; x++) {
            uint8_t rgb[3];
            picture_colour(pixels[y * STRIDE + x] - PICTURE_RIGHT, rgb);
            assert_memory_equal(image.rgb + 3 * (y * WIDTH + x), rgb, 3);
        }
    image_free(&image);
}

static void a_level_is_an_octave(void **state)
{
    static const double from[PICTURE_LEVELS + 1] = {0, .5, 1, 2, 4, 8, 16, 32};
    (void)state;
    for (int level = 0; level <= PICTURE_LEVELS; level++) {
        double end = nextafter(level < PICTURE_LEVELS ? from[level + 1] : 256, 0);
        assert_int_equal(picture_level(from[level]), level);
        assert_int_equal(picture_level(end), level);
        assert_int_equal(picture_level(-from[level]), -level);
        assert_int_equal(picture_level(-end), -level);
    }
}

static void larger_is_brighter_and_the_sign_is_seen(void **state)
{
    uint8_t last[2] = {0}, rgb[3];
    (void)state;
    picture_colour(0, rgb);
    assert_memory_equal(rgb, "\0\0\0", 3);
    for (int level = 1; level <= PICTURE_LEVELS; level++) {
        picture_colour(level, rgb);
        assert_true(rgb[0] > last[0] + 20 && rgb[0] > 2 * rgb[2]);
        last[0] = rgb[0];
        picture_colour(-level, rgb);
        assert_true(rgb[2] > last[1] + 20 && rgb[2] > 2 * rgb[0]);
        last[1] = rgb[2];
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(greys_come_back),
        cmocka_unit_test(colours_come_back),
        cmocka_unit_test(levels_come_back_in_their_colours),
        cmocka_unit_test(a_level_is_an_octave),
        cmocka_unit_test(larger_is_brighter_and_the_sign_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

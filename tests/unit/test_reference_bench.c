/* SPDX-License-Identifier: MIT */
/* Ideal arithmetic on the benchmark's scenes gives the figures that were computed for them independently. */
#include "compare/compare.h"
#include "pack/pack.h"
#include "reference/method.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>

static void draw(const char *path, unsigned shininess, enum reference_method method, bool grey,
                 struct reference_image *image)
{
    const struct pack_options pack = {.shininess = shininess};
    const struct reference_options options = {.method = method, .grey = grey, .every_zigzag = true};
    struct pack_result packed;
    assert_int_equal(pack_load(path, &pack, &packed), PACK_OK);
    assert_true(reference_render(packed.scene, &options, image));
    for (size_t i = 0; i < (size_t)image->width * image->height * image->channels; i++)
        image->value[i] *= 255;
    pack_free(&packed);
}

/* The known counts are without snapping to 1/16 pixel, which moves a handful of pixels at the outline. */
static void check_coverage(const char *path, size_t pixels)
{
    struct reference_image image;
    draw(path, 0, REFERENCE_PHONG, false, &image);
    assert_in_range(image.coverage, pixels - 10, pixels + 10);
    reference_free(&image);
}

static void the_common_scenes_cover_the_known_pixels(void **state)
{
    (void)state;
    check_coverage("tests/scenes/bench-torus288.json", 36007);
    check_coverage("tests/scenes/bench-torus4000.json", 37968);
}

static struct compare_result measure(const char *path, unsigned shininess, enum reference_method method)
{
    struct reference_image truth, image;
    struct compare_result result;
    draw(path, shininess, REFERENCE_PHONG, true, &truth);
    draw(path, shininess, method, true, &image);
    compare_values(image.value, truth.value, truth.covered, (size_t)truth.width * truth.height, 1, &result);
    print_message("%s n %u %s: %.2f dB, largest %.2f\n", path, shininess, methods[method].name, result.psnr_db,
                  result.max);
    reference_free(&truth);
    reference_free(&image);
    return result;
}

#define EXPONENTS 3

struct ideal {
    enum reference_method method;
    struct {
        double psnr_db, max;
    } at[EXPONENTS];
};

/* Figures with one decimal, or none: what rounds to them, plus a tenth for the scene's rounding when packed. */
static void check_ideal(const char *path, const struct ideal *rows, size_t count, const unsigned *exponents, size_t n)
{
    for (size_t i = 0; i < count; i++) {
        for (size_t e = 0; e < n; e++) {
            struct compare_result result = measure(path, exponents[e], rows[i].method);
            assert_true(fabs(result.psnr_db - rows[i].at[e].psnr_db) < .15);
            assert_true(fabs(result.max - rows[i].at[e].max) < (rows[i].at[e].max < 10 ? .1 : .6));
        }
    }
}

static void ideal_arithmetic_gives_the_known_quality(void **state)
{
    static const unsigned exponents[EXPONENTS] = {5, 20, 50};
    static const struct ideal rows[] = {
        {REFERENCE_GOURAUD, {{30.6, 26}, {31.1, 38}, {31.3, 41}}},
        {REFERENCE_X, {{51.4, 2.7}, {48.8, 5.7}, {46.4, 10.6}}},
        {REFERENCE_SIX, {{55.9, 1.9}, {56.7, 1.8}, {55.9, 3.4}}},
        {REFERENCE_COLOR6, {{46.0, 9.5}, {41.3, 14}, {37.7, 29}}},
        {REFERENCE_BIQUADRATIC, {{60.1, 2.5}, {59.0, 3.7}, {59.1, 4.2}}},
        {REFERENCE_OVERVELD_SCAN, {{26.4, 90}, {28.1, 70}, {28.6, 74}}},
        {REFERENCE_SUBDIVIDE_CENTRE, {{46.3, 9.5}, {42.9, 14}, {40.7, 29}}},
        {REFERENCE_HYBRID_PHONG, {{34.1, 26}, {35.5, 23}, {35.5, 23}}},
    };
    (void)state;
    check_ideal("tests/scenes/torus288.json", rows, sizeof rows / sizeof *rows, exponents, EXPONENTS);
}

static void ideal_arithmetic_gives_the_known_quality_in_perspective(void **state)
{
    static const unsigned exponent = 20;
    static const struct ideal rows[] = {
        {REFERENCE_GOURAUD, {{30.8, 38}}}, {REFERENCE_X, {{46.2, 5.3}}},           {REFERENCE_SIX, {{50.3, 4.2}}},
        {REFERENCE_COLOR6, {{40.1, 13}}},  {REFERENCE_BIQUADRATIC, {{51.7, 3.8}}},
    };
    (void)state;
    check_ideal("tests/scenes/torus288-persp.json", rows, sizeof rows / sizeof *rows, &exponent, 1);
    assert_true(fabs(measure("tests/scenes/torus288-persp.json", exponent, REFERENCE_BIQUADRATIC_PERSPECTIVE).psnr_db -
                     59.4) < .15);
}

/* The pictures are not the same, so a decibel either way; interpolated in the picture they lose 2.6 dB and more. */
static void perspective_correct_methods_lose_nothing_to_perspective(void **state)
{
    static const enum reference_method pairs[][2] = {
        {REFERENCE_X, REFERENCE_X_PERSPECTIVE},
        {REFERENCE_SIX, REFERENCE_SIX_PERSPECTIVE},
        {REFERENCE_BIQUADRATIC, REFERENCE_BIQUADRATIC_PERSPECTIVE},
    };
    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        struct compare_result flat = measure("tests/scenes/torus288.json", 20, pairs[i][0]);
        struct compare_result correct = measure("tests/scenes/torus288-persp.json", 20, pairs[i][1]);
        assert_true(fabs(correct.psnr_db - flat.psnr_db) < 1.1);
        assert_true(correct.max < flat.max + .2);
    }
}

/* A light and a viewer far away: the root of Duff's quadratic is the length of the very normal that Phong divides by.
 */
static void duff_is_phong_in_the_picture(void **state)
{
    struct reference_image duff, phong;
    double largest = 0;
    (void)state;
    draw("tests/scenes/torus288-persp.json", 20, REFERENCE_DUFF, true, &duff);
    draw("tests/scenes/torus288-persp.json", 20, REFERENCE_PHONG_SCREEN, true, &phong);
    for (size_t i = 0; i < (size_t)duff.width * duff.height; i++)
        largest = fmax(largest, fabs(duff.value[i] - phong.value[i]));
    assert_true(largest < 1e-10);
    reference_free(&duff);
    reference_free(&phong);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_common_scenes_cover_the_known_pixels),
        cmocka_unit_test(ideal_arithmetic_gives_the_known_quality),
        cmocka_unit_test(ideal_arithmetic_gives_the_known_quality_in_perspective),
        cmocka_unit_test(perspective_correct_methods_lose_nothing_to_perspective),
        cmocka_unit_test(duff_is_phong_in_the_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Ideal arithmetic on the benchmark's scenes gives the figures that were computed for them independently. */
#include "compare/compare.h"
#include "pack/pack.h"
#include "reference/reference.h"

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
    const struct reference_options options = {.method = method, .grey = grey};
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

struct ideal {
    unsigned shininess;
    enum reference_method method;
    double psnr_db, max;
};

/* Figures with one decimal: what rounds to them, plus a tenth for the scene's rounding when packed. */
static void check_ideal(const char *path, const struct ideal *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct reference_image truth, image;
        struct compare_result result;
        draw(path, rows[i].shininess, REFERENCE_PHONG, true, &truth);
        draw(path, rows[i].shininess, rows[i].method, true, &image);
        compare_values(image.value, truth.value, truth.covered, (size_t)truth.width * truth.height, 1, &result);
        print_message("%s n %u method %d: %.2f dB, largest %.2f\n", path, rows[i].shininess, rows[i].method,
                      result.psnr_db, result.max);
        assert_true(fabs(result.psnr_db - rows[i].psnr_db) < .15);
        assert_true(fabs(result.max - rows[i].max) < (rows[i].max < 10 ? .1 : .6));
        reference_free(&truth);
        reference_free(&image);
    }
}

static void ideal_arithmetic_gives_the_known_quality(void **state)
{
    static const struct ideal rows[] = {
        {5, REFERENCE_GOURAUD, 30.6, 26}, {20, REFERENCE_GOURAUD, 31.1, 38}, {50, REFERENCE_GOURAUD, 31.3, 41},
        {5, REFERENCE_X, 51.4, 2.7},      {20, REFERENCE_X, 48.8, 5.7},      {50, REFERENCE_X, 46.4, 10.6},
        {5, REFERENCE_SIX, 55.9, 1.9},    {20, REFERENCE_SIX, 56.7, 1.8},    {50, REFERENCE_SIX, 55.9, 3.4},
    };
    (void)state;
    check_ideal("tests/scenes/torus288.json", rows, sizeof rows / sizeof *rows);
}

static void ideal_arithmetic_gives_the_known_quality_in_perspective(void **state)
{
    static const struct ideal rows[] = {
        {20, REFERENCE_GOURAUD, 30.8, 38}, {20, REFERENCE_X, 46.2, 5.3}, {20, REFERENCE_SIX, 50.3, 4.2}};
    (void)state;
    check_ideal("tests/scenes/torus288-persp.json", rows, sizeof rows / sizeof *rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_common_scenes_cover_the_known_pixels),
        cmocka_unit_test(ideal_arithmetic_gives_the_known_quality),
        cmocka_unit_test(ideal_arithmetic_gives_the_known_quality_in_perspective),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

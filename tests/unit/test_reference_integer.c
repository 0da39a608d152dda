/* SPDX-License-Identifier: MIT */
/* The integer renderer against double precision that is not rounded: the same pixels, and close values. */
#include "compare/compare.h"
#include "glint/renderer.h"
#include "pack/pack.h"
#include "reference/method.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A display that keeps the picture in 8-bit grey. */
struct keeper {
    struct hal_display display;
    unsigned width;
    double *value;
};

static int keep(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct keeper *keeper = (struct keeper *)display;
    for (unsigned row = 0; row < rows; row++)
        for (unsigned x = 0; x < keeper->width; x++)
            keeper->value[(y + row) * keeper->width + x] = ((const uint8_t *)pixels)[row * stride + x];
    return 0;
}

static const struct hal_display_ops keeper_ops = {.flush = keep};

/* Both pictures of a scene on black, in 1/255, and how they differ. */
static struct compare_result measure(const char *path, unsigned shininess, const char *method,
                                     enum reference_method ideal)
{
    const struct pack_options pack = {.shininess = shininess};
    const struct reference_options options = {.method = ideal, .grey = true};
    struct pack_result packed;
    struct reference_image truth;
    struct compare_result result;
    double milliseconds = 0;
    assert_int_equal(pack_load(path, &pack, &packed), PACK_OK);
    assert_true(reference_render(packed.scene, &options, &truth));
    size_t pixels = (size_t)truth.width * truth.height;
    struct keeper keeper = {{&keeper_ops}, truth.width, malloc(pixels * sizeof(double))};
    struct renderer renderer = {
        .choice = renderer_find(method),
        .config = {
            .width = (uint16_t)truth.width, .height = (uint16_t)truth.height, .band_rows = 16, .format = GLINT_GREY8}};
    assert_int_equal(renderer_open(&renderer, packed.scene), 0);
    assert_int_equal(renderer_draw(&renderer, 0, &keeper.display, NULL, &milliseconds), 0);
    for (size_t i = 0; i < pixels; i++) {
        truth.value[i] *= 255;
        if ((keeper.value[i] > 0) != truth.covered[i]) /* ambient light leaves no covered pixel black */
            fail_msg("%s: pixel (%zu, %zu) is %s", path, i % truth.width, i / truth.width,
                     truth.covered[i] ? "missing" : "drawn beside the surface");
    }
    compare_values(keeper.value, truth.value, truth.covered, pixels, 1, &result);
    print_message("%s n %u %s against %d: %.2f dB, largest %.2f\n", path, shininess, method, ideal, result.psnr_db,
                  result.max);
    renderer_close(&renderer);
    reference_free(&truth);
    pack_free(&packed);
    free(keeper.value);
    return result;
}

static const char *const scenes[] = {
    "tests/scenes/torus288.json",       "tests/scenes/torus800.json",
    "tests/scenes/sphere690.json",      "tests/scenes/torus288-persp.json",
    "tests/scenes/torus800-persp.json", "tests/scenes/sphere690-persp.json",
    "tests/scenes/bench-torus288.json", "tests/scenes/bench-torus4000.json",
    "tests/scenes/torus512.json",       "tests/scenes/sphere168-persp.json",
    "tests/scenes/serpentine.json",     "tests/scenes/zigzag.json",
    "tests/scenes/strip.json",          "tests/scenes/teapot896.json",
    "tests/scenes/bulb.json",           "tests/scenes/pawn.json",
};

#define SCENES (sizeof scenes / sizeof *scenes)

/* Which ideal arithmetic an integer method is to be compared with: that of its name; phong's is linear on the screen.
 */
static enum reference_method ideal_of(const char *name)
{
    if (strcmp(name, "phong") == 0)
        return REFERENCE_PHONG_SCREEN;
    if (strcmp(name, "phong-perspective") == 0)
        return REFERENCE_PHONG;
    return (enum reference_method)method_find(name); /* -1 for those that the reference does not draw */
}

/* The strip's far corners have an eighth of the nearest one's 1/w, which is taken from the 16-bit depth. */
static double most_of(const char *scene)
{
    return strstr(scene, "strip") ? 1.6 : 1.5;
}

/* Rounding to 8 bits is half of a step, the rest what the integers cost. */
static void every_method_is_its_ideal_rounded(void **state)
{
    static const unsigned shininess[] = {5, 20, 50};
    (void)state;
    int compared = 0;
    for (unsigned m = 0; m < glint_choice_count; m++) {
        const char *name = glint_choices[m].name;
        if ((int)ideal_of(name) < 0 || strncmp(name, "subdivide", 9) == 0)
            continue; /* what is decided for a triangle may fall out differently: test_subdivide.c */
        for (size_t i = 0; i < SCENES; i++)
            for (size_t n = 0; n < sizeof shininess / sizeof *shininess; n++)
                if (measure(scenes[i], shininess[n], name, ideal_of(name)).max > most_of(scenes[i]))
                    fail_msg("%s, n %u, by %s", scenes[i], shininess[n], name);
        compared++;
    }
    assert_true(compared >= 8);
}

/* An exponent multiplies what is wrong with N.H: the figures of host-tools/README.md. */
static void large_exponents_cost_what_is_written(void **state)
{
    (void)state;
    for (size_t i = 0; i < SCENES; i++) {
        assert_true(measure(scenes[i], 200, "x", REFERENCE_X).max <= 2);
        assert_true(measure(scenes[i], 1023, "x", REFERENCE_X).max <= 7.5);
    }
}

/*
 * The quality of ideal arithmetic on torus 288 (PSNR in dB, largest difference in 1/255) at n = 5, 20, 50. Integers
 * come within 1 dB of it up to 50 dB; above, output in 8 bits is what limits: rounding the ideal picture itself
 * leaves 53.9, 54.3 and 53.9 dB of six's 55.9, 56.7 and 55.9, as a quarter of this picture is 25.5 exactly.
 */
static void every_method_reaches_its_quality(void **state)
{
    static const struct {
        const char *name;
        double psnr_db[3], max[3];
    } rows[] = {
        {"gouraud", {30.6, 31.1, 31.3}, {26, 38, 41}},
        {"x", {51.4, 48.8, 46.4}, {2.7, 5.7, 10.6}},
        {"six", {55.9, 56.7, 55.9}, {1.9, 1.8, 3.4}},
        {"color6", {46.0, 41.3, 37.7}, {9.5, 14, 29}},
        {"duff", {100, 100, 100}, {0, 0, 0}},
        {"phong", {100, 100, 100}, {0, 0, 0}},
        {"biquadratic", {100, 100, 100}, {0, 0, 0}}, /* a torus has no inflections */
        {"overveld-scan", {26.4, 28.1, 28.6}, {90, 70, 74}},
    };
    static const unsigned shininess[] = {5, 20, 50};
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (size_t n = 0; n < 3; n++) {
            struct compare_result got = measure(scenes[0], shininess[n], rows[i].name, REFERENCE_PHONG);
            double rounded = -10 * log10(pow(10, -rows[i].psnr_db[n] / 10) + pow(10, -58.1 / 10));
            assert_true(got.max <= rows[i].max[n] + 1.5);
            assert_true(got.psnr_db >= (rows[i].psnr_db[n] <= 50 ? rows[i].psnr_db[n] - 1 : rounded - .1));
        }
}

/* In perspective the correct variants come as close to the truth as the others do without it. */
static void perspective_costs_the_correct_variants_nothing(void **state)
{
    static const struct {
        const char *name, *correct;
    } pairs[] = {{"x", "x-perspective"},
                 {"six", "six-perspective"},
                 {"biquadratic", "biquadratic-perspective"},
                 {"phong", "phong-perspective"}};
    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        struct compare_result plain = measure("tests/scenes/torus288.json", 20, pairs[i].name, REFERENCE_PHONG);
        struct compare_result correct =
            measure("tests/scenes/torus288-persp.json", 20, pairs[i].correct, REFERENCE_PHONG);
        assert_true(correct.psnr_db > plain.psnr_db - 1); /* the pictures are not the same */
        assert_true(correct.max < plain.max + .4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_method_is_its_ideal_rounded),
        cmocka_unit_test(large_exponents_cost_what_is_written),
        cmocka_unit_test(every_method_reaches_its_quality),
        cmocka_unit_test(perspective_costs_the_correct_variants_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

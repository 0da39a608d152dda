/* SPDX-License-Identifier: MIT */
/* The integer renderer against double precision that is not rounded: the same pixels, and close values. */
#include "compare/compare.h"
#include "glint/renderer.h"
#include "pack/pack.h"
#include "reference/reference.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>

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
    "tests/scenes/torus288.json",       "tests/scenes/torus800.json",        "tests/scenes/sphere690.json",
    "tests/scenes/torus288-persp.json", "tests/scenes/torus800-persp.json",  "tests/scenes/sphere690-persp.json",
    "tests/scenes/bench-torus288.json", "tests/scenes/bench-torus4000.json",
};

#define SCENES (sizeof scenes / sizeof *scenes)

/* The first `count` scenes with usual exponents: rounding to 8 bits is half of a step, the rest what the integers cost.
 */
static void check_rounded(size_t count, const char *method, enum reference_method ideal)
{
    static const unsigned shininess[] = {5, 20, 50};
    for (size_t i = 0; i < count; i++)
        for (size_t n = 0; n < sizeof shininess / sizeof *shininess; n++)
            assert_true(measure(scenes[i], shininess[n], method, ideal).max <= 1.5);
}

static void integer_gouraud_is_ideal_gouraud_rounded(void **state)
{
    (void)state;
    check_rounded(SCENES, "gouraud", REFERENCE_GOURAUD);
}

static void integer_x_is_ideal_x_rounded(void **state)
{
    (void)state;
    check_rounded(SCENES, "x", REFERENCE_X);
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

/* Without perspective: there it interpolates in the picture, the truth in space. */
static void integer_phong_is_the_truth_rounded(void **state)
{
    (void)state;
    check_rounded(3, "phong", REFERENCE_PHONG);
}

static void integer_x_is_as_near_to_the_truth_as_promised(void **state)
{
    (void)state;
    assert_true(measure(scenes[0], 20, "x", REFERENCE_PHONG).psnr_db >= 48);
    assert_true(measure(scenes[0], 50, "x", REFERENCE_PHONG).psnr_db >= 45.5);
    assert_true(measure(scenes[0], 20, "gouraud", REFERENCE_PHONG).psnr_db < 32);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integer_gouraud_is_ideal_gouraud_rounded),
        cmocka_unit_test(integer_x_is_ideal_x_rounded),
        cmocka_unit_test(integer_phong_is_the_truth_rounded),
        cmocka_unit_test(large_exponents_cost_what_is_written),
        cmocka_unit_test(integer_x_is_as_near_to_the_truth_as_promised),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

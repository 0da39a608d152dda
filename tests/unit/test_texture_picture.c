/* SPDX-License-Identifier: MIT */
/* Textured pictures against double precision: formats, filters, borders, methods, lights and pixel formats. */
#include "compare/compare.h"
#include "glint/renderer.h"
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

#include "frame_case.h"
#include "pack_case.h"

/* A board that is clipped by the near plane, beside a ball and a box of texture on a point, under a far and a near
 * light. `texture` are members of the texture, `lights` the lights; the board stands `turned` degrees about. */
static struct pack_result load_turned(const char *texture, const char *lights, int turned)
{
    char text[2048], said[256];
    struct pack_result r;
    snprintf(
        text, sizeof text,
        "{\"camera\": {\"size\": [120, 90], \"focal\": 110, \"position\": [0, 0.7, 1.9], \"look_at\": [0, 0.1, 0], "
        "\"near\": 0.5, \"far\": 8}, \"ambient\": [0.25, 0.25, 0.25], \"lights\": [%s], "
        "\"textures\": {\"t\": {%s}}, "
        "\"materials\": {\"board\": {\"texture\": \"t\", \"kd\": 0.7, \"ks\": 0.5, \"shininess\": 20}, "
        "\"ball\": {\"texture\": \"t\", \"diffuse\": [1, 0.8, 0.6], \"kd\": 0.6, \"ks\": 0.4, \"shininess\": 12}}, "
        "\"meshes\": {\"board\": {\"shape\": \"plane\", \"size\": [3, 6], \"segments\": 2, \"material\": \"board\"}, "
        "\"ball\": {\"shape\": \"sphere\", \"radius\": 0.4, \"slices\": 12, \"stacks\": 8, \"material\": \"ball\"}}, "
        "\"objects\": [{\"mesh\": \"board\", \"transform\": [{\"rotate\": [\"y\", %d]}]}, {\"mesh\": \"ball\", "
        "\"transform\": [{\"move\": [0, 0.5, 0]}]}]}",
        lights, texture, turned);
    assert_int_equal(case_load("scene.json", text, &r, said, sizeof said), 0);
    assert_string_equal(said, "");
    return r;
}

static struct pack_result load(const char *texture, const char *lights)
{
    return load_turned(texture, lights, 0);
}

#define FAR_LIGHT  "{\"towards\": [0.4, 0.8, 0.5], \"colour\": [0.8, 0.8, 0.8]}"
#define NEAR_LIGHT "{\"type\": \"point\", \"position\": [-1, 1, 1], \"colour\": [0.5, 0.5, 0.5]}"
#define CHECKER    "\"pattern\": \"checker\", \"size\": [16, 16], \"cells\": [4, 4]"
#define NOISE \
    "\"pattern\": \"noise\", \"size\": [32, 16], \"cells\": [4, 2], \"colours\": [[0.9, 0.2, 0.1], [0.1, 0.7, 1]]"

/* How a picture in 8-bit grey or colour differs from the truth. `edges`: pixels left out, whose truth changes by much
 * within 1/50 pixel, as at the edge of a nearest texel. */
static struct compare_result measure(const struct scene_header *scene, struct glint_config config)
{
    const unsigned width = scene->camera.reference_width, height = scene->camera.reference_height;
    const struct reference_options options = {.grey = config.format == GLINT_GREY8};
    struct reference_image truth;
    struct compare_result result;
    config.width = (uint16_t)width;
    config.height = (uint16_t)height;
    uint8_t *picture = frame_case_picture((struct frame_case){.config = config}, scene, 0, NULL);
    assert_true(reference_render(scene, &options, &truth));
    const size_t values = (size_t)width * height * truth.channels;
    double *drawn = malloc(values * sizeof *drawn);
    assert_non_null(drawn);
    for (size_t i = 0; i < values; i++) {
        drawn[i] = picture[i];
        truth.value[i] *= 255;
    }
    compare_values(drawn, truth.value, truth.covered, (size_t)width * height, truth.channels, &result);
    reference_free(&truth);
    free(picture);
    free(drawn);
    return result;
}

/* Interpolated texels: each pixel of per-pixel Phong within a step and a half, half a step of which is rounding. */
static void bilinear_textures_are_within_1_5_of_the_truth(void **state)
{
    (void)state;
    static const char *const formats[] = {"rgb565", "palette8"}, *const wraps[] = {"\"repeat\"",
                                                                                   "[\"clamp\", \"repeat\"]",
                                                                                   "\"clamp\""};
    static const char *const lights[] = {FAR_LIGHT, FAR_LIGHT ", " NEAR_LIGHT};
    for (int f = 0; f < 2; f++)
        for (int w = 0; w < 3; w++)
            for (int l = 0; l < 2; l++) {
                char text[512];
                snprintf(text, sizeof text, "%s, \"format\": \"%s\", \"wrap\": %s", f == w % 2 ? CHECKER : NOISE,
                         formats[f], wraps[w]);
                struct pack_result r = load(text, lights[l]);
                for (unsigned format = GLINT_RGB888; format <= GLINT_GREY8; format++) {
                    const struct compare_result d = measure(
                        r.scene, (struct glint_config){.format = (uint8_t)format, .method = &glint_phong_perspective});
                    if (d.max > 1.5)
                        fail_msg("%s, %d lights, format %u: %.2f", text, l + 1, format, d.max);
                }
                pack_free(&r);
            }
}

/* The nearest texel is a step: at its edge a pixel may take the other side's. */
static void nearest_texels_are_the_truth_but_for_pixels_on_their_edges(void **state)
{
    (void)state;
    static const char *const formats[] = {"rgb565", "palette8"};
    for (int f = 0; f < 2; f++) {
        char text[512];
        snprintf(text, sizeof text, "%s, \"format\": \"%s\", \"filter\": \"nearest\"", f ? NOISE : CHECKER, formats[f]);
        struct pack_result r = load(text, FAR_LIGHT);
        for (unsigned format = GLINT_RGB888; format <= GLINT_GREY8; format++) {
            const struct compare_result d =
                measure(r.scene, (struct glint_config){.format = (uint8_t)format, .method = &glint_phong_perspective});
            if (d.p999 > 1.5)
                fail_msg("%s, format %u: %.2f", text, format, d.p999);
        }
        pack_free(&r);
    }
}

/* Every method with every kind: as far from the truth as the method is, or as the kind may be. */
static void every_method_takes_textures(void **state)
{
    (void)state;
    struct pack_result r = load(NOISE, FAR_LIGHT);
    for (unsigned m = 0; m < glint_choice_count; m++) {
        const struct glint_config config = {.format = GLINT_RGB888, .method = glint_choices[m].method};
        const double psnr = measure(r.scene, config).psnr_db;
        if (psnr < (strcmp(glint_choices[m].name, "flat") == 0 ? 20 : 25))
            fail_msg("%s: %.1f dB", glint_choices[m].name, psnr);
    }
    pack_free(&r);
}

/* Grey weighs a texel's channels by the material's colour; of black nothing shows but highlights. */
static void a_texture_on_black_is_not_seen_in_grey(void **state)
{
    (void)state;
    struct pack_result r = load(NOISE, FAR_LIGHT);
    struct scene_material *material = (struct scene_material *)(uintptr_t)scene_materials(r.scene);
    uint8_t *picture[2];
    int brightest = 0;
    for (int textured = 1; textured >= 0; textured--) {
        for (unsigned i = 0; i < r.scene->material_count; i++) {
            memset(material[i].diffuse, 0, sizeof material[i].diffuse);
            material[i].texture = textured ? material[i].texture : SCENE_NO_TEXTURE;
        }
        picture[textured] = frame_case_picture(frame_case_small(120, 90, GLINT_GREY8), r.scene, 0, NULL);
    }
    for (int i = 0; i < 120 * 90; i++) {
        assert_in_range(picture[1][i] + 1, picture[0][i], picture[0][i] + 2);
        brightest = picture[0][i] > brightest ? picture[0][i] : brightest;
    }
    assert_in_range(brightest, 60, 255);
    free(picture[0]);
    free(picture[1]);
    pack_free(&r);
}

static void kinds_err_in_the_order_of_their_cost(void **state)
{
    (void)state;
    struct pack_result r = load(NOISE, FAR_LIGHT);
    double psnr[GLINT_TEXTURES];
    for (uint8_t kind = GLINT_TEXTURE_AFFINE; kind < GLINT_TEXTURES; kind++)
        psnr[kind] =
            measure(r.scene,
                    (struct glint_config){.format = GLINT_RGB888, .method = &glint_phong_perspective, .texture = kind})
                .psnr_db;
    print_message("affine %.1f, quadratic %.1f, split %.1f, perspective %.1f dB\n", psnr[GLINT_TEXTURE_AFFINE],
                  psnr[GLINT_TEXTURE_QUADRATIC], psnr[GLINT_TEXTURE_SPLIT], psnr[GLINT_TEXTURE_PERSPECTIVE]);
    assert_true(psnr[GLINT_TEXTURE_AFFINE] + 5 < psnr[GLINT_TEXTURE_QUADRATIC]);
    assert_true(psnr[GLINT_TEXTURE_QUADRATIC] + 5 < psnr[GLINT_TEXTURE_SPLIT]);
    assert_true(fabs(psnr[GLINT_TEXTURE_SPLIT] - psnr[GLINT_TEXTURE_PERSPECTIVE]) < 2);
    assert_true(psnr[GLINT_TEXTURE_PERSPECTIVE] > 58);
    pack_free(&r);
}

/* Moves all coordinates along, so that the least u and v are -8 turns, the least there are. */
static void move_to_the_end(const struct scene_header *scene)
{
    const struct scene_mesh *const mesh = scene_meshes(scene);
    for (unsigned m = 0; m < scene->mesh_count; m++) {
        int16_t(*uv)[2] = (int16_t(*)[2])(uintptr_t)scene_at(scene, mesh[m].uvs);
        for (int axis = 0; axis < 2; axis++) {
            int least = INT16_MAX;
            for (unsigned i = 0; i < mesh[m].vertex_count; i++)
                least = uv[i][axis] < least ? uv[i][axis] : least;
            for (unsigned i = 0; i < mesh[m].vertex_count; i++)
                uv[i][axis] = (int16_t)(uv[i][axis] - least + INT16_MIN);
        }
    }
}

/* Seen from aside, so that a part's corner on an edge has odd shares of the edge's ends. */
static void coordinates_at_the_end_of_their_range_are_like_others(void **state)
{
    (void)state;
    struct pack_result r = load_turned(NOISE, FAR_LIGHT, 35), moved = load_turned(NOISE, FAR_LIGHT, 35);
    move_to_the_end(moved.scene);
    for (uint8_t kind = GLINT_TEXTURE_AFFINE; kind < GLINT_TEXTURES; kind++) {
        const struct glint_config config = {
            .format = GLINT_RGB888, .method = &glint_phong_perspective, .texture = kind};
        const double before = measure(r.scene, config).psnr_db, after = measure(moved.scene, config).psnr_db;
        if (fabs(after - before) > 1)
            fail_msg("kind %u: %.1f dB, %.1f before", kind, after, before);
    }
    pack_free(&r);
    pack_free(&moved);
}

/* The budget is kept with textures, by auto and by splitting with per-pixel Phong. */
static void the_budget_is_kept(void **state)
{
    (void)state;
    struct pack_result r = load(NOISE, FAR_LIGHT), two = load(NOISE, FAR_LIGHT ", " NEAR_LIGHT);
    const struct scene_header *const scene[2] = {r.scene, two.scene};
    for (unsigned budget = 1; budget <= 32; budget *= 2)
        for (int s = 0; s < 2; s++)
            for (unsigned format = GLINT_RGB888; format <= GLINT_GREY8; format++) {
                struct glint_config config = {
                    .format = (uint8_t)format, .method = &glint_auto, .budget = (uint16_t)(budget << 8)};
                assert_true(measure(scene[s], config).max <= budget + 1.5);
                config.method = &glint_phong_perspective;
                config.texture = GLINT_TEXTURE_SPLIT;
                assert_true(measure(scene[s], config).max <= budget + 1.5);
            }
    pack_free(&r);
    pack_free(&two);
}

static void bands_of_any_height_give_the_same_pixels(void **state)
{
    (void)state;
    struct pack_result r = load(CHECKER ", \"wrap\": \"clamp\"", FAR_LIGHT);
    for (unsigned m = 0; m < glint_choice_count; m++)
        for (uint8_t kind = 0; kind < GLINT_TEXTURES; kind++) {
            struct frame_case f = frame_case_small(120, 90, GLINT_RGB565);
            f.config.method = glint_choices[m].method;
            f.config.texture = kind;
            f.config.tables = 1;
            uint8_t *whole = frame_case_picture(f, r.scene, 0, NULL);
            f.config.band_rows = 7;
            uint8_t *bands = frame_case_picture(f, r.scene, 0, NULL);
            if (memcmp(whole, bands, 120 * 90 * 2) != 0)
                fail_msg("%s, kind %u", glint_choices[m].name, kind);
            free(whole);
            free(bands);
        }
    pack_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bilinear_textures_are_within_1_5_of_the_truth),
        cmocka_unit_test(nearest_texels_are_the_truth_but_for_pixels_on_their_edges),
        cmocka_unit_test(every_method_takes_textures),
        cmocka_unit_test(a_texture_on_black_is_not_seen_in_grey),
        cmocka_unit_test(kinds_err_in_the_order_of_their_cost),
        cmocka_unit_test(coordinates_at_the_end_of_their_range_are_like_others),
        cmocka_unit_test(the_budget_is_kept),
        cmocka_unit_test(bands_of_any_height_give_the_same_pixels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

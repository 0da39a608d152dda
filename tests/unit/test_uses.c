/* SPDX-License-Identifier: MIT */
/*
 * The renderer compiled for scenes like torus288 and 8-bit grey alone (TEST_USES in tests/tools/suites.mk): one far
 * light, orthographic, specular. Everything else is folded away, and what needs it is refused.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "app/program_scene.h"
#include "frame_case.h"
#include "scene/scene.h"
#include "uses.h"

static const void *scene_of(const char *name, size_t *size)
{
    for (unsigned i = 0; i < program_scene_count; i++)
        if (!strcmp(program_scenes[i].name, name)) {
            *size = *program_scenes[i].length;
            return program_scenes[i].blob;
        }
    fail_msg("no scene %s", name);
    return NULL;
}

/* The list's hash of a picture of 96x72 in 8-bit grey. */
static uint32_t listed_hash(const char *scene, const char *method)
{
    char line[160], wanted[120];
    unsigned hash = 0, found = 0;
    FILE *list = fopen("tests/golden/hashes.txt", "r");
    assert_non_null(list);
    snprintf(wanted, sizeof wanted, "%s %s grey8 96x72 0 ", scene, method);
    while (!found && fgets(line, sizeof line, list))
        found = !strncmp(line, wanted, strlen(wanted)) && sscanf(line + strlen(wanted), "%x", &hash) == 1;
    fclose(list);
    if (!found)
        fail_msg("%s is not in the list of hashes", wanted);
    return hash;
}

static void each_method_gives_the_bits_of_the_whole_renderer(void **state)
{
    (void)state;
    static const char *const scenes[] = {"torus288", "sphere168"};
    for (unsigned i = 0; i < 2 * glint_choice_count; i++) {
        const struct glint_choice *choice = &glint_choices[i / 2];
        size_t size;
        const void *scene = scene_of(scenes[i % 2], &size);
        struct frame_case f = frame_case_small(96, 72, GLINT_GREY8);
        f.config.method = choice->method;
        uint8_t *picture = frame_case_picture(f, scene, 0, NULL);
        assert_int_equal(scene_crc32(0, picture, 96 * 72), listed_hash(scenes[i % 2], choice->name));
        free(picture);
    }
}

static void a_scene_that_needs_more_is_refused_with_its_reason(void **state)
{
    (void)state;
    static const char *const scenes[] = {"demo", "teapot896", "materials"};
    struct frame_case f = frame_case_small(96, 72, GLINT_GREY8);
    size_t size;
    frame_case_open_for(&f, scene_of("torus288", &size));
    for (unsigned i = 0; i < 3; i++) {
        const void *scene = scene_of(scenes[i], &size);
        assert_int_equal(glint_scene_check(scene, size), GLINT_E_SCENE);
        assert_non_null(strstr(glint_scene_problem(scene, size), "compiled without"));
        f.frame.config.max_lights = SCENE_MAX_LIGHTS; /* not for its lights */
        assert_int_equal(glint_frame_begin(&f.frame, scene, 0), GLINT_E_SCENE);
    }
    /* and goes on with one that it has all for */
    f.frame.config.max_lights = f.config.max_lights;
    frame_case_draw(&f, scene_of("torus288", &size), 0);
    frame_case_close(&f);
}

static void every_effect_that_is_not_there_refuses_a_scene(void **state)
{
    (void)state;
    struct frame_case f = frame_case_small(32, 24, GLINT_GREY8);
    size_t size;
    const void *scene = scene_of("torus288", &size);
    struct scene_header *copy = malloc(size);
    assert_non_null(copy);
    memcpy(copy, scene, size);
    frame_case_open_for(&f, scene);
    for (uint32_t bit = 1; bit & USES_EFFECTS; bit <<= 1) {
        copy->effects = bit;
        assert_int_equal(glint_frame_begin(&f.frame, copy, 0), bit & GLINT_USES ? 0 : GLINT_E_SCENE);
    }
    frame_case_close(&f);
    free(copy);
}

static void a_configuration_that_needs_more_is_refused(void **state)
{
    (void)state;
    struct glint_config config = frame_case_small(32, 24, GLINT_GREY8).config;
    config.band_rows = 24;
    assert_true(glint_memory_needed(&config) > 0);
    for (unsigned format = 0; format < GLINT_FORMATS; format++) {
        config.format = (uint8_t)format;
        assert_int_equal(glint_memory_needed(&config) > 0, format == GLINT_GREY8);
    }
    config.format = GLINT_GREY8;
    config.flags = GLINT_DITHER;
    assert_int_equal(glint_memory_needed(&config), 0);
    config.flags = 0;
    config.power = &glint_power_exact;
    assert_int_equal(glint_memory_needed(&config), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_method_gives_the_bits_of_the_whole_renderer),
                                       cmocka_unit_test(a_scene_that_needs_more_is_refused_with_its_reason),
                                       cmocka_unit_test(every_effect_that_is_not_there_refuses_a_scene),
                                       cmocka_unit_test(a_configuration_that_needs_more_is_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

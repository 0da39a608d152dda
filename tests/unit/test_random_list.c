/* SPDX-License-Identifier: MIT */
/*
 * tests/golden/random.txt: a line a method, the CRC-32 of its pictures of random scenes (tests/budget/random_scene.h)
 * and of what their statistics say, over every format, table, form of the power, way of texture coordinates and budget,
 * turned to any side. What the scenes of hashes.txt do not hold, these do. `test_random_list --list` prints the list as
 * it is now.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "tests/budget/random_scene.h"

#include <stdio.h>

#define SCENES 360

static const struct glint_power *const powers[] = {NULL, &glint_power_exact, &glint_power_4, &glint_power_8,
                                                   &glint_power_16};

static uint32_t hash_stats(uint32_t hash, const struct glint_stats *s)
{
    const uint32_t said[] = {s->triangles,
                             s->culled,
                             s->rejected,
                             s->clipped,
                             s->dropped,
                             s->turned,
                             s->specular_triangles,
                             s->linear_triangles,
                             s->highlight_tests,
                             s->setups,
                             s->fogged,
                             s->fogged_by_pixel,
                             s->fogged_wholly,
                             s->hidden_lights,
                             s->hidden_highlights,
                             s->dropped_highlights,
                             s->straightened,
                             s->undivided,
                             s->largest_error,
                             s->potentially_highlighted};
    hash = scene_crc32(hash, said, sizeof said);
    hash = scene_crc32(hash, s->drawn, sizeof s->drawn);
    hash = scene_crc32(hash, s->pixels, sizeof s->pixels);
    return scene_crc32(hash, s->mapped, sizeof s->mapped);
}

/* Everything that a configuration has; `i` goes through the formats. */
static struct frame_case random_case(const struct glint_method *method, int i)
{
    struct frame_case f = frame_case_small(RANDOM_WIDTH, RANDOM_HEIGHT, (enum glint_format)(i % GLINT_FORMATS));
    struct glint_config *c = &f.config;
    c->method = method;
    c->power = powers[random_between(0, 9) % 5];
    if (random_between(0, 1))
        c->power = NULL;
    c->texture = (uint8_t)random_between(0, GLINT_TEXTURES - 1);
    c->tables = (uint8_t)random_between(0, 1);
    c->flags = random_between(0, 3) ? 0 : GLINT_DITHER;
    c->flags |= random_between(0, 3) ? 0 : GLINT_EVERY_ZIGZAG;
    c->budget = (uint16_t)random_magnitude(64, 8192);
    c->subdivide_tolerance = (uint8_t)random_between(0, 20);
    c->subdivide_threshold = (uint8_t)random_between(0, 120);
    c->subdivide_area = (uint16_t)random_between(0, 200);
    c->band_rows = (uint16_t)random_between(1, RANDOM_HEIGHT);
    return f;
}

/* Texels as they are, not between: loops of their own. */
static void take_nearest(struct scene_header *scene)
{
    struct scene_texture *texture = (struct scene_texture *)(uintptr_t)scene_textures(scene);
    for (unsigned i = 0; i < scene->texture_count; i++)
        texture[i].flags &= (uint8_t)~TEXTURE_BILINEAR;
}

static uint32_t hash_method(const struct glint_choice *choice)
{
    uint32_t hash = 0;
    /* auto decides most */
    const int count = choice->method == &glint_auto ? 3 * SCENES : SCENES;
    for (int i = 0; i < count; i++) {
        struct scene_header *scene = random_scene((uint32_t)i);
        struct frame_case f = random_case(choice->method, i / 2);
        if (i % 5 == 0)
            take_nearest(scene);
        frame_case_open_for(&f, scene);
        const uint32_t side = random_bits();
        if (i % 4 == 3)
            glint_turn(&f.frame, (uint16_t)side, (uint16_t)(side >> 16));
        frame_case_draw(&f, scene, 0);
        hash = scene_crc32(hash, f.picture, f.picture_bytes);
        hash = hash_stats(hash, &f.frame.stats);
        frame_case_close(&f);
        free(scene);
    }
    return hash;
}

static void random_scenes_have_the_pictures_of_the_list(void **state)
{
    (void)state;
    char line[80], wanted[80];
    int bad = 0;
    FILE *list = fopen("tests/golden/random.txt", "r");
    assert_non_null(list);
    for (unsigned m = 0; m < glint_choice_count; m++) {
        snprintf(line, sizeof line, "%s %08x\n", glint_choices[m].name, hash_method(&glint_choices[m]));
        if (!fgets(wanted, sizeof wanted, list))
            wanted[0] = 0;
        if (strcmp(line, wanted) != 0) {
            print_error("%snot %s", line, wanted);
            bad = 1;
        }
    }
    assert_null(fgets(wanted, sizeof wanted, list));
    fclose(list);
    assert_false(bad);
}

int main(int argc, char **argv)
{
    if (argc > 1 && strcmp(argv[1], "--list") == 0) {
        for (unsigned m = 0; m < glint_choice_count; m++)
            printf("%s %08x\n", glint_choices[m].name, hash_method(&glint_choices[m]));
        return 0;
    }
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_scenes_have_the_pictures_of_the_list)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

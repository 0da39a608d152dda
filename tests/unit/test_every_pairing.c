/* SPDX-License-Identifier: MIT */
/*
 * Scenes at random, with all that there is, drawn by any method with any option: a pixel depends on its triangle and
 * place alone, so that the picture is the same in bands of any height, and without the plan.
 *   test_every_pairing [SCENES]
 */
#include "glint.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "tests/budget/random_scene.h"

#include "frame_case.h"

static uint32_t scenes = 6000;

static int one_in(int n)
{
    return random_between(1, n) == 1;
}

static void random_look(struct scene_material *m)
{
    m->kd = one_in(8) ? 0 : m->kd;
    m->ks = one_in(5) ? 0 : m->ks;
    for (int k = 0; k < 3 && one_in(6); k++)
        m->specular[k] = 0;
    if (one_in(3))
        for (int k = 1; k < 3; k++)
            m->diffuse[k] = m->diffuse[0], m->specular[k] = m->specular[0];
    if (one_in(8))
        m->ka = 32768;
    m->flags |= one_in(4) ? MATERIAL_FLAT : 0;
}

/* Turned, moved aside, stretched or cut by the near plane. */
static void random_place(struct scene_header *scene)
{
    struct scene_object *o = (struct scene_object *)(uintptr_t)scene_objects(scene);
    if (one_in(2)) {
        double q[4];
        random_direction(q, 4);
        for (int k = 0; k < 4; k++)
            o->rotation[k] = (q30_t)lrint(q[k] * (1 << 30));
    }
    if (one_in(3))
        o->scale = (q16_t)(random_magnitude(.05, 40) * CASE_UNIT);
    if (one_in(4))
        for (int k = 0; k < 2; k++)
            o->position[k] = (q16_t)(random_real(-3, 3) * CASE_UNIT);
    if (one_in(4))
        scene->camera.focal = (q16_t)(random_magnitude(2, 8192) * CASE_UNIT);
    if (one_in(5))
        scene->camera.near_plane = (q16_t)random_magnitude(256, scene->camera.far_plane / 2.0);
}

/* Slivers, and normals that point in opposite directions. */
static void random_extremes(struct scene_header *scene)
{
    const struct scene_mesh *mesh = scene_meshes(scene);
    struct scene_vertex *v = (struct scene_vertex *)(void *)((uint8_t *)scene + mesh->vertices);
    struct scene_tangent *t = (struct scene_tangent *)(void *)((uint8_t *)scene + mesh->tangents);
    struct scene_triangle *triangle = (struct scene_triangle *)(void *)((uint8_t *)scene + mesh->triangles);
    const int squashed = one_in(6) ? random_between(0, 1) : 2, by = (int)random_magnitude(20, 2000);
    const int opposite = one_in(6);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        if (squashed < 2)
            v[i].position[squashed] = (int16_t)(v[i].position[squashed] / by);
        if (opposite && mesh->tangents)
            t[i] = t[0];
        for (int k = 0, sign = random_between(0, 1); opposite && k < 3; k++)
            v[i].normal[k] = (int16_t)(sign && i ? -v[0].normal[k] : v[0].normal[k]);
    }
    for (uint32_t i = 0; opposite && i < mesh->triangle_count; i++)
        scene_case_bend(&triangle[i], v);
}

/* As random_scene(), and what the budget's promise leaves out. */
static struct scene_header *random_blob(uint32_t seed)
{
    struct scene_header *scene = random_scene(seed);
    struct scene_light *light = (struct scene_light *)(uintptr_t)scene_lights(scene);
    random_look((struct scene_material *)(uintptr_t)scene_materials(scene));
    random_place(scene);
    random_extremes(scene);
    for (unsigned i = 0; i < scene->light_count; i++)
        if (one_in(6))
            light[i].colour[0] = light[i].colour[1] = light[i].colour[2] = (uint16_t)(32768 * random_between(0, 1));
    for (unsigned i = 0; i < scene->texture_count; i++)
        if (one_in(2))
            ((struct scene_texture *)(uintptr_t)scene_textures(scene))[i].flags &= (uint8_t)~TEXTURE_BILINEAR;
    if (one_in(12))
        scene->light_count = 0, scene->lights = 0;
    scene->effects = scene_effects(scene) | USES_CLIPPING;
    scene->crc = scene_crc32(0, (const uint8_t *)scene + 16, scene->length - 16);
    assert_int_equal(scene_check(scene, scene->length), SCENE_OK);
    return scene;
}

/* More often than chance has it: maps in grey, for which there are loops of their own. */
static struct frame_case random_case(const struct scene_header *scene)
{
    static const struct glint_power *const powers[] = {
        NULL, NULL, NULL, NULL, &glint_power_exact, &glint_power_4, &glint_power_8, &glint_power_16};
    struct frame_case f = frame_case_small(RANDOM_WIDTH, RANDOM_HEIGHT, (enum glint_format)random_between(0, 3));
    struct glint_config *c = &f.config;
    c->method = one_in(4)    ? &glint_auto
                : one_in(12) ? &glint_auto_shown
                             : glint_choices[random_between(0, (int)glint_choice_count - 1)].method;
    c->power = powers[random_between(0, 7)];
    c->texture = (uint8_t)(one_in(2) ? 0 : random_between(0, GLINT_TEXTURES - 1));
    c->tables = (uint8_t)random_between(0, 1);
    c->budget = (uint16_t)random_magnitude(32, 8192);
    c->flags = (uint8_t)(random_between(0, 1) * GLINT_DITHER | random_between(0, 1) * GLINT_EVERY_ZIGZAG);
    if (scene_materials(scene)->bump != SCENE_NO_TEXTURE && one_in(2)) {
        static const struct glint_method *const mapped[] = {&glint_bump_linear, &glint_bump_quadratic,
                                                            &glint_bump_normalised};
        c->method = mapped[random_between(0, 2)];
        c->format = GLINT_GREY8;
        c->tables = 1;
        c->power = NULL;
        c->texture = (uint8_t)random_between(0, GLINT_TEXTURE_AFFINE);
    }
    c->subdivide_area = (uint16_t)random_magnitude(1, 500);
    c->subdivide_tolerance = (uint8_t)random_between(0, 20);
    return f;
}

static void every_pairing_is_the_same_in_bands_and_without_the_plan(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < scenes; seed++) {
        char name[32];
        struct scene_header *scene = random_blob(seed);
        const struct frame_case f = random_case(scene);
        uint8_t *whole = frame_case_picture(f, scene, 0, NULL);
        snprintf(name, sizeof name, "scene %u", (unsigned)seed);
        frame_case_same(&f, whole, scene, (unsigned)random_between(1, RANDOM_HEIGHT), 0, name);
        if (f.config.method != &glint_auto && f.config.method != &glint_auto_shown)
            frame_case_same(&f, whole, scene, 0, GLINT_NO_PLAN, name);
        free(whole);
        free(scene);
    }
}

int main(int argc, char **argv)
{
    scenes = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : scenes;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pairing_is_the_same_in_bands_and_without_the_plan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

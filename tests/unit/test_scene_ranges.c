/* SPDX-License-Identifier: MIT */
/* A scene with one value out of its range, and all else as it should be: refused, for that reason. */
#include "glint.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene_case.h"

enum { RGB, BUMP }; /* its textures */

static struct scene_header *scene;

/* A mapped triangle under linear fog. */
static int open_scene(void **state)
{
    static const struct scene_vertex vertices[3] = {
        {{-8000, -8000, 0}, {0, 0, 16384}}, {{8000, -8000, 0}, {0, 0, 16384}}, {{0, 8000, 0}, {0, 0, 16384}}};
    static const struct scene_triangle triangles[1] = {{.corner = {0, 1, 2}}};
    static const int16_t uvs[3][2] = {{0, 0}, {4096, 0}, {0, 4096}};
    static const struct scene_tangent tangents[3] = {{{16384, 0, 0}, 1}, {{16384, 0, 0}, -1}, {{16384, 0, 0}, 1}};
    static const uint16_t texels[4] = {0, 0xffff, 0, 0xffff};
    static const int8_t bumps[4][2] = {{0, 0}, {9, 0}, {0, 9}, {-9, 0}};
    struct scene_case c;
    (void)state;
    scene_case_default(&c, 64, 48);
    c.mesh[0].vertices = vertices;
    c.mesh[0].triangles = triangles;
    c.mesh[0].vertex_count = 3;
    c.mesh[0].triangle_count = 1;
    c.texture.log2_width = c.texture.log2_height = c.bump.log2_width = c.bump.log2_height = 1;
    c.bump.steepness = 8192;
    c.texels = texels;
    c.bumps = bumps;
    c.uvs = uvs;
    c.tangents = tangents;
    c.head.fog.kind = FOG_LINEAR;
    c.head.fog.to = CASE_UNIT;
    scene = scene_case_blob(&c);
    return 0;
}

static int close_scene(void **state)
{
    (void)state;
    free(scene);
    return 0;
}

static enum scene_fault look(void)
{
    scene->crc = scene_crc32(0, (const uint8_t *)scene + 16, scene->length - 16);
    return scene_check(scene, scene->length);
}

/* `member` set to `value` makes the fault; as it was before, none. */
#define REFUSED(member, value, fault)             \
    do {                                          \
        const __typeof__(member) kept = (member); \
        assert_int_equal(look(), SCENE_OK);       \
        (member) = (__typeof__(member))(value);   \
        assert_int_equal(look(), (fault));        \
        (member) = kept;                          \
        assert_int_equal(look(), SCENE_OK);       \
    } while (0)

static void fog_begins_in_front_of_the_eye_and_before_its_end(void **state)
{
    struct scene_fog *fog = &scene->fog;
    (void)state;
    REFUSED(fog->from, -1, SCENE_E_RANGE);
    REFUSED(fog->from, CASE_UNIT, SCENE_E_RANGE);
    REFUSED(fog->density, 1, SCENE_E_RANGE);
    REFUSED(fog->kind, FOG_EXPONENTIAL + 1, SCENE_E_RANGE);
    REFUSED(fog->colour[1], 32769, SCENE_E_RANGE);
}

static void exponential_fog_has_a_density_and_no_ends(void **state)
{
    struct scene_fog *fog = &scene->fog, kept = scene->fog;
    (void)state;
    *fog = (struct scene_fog){.kind = FOG_EXPONENTIAL, .density = 1u << 28};
    REFUSED(fog->density, (1u << 28) + 1, SCENE_E_RANGE);
    REFUSED(fog->density, 0, SCENE_E_RANGE);
    REFUSED(fog->from, 1, SCENE_E_RANGE);
    REFUSED(fog->to, 1, SCENE_E_RANGE);
    *fog = kept;
}

static void a_material_names_a_picture_and_a_bump_map_that_are_there(void **state)
{
    struct scene_material *m = (struct scene_material *)(uintptr_t)scene_materials(scene);
    (void)state;
    REFUSED(m->texture, 2, SCENE_E_INDEX);
    REFUSED(m->bump, 2, SCENE_E_INDEX);
    REFUSED(m->texture, BUMP, SCENE_E_RANGE);
    REFUSED(m->bump, RGB, SCENE_E_RANGE);
    REFUSED(m->power, 1, SCENE_E_INDEX);
    REFUSED(m->flags, 4, SCENE_E_RANGE);
    REFUSED(m->shininess, 2, SCENE_E_RANGE);
}

static void a_tangent_lies_across_its_normal_and_has_a_side(void **state)
{
    const struct scene_mesh *mesh = scene_meshes(scene);
    struct scene_tangent *t = (struct scene_tangent *)((uint8_t *)scene + mesh->tangents) + 2;
    const struct scene_tangent kept = *t;
    (void)state;
    REFUSED(t->sign, 0, SCENE_E_RANGE);
    REFUSED(t->sign, 2, SCENE_E_RANGE);
    REFUSED(t->tangent[0], 16000, SCENE_E_RANGE);
    REFUSED(t->tangent[2], 9, SCENE_E_RANGE); /* 9 / 2^14 > 2^-11 */
    t->tangent[2] = 8;
    assert_int_equal(look(), SCENE_OK);
    t->tangent[2] = -9;
    assert_int_equal(look(), SCENE_E_RANGE);
    *t = kept;
}

static void a_bump_map_rises_as_its_steepness_says(void **state)
{
    struct scene_texture *t = (struct scene_texture *)(uintptr_t)scene_textures(scene) + BUMP;
    uint16_t *rise = (uint16_t *)(void *)((uint8_t *)scene + t->palette);
    (void)state;
    REFUSED(t->steepness, TEXTURE_UNIT + 1, SCENE_E_RANGE);
    REFUSED(t->steepness, 0, SCENE_E_RANGE);
    REFUSED(rise[0], rise[0] - 1, SCENE_E_RANGE);
    REFUSED(rise[TEXTURE_RISES - 1], rise[TEXTURE_RISES - 1] + 1, SCENE_E_RANGE);
    REFUSED(t->contrast, t->contrast - 1, SCENE_E_RANGE);
}

static void black_has_no_highlight(void **state)
{
    struct scene_material *m = (struct scene_material *)(uintptr_t)scene_materials(scene), kept = *m;
    (void)state;
    m->ks = 32768;
    for (int i = 0; i < 3; i++) {
        m->specular[0] = m->specular[1] = m->specular[2] = 0;
        assert_int_equal(scene_effects(scene) & USES_SPECULAR, 0);
        m->specular[i] = 1;
        assert_int_equal(scene_effects(scene) & USES_SPECULAR, USES_SPECULAR);
    }
    m->ks = 0;
    assert_int_equal(scene_effects(scene) & USES_SPECULAR, 0);
    *m = kept;
}

static void every_fault_has_words_of_its_own(void **state)
{
    (void)state;
    for (int i = SCENE_OK; i >= SCENE_E_USES; i--)
        for (int k = i - 1; k >= SCENE_E_USES - 1; k--)
            assert_string_not_equal(scene_fault_text((enum scene_fault)i), scene_fault_text((enum scene_fault)k));
    assert_string_equal(scene_fault_text((enum scene_fault)(SCENE_E_USES - 1)), "unknown fault");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fog_begins_in_front_of_the_eye_and_before_its_end),
        cmocka_unit_test(exponential_fog_has_a_density_and_no_ends),
        cmocka_unit_test(a_material_names_a_picture_and_a_bump_map_that_are_there),
        cmocka_unit_test(a_tangent_lies_across_its_normal_and_has_a_side),
        cmocka_unit_test(a_bump_map_rises_as_its_steepness_says),
        cmocka_unit_test(black_has_no_highlight),
        cmocka_unit_test(every_fault_has_words_of_its_own),
    };
    return cmocka_run_group_tests(tests, open_scene, close_scene);
}

/* SPDX-License-Identifier: MIT */
#include "glint.h"
#include "pack/pack.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct pack_result tiny;

static int load_tiny(void **state)
{
    (void)state;
    return pack_load("tests/scenes/tiny.json", NULL, &tiny);
}

static int free_tiny(void **state)
{
    (void)state;
    pack_free(&tiny);
    return 0;
}

/* A copy in a block of exactly `size` bytes, so that a sanitizer sees one byte read too many. */
static struct scene_header *copy(size_t size)
{
    struct scene_header *blob = malloc(size ? size : 1);
    assert_non_null(blob);
    memcpy(blob, tiny.scene, size < tiny.size ? size : tiny.size);
    return blob;
}

static void mend_crc(struct scene_header *blob)
{
    blob->crc = scene_crc32(0, (const uint8_t *)blob + 16, tiny.size - 16);
}

static void crc_is_the_one_of_ieee_802_3(void **state)
{
    (void)state;
    assert_int_equal(scene_crc32(0, "123456789", 9), 0xCBF43926u);
    assert_int_equal(scene_crc32(scene_crc32(0, "1234", 4), "56789", 5), 0xCBF43926u);
    assert_int_equal(scene_crc32(0, "", 0), 0);
}

static void a_good_scene_passes_with_whatever_follows_it(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size + 100);
    assert_int_equal(scene_check(blob, tiny.size), SCENE_OK);
    assert_int_equal(scene_check(blob, tiny.size + 100), SCENE_OK);
    free(blob);
}

static void a_scene_off_its_alignment_is_refused(void **state)
{
    (void)state;
    char *block = malloc(tiny.size + 4);
    assert_non_null(block);
    for (size_t off = 1; off < 4; off++) {
        memcpy(block + off, tiny.scene, tiny.size);
        assert_int_equal(scene_check(block + off, tiny.size), SCENE_E_ALIGN);
    }
    free(block);
}

static void every_truncation_is_refused(void **state)
{
    (void)state;
    for (size_t size = 0; size < tiny.size; size++) {
        struct scene_header *blob = copy(size);
        assert_int_equal(scene_check(blob, size), SCENE_E_SHORT);
        free(blob);
    }
}

static void every_flipped_bit_is_refused(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size);
    for (size_t bit = 0; bit < 8 * tiny.size; bit++) {
        ((uint8_t *)blob)[bit / 8] ^= 1u << bit % 8;
        assert_int_not_equal(scene_check(blob, tiny.size), SCENE_OK);
        ((uint8_t *)blob)[bit / 8] ^= 1u << bit % 8;
    }
    free(blob);
}

/* A small picture by every method: whatever the check lets through must draw within its memory. */
static void draw(const struct scene_header *blob, uint32_t time_ms)
{
    struct glint_config config = {.width = 32, .height = 24, .band_rows = 24, .format = GLINT_RGB565};
    struct glint_frame frame;
    struct glint_band band;
    for (unsigned i = 0; i < glint_choice_count; i++) {
        config.method = glint_choices[i].method;
        glint_fit_stores(&config, blob);
        config.memory_bytes = glint_memory_needed(&config);
        config.memory = malloc(config.memory_bytes);
        config.band[0] = malloc(glint_band_bytes(&config));
        assert_true(config.memory && config.band[0]);
        assert_int_equal(glint_init(&frame, &config), 0);
        assert_int_equal(glint_frame_begin(&frame, blob, time_ms), 0);
        while (glint_frame_next_band(&frame, &band))
            assert_int_equal(band.rows, 24);
        free(config.memory);
        free(config.band[0]);
    }
}

static void a_flipped_bit_under_a_mended_crc_is_refused_or_draws(void **state)
{
    (void)state;
    size_t refused = 0, drawn = 0;
    for (size_t bit = 0; bit < 8 * tiny.size; bit++) {
        struct scene_header *blob = copy(tiny.size);
        ((uint8_t *)blob)[bit / 8] ^= 1u << bit % 8;
        mend_crc(blob);
        if (scene_check(blob, tiny.size) != SCENE_OK)
            refused++;
        else if (bit % 5 == 0 || bit / 8 < sizeof *blob) { /* one in five keeps this test short */
            draw(blob, (uint32_t)bit);
            drawn++;
        }
        free(blob);
    }
    assert_true(refused > 1000 && drawn > 1000);
}

/* A field of the blob set to a value that it must not have. */
static void refuse(void *field, const void *value, size_t size, enum scene_fault fault, struct scene_header *blob)
{
    uint8_t old[16];
    memcpy(old, field, size);
    memcpy(field, value, size);
    mend_crc(blob);
    enum scene_fault got = scene_check(blob, tiny.size);
    if (got != fault)
        fail_msg("byte %zu: fault %d, not %d", (size_t)((uint8_t *)field - (uint8_t *)blob), got, fault);
    memcpy(field, old, size);
}

#define REFUSE(field, value, fault) \
    refuse(&(field), &(__typeof__(field)){(__typeof__(field))(value)}, sizeof(field), fault, blob)

static void absurd_headers_are_refused(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size);
    REFUSE(blob->magic, 0x474C5431, SCENE_E_MAGIC);
    REFUSE(blob->version, SCENE_VERSION + 1, SCENE_E_VERSION);
    REFUSE(blob->reserved, 1, SCENE_E_RANGE);
    REFUSE(blob->reserved2, 1, SCENE_E_RANGE);
    REFUSE(blob->effects, blob->effects | (USES_EFFECTS + 1), SCENE_E_RANGE);
    /* More than is needed may be there, but not less; of USES_CLIPPING there is only pack's word. */
    for (uint32_t bit = 1; bit < USES_CLIPPING; bit <<= 1)
        REFUSE(blob->effects, blob->effects ^ bit, blob->effects & bit ? SCENE_E_RANGE : SCENE_OK);
    REFUSE(blob->length, 0, SCENE_E_SHORT);
    REFUSE(blob->length, 15, SCENE_E_SHORT);
    REFUSE(blob->length, UINT32_MAX, SCENE_E_SHORT);
    REFUSE(blob->crc, blob->crc + 1, SCENE_OK); /* mended: the test's own tools work */
    REFUSE(blob->meshes, blob->meshes + 2, SCENE_E_STRUCTURE);
    REFUSE(blob->meshes, 0, SCENE_E_STRUCTURE);
    REFUSE(blob->meshes, sizeof *blob - 4, SCENE_E_STRUCTURE);
    REFUSE(blob->meshes, tiny.size, SCENE_E_STRUCTURE);
    REFUSE(blob->meshes, UINT32_MAX - 3, SCENE_E_STRUCTURE);
    REFUSE(blob->mesh_count, 65535, SCENE_E_STRUCTURE);
    REFUSE(blob->mesh_count, 0, SCENE_E_STRUCTURE);
    REFUSE(blob->materials, tiny.size - 4, SCENE_E_STRUCTURE);
    REFUSE(blob->power_count, 65535, SCENE_E_STRUCTURE);
    REFUSE(blob->key_count, 65535, SCENE_E_STRUCTURE);
    REFUSE(blob->light_count, SCENE_MAX_LIGHTS + 1, SCENE_E_RANGE);
    REFUSE(blob->object_count, SCENE_MAX_OBJECTS + 1, SCENE_E_RANGE);
    REFUSE(blob->ambient[1], 32769, SCENE_E_RANGE);
    REFUSE(blob->background[2], 65535, SCENE_E_RANGE);
    free(blob);
}

static void absurd_cameras_are_refused(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size);
    struct scene_camera *camera = &blob->camera;
    REFUSE(camera->kind, 2, SCENE_E_RANGE);
    REFUSE(camera->viewer, 2, SCENE_E_RANGE);
    REFUSE(camera->rotation[0], 0, SCENE_E_RANGE);
    REFUSE(camera->rotation[3], INT32_MIN, SCENE_E_RANGE);
    REFUSE(camera->rotation[0], camera->rotation[0] + 2048, SCENE_E_RANGE);
    REFUSE(camera->position[0], 1 << 30, SCENE_E_RANGE);
    REFUSE(camera->position[2], INT32_MIN, SCENE_E_RANGE);
    REFUSE(camera->focal, 4095, SCENE_E_RANGE);
    REFUSE(camera->focal, 1 << 30, SCENE_E_RANGE);
    REFUSE(camera->reference_width, 0, SCENE_E_RANGE);
    REFUSE(camera->reference_height, 2049, SCENE_E_RANGE);
    REFUSE(camera->near_plane, 255, SCENE_E_RANGE);
    REFUSE(camera->near_plane, camera->far_plane, SCENE_E_RANGE);
    REFUSE(camera->far_plane, -1, SCENE_E_RANGE);
    free(blob);
}

static void absurd_meshes_are_refused(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size);
    struct scene_mesh *mesh = (struct scene_mesh *)((uint8_t *)blob + blob->meshes);
    REFUSE(mesh->vertex_count, 2, SCENE_E_RANGE);
    REFUSE(mesh->vertex_count, 65536, SCENE_E_RANGE);
    REFUSE(mesh->vertex_count, 65535, SCENE_E_STRUCTURE);
    REFUSE(mesh->vertex_count, mesh->vertex_count - 1, SCENE_E_INDEX);
    REFUSE(mesh->triangle_count, 0, SCENE_E_RANGE);
    REFUSE(mesh->triangle_count, UINT32_MAX, SCENE_E_RANGE);
    REFUSE(mesh->triangle_count, 65535, SCENE_E_STRUCTURE);
    REFUSE(mesh->vertices, 0, SCENE_E_STRUCTURE);
    REFUSE(mesh->vertices, 4, SCENE_E_STRUCTURE);
    REFUSE(mesh->triangles, mesh->triangles + 1, SCENE_E_STRUCTURE);
    REFUSE(mesh->uvs, tiny.size - 4, SCENE_E_STRUCTURE);
    REFUSE(mesh->uvs, 2, SCENE_E_STRUCTURE);
    REFUSE(mesh->centre[1], -(1 << 30), SCENE_E_RANGE);
    REFUSE(mesh->extent, 63, SCENE_E_RANGE);
    REFUSE(mesh->extent, 1 << 30, SCENE_E_RANGE);
    REFUSE(mesh->radius, 0, SCENE_E_RANGE);
    REFUSE(mesh->radius, mesh->radius - 8, SCENE_E_RANGE); /* no longer holds the vertices */
    struct scene_vertex *vertex = (struct scene_vertex *)((uint8_t *)blob + mesh->vertices);
    REFUSE(vertex->normal[0], INT16_MIN, SCENE_E_RANGE);
    REFUSE(vertex->normal[0], vertex->normal[0] + 40, SCENE_E_RANGE);
    struct scene_triangle *triangle = (struct scene_triangle *)((uint8_t *)blob + mesh->triangles);
    REFUSE(triangle->corner[2], mesh->vertex_count, SCENE_E_INDEX);
    REFUSE(triangle->material, blob->material_count, SCENE_E_INDEX);
    REFUSE(triangle->flags, 8, SCENE_E_RANGE);
    REFUSE(triangle->bend[0], (uint16_t)(triangle->bend[0] + 40), SCENE_E_RANGE); /* not its normals' */
    free(blob);
}

/* As if the sphere's radius were rounded down: of a small mesh a step is much of it. */
static void a_radius_a_step_short_of_the_vertices_is_refused(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size);
    struct scene_mesh *mesh = (struct scene_mesh *)((uint8_t *)blob + blob->meshes);
    struct scene_vertex *vertex = (struct scene_vertex *)((uint8_t *)blob + mesh->vertices);
    double reach = 0;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        int16_t *p = vertex[i].position;
        for (int k = 0; k < 3; k++)
            p[k] = (int16_t)(p[k] * 3 / 5);
        reach = fmax(reach, sqrt((double)p[0] * p[0] + (double)p[1] * p[1] + (double)p[2] * p[2]));
    }
    for (mesh->extent = 64; mesh->extent < 256; mesh->extent++) {
        const double length = reach * mesh->extent / 32768;
        mesh->radius = (q16_t)ceil((reach + 1) * mesh->extent / 32768); /* and a position unit more: enough */
        mend_crc(blob);
        assert_int_equal(scene_check(blob, tiny.size), SCENE_OK);
        REFUSE(mesh->radius, (q16_t)ceil(length) - 1, SCENE_E_RANGE);
    }
    free(blob);
}

static void absurd_materials_are_refused(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size);
    struct scene_material *material = (struct scene_material *)((uint8_t *)blob + blob->materials);
    struct fx_power *power = (struct fx_power *)((uint8_t *)blob + blob->powers);
    REFUSE(material->diffuse[0], 32769, SCENE_E_RANGE);
    REFUSE(material->specular[2], 32769, SCENE_E_RANGE);
    REFUSE(material->ka, 32769, SCENE_E_RANGE);
    REFUSE(material->ks, 65535, SCENE_E_RANGE);
    REFUSE(material->shininess, 0, SCENE_E_RANGE);
    REFUSE(material->shininess, material->shininess + 1, SCENE_E_RANGE); /* not its table's */
    REFUSE(material->power, blob->power_count, SCENE_E_INDEX);
    REFUSE(material->flags, 4, SCENE_E_RANGE);
    REFUSE(power->exponent, 0, SCENE_E_RANGE);
    REFUSE(power->octave, FX_POWER_MAX_OCTAVE + 1, SCENE_E_RANGE);
    REFUSE(power->value[64], 32769, SCENE_E_RANGE);
    REFUSE(power->value[FX_POWER_STEPS], 32769, SCENE_E_RANGE);
    REFUSE(power->value[FX_POWER_STEPS + 1], 0, SCENE_E_RANGE);
    free(blob);
}

static void absurd_objects_and_motions_are_refused(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size);
    struct scene_object *object = (struct scene_object *)((uint8_t *)blob + blob->objects);
    struct scene_key *key = (struct scene_key *)((uint8_t *)blob + blob->keys);
    assert_int_equal(object[0].motion.kind, MOTION_SPIN);
    assert_int_equal(object[1].motion.kind, MOTION_KEYS);
    REFUSE(object->mesh, blob->mesh_count, SCENE_E_INDEX);
    REFUSE(object->flags, 1, SCENE_E_RANGE);
    REFUSE(object->rotation[0], 1 << 20, SCENE_E_RANGE);
    REFUSE(object->scale, 255, SCENE_E_RANGE);
    REFUSE(object->scale, 1 << 24, SCENE_E_RANGE);
    REFUSE(object->position[1], INT32_MAX, SCENE_E_RANGE);
    REFUSE(object->motion.kind, 3, SCENE_E_RANGE);
    REFUSE(object->motion.kind, MOTION_KEYS, SCENE_E_RANGE); /* without keys */
    REFUSE(object->motion.reserved, 1, SCENE_E_RANGE);
    REFUSE(object->motion.axis[1], 0, SCENE_E_RANGE);
    REFUSE(object->motion.rate, 1 << 24, SCENE_E_RANGE);
    REFUSE(object->motion.rate, INT32_MIN, SCENE_E_RANGE);
    REFUSE(object[1].motion.first_key, blob->key_count, SCENE_E_INDEX);
    REFUSE(object[1].motion.key_count, 65535, SCENE_E_INDEX);
    REFUSE(key[1].time_ms, key[0].time_ms, SCENE_E_RANGE);
    REFUSE(key[0].scale, 0, SCENE_E_RANGE);
    REFUSE(key[1].rotation[0], 0, SCENE_E_RANGE);
    REFUSE(key[1].position[2], INT32_MIN, SCENE_E_RANGE);
    free(blob);
}

static void absurd_lights_are_refused(void **state)
{
    (void)state;
    struct scene_header *blob = copy(tiny.size);
    struct scene_light *light = (struct scene_light *)((uint8_t *)blob + blob->lights);
    assert_int_equal(light[1].kind, LIGHT_POINT);
    REFUSE(light->kind, 2, SCENE_E_RANGE);
    REFUSE(light->flags, 1, SCENE_E_RANGE);
    REFUSE(light->reserved, 1, SCENE_E_RANGE);
    REFUSE(light->colour[0], 32769, SCENE_E_RANGE);
    REFUSE(light->vector[1], 0, SCENE_E_RANGE);
    REFUSE(light[1].vector[1], 1 << 30, SCENE_E_RANGE);
    REFUSE(light->motion.rate, INT32_MAX, SCENE_E_RANGE);
    free(blob);
}

static void every_fault_has_a_sentence_of_its_own(void **state)
{
    (void)state;
    for (int a = SCENE_E_RANGE; a <= SCENE_OK; a++)
        for (int b = SCENE_E_RANGE; b < a; b++)
            assert_string_not_equal(scene_fault_text((enum scene_fault)a), scene_fault_text((enum scene_fault)b));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crc_is_the_one_of_ieee_802_3),
        cmocka_unit_test(a_good_scene_passes_with_whatever_follows_it),
        cmocka_unit_test(a_scene_off_its_alignment_is_refused),
        cmocka_unit_test(every_truncation_is_refused),
        cmocka_unit_test(every_flipped_bit_is_refused),
        cmocka_unit_test(a_flipped_bit_under_a_mended_crc_is_refused_or_draws),
        cmocka_unit_test(absurd_headers_are_refused),
        cmocka_unit_test(absurd_cameras_are_refused),
        cmocka_unit_test(absurd_meshes_are_refused),
        cmocka_unit_test(a_radius_a_step_short_of_the_vertices_is_refused),
        cmocka_unit_test(absurd_materials_are_refused),
        cmocka_unit_test(absurd_objects_and_motions_are_refused),
        cmocka_unit_test(absurd_lights_are_refused),
        cmocka_unit_test(every_fault_has_a_sentence_of_its_own),
    };
    return cmocka_run_group_tests(tests, load_tiny, free_tiny);
}

/* SPDX-License-Identifier: MIT */
/* Textures in a scene's blob: what scene_check() refuses of them, and how they are packed. */
#include "pack/palette.h"
#include "pack/report.h"
#include "scene/texel.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "pack_case.h"

#define SCENE(texture)                                                                     \
    "\"textures\": {\"t\": {" texture "}}, \"materials\": {\"m\": {\"texture\": \"t\"}}, " \
    "\"meshes\": {\"p\": {\"shape\": \"plane\", \"material\": \"m\"}}, \"objects\": [{\"mesh\": \"p\"}]"
#define PALETTE "\"pattern\": \"checker\", \"size\": [8, 4], \"cells\": [4, 2], \"format\": \"palette8\""

static struct scene_header *blob;
static size_t size;

static void refuse(void *field, const void *value, size_t bytes, enum scene_fault fault)
{
    uint8_t old[8];
    memcpy(old, field, bytes);
    memcpy(field, value, bytes);
    blob->crc = scene_crc32(0, (const uint8_t *)blob + 16, size - 16);
    const enum scene_fault got = scene_check(blob, size);
    if (got != fault)
        fail_msg("byte %zu: fault %d, not %d", (size_t)((uint8_t *)field - (uint8_t *)blob), got, fault);
    memcpy(field, old, bytes);
}

#define REFUSE(field, value, fault) \
    refuse(&(field), &(__typeof__(field)){(__typeof__(field))(value)}, sizeof(field), fault)

static void absurd_textures_are_refused(void **state)
{
    (void)state;
    struct pack_result r = case_scene(SCENE(PALETTE));
    size = r.size;
    blob = malloc(size);
    assert_non_null(blob);
    memcpy(blob, r.scene, size);
    struct scene_texture *t = (struct scene_texture *)((uint8_t *)blob + blob->textures);
    struct scene_material *m = (struct scene_material *)((uint8_t *)blob + blob->materials);
    struct scene_mesh *mesh = (struct scene_mesh *)((uint8_t *)blob + blob->meshes);
    assert_int_equal(blob->texture_count, 1);
    assert_int_equal(t->colours, 2);
    REFUSE(t->flags, t->flags, SCENE_OK); /* the test's own tools work */
    REFUSE(blob->texture_count, 65535, SCENE_E_STRUCTURE);
    REFUSE(blob->texture_count, 0, SCENE_E_STRUCTURE);
    REFUSE(blob->textures, size - 4, SCENE_E_STRUCTURE);
    REFUSE(t->texels, 0, SCENE_E_STRUCTURE);
    REFUSE(t->texels, t->texels + 2, SCENE_E_STRUCTURE);
    REFUSE(t->texels, size - 28, SCENE_E_STRUCTURE);
    REFUSE(t->palette, 0, SCENE_E_STRUCTURE);
    REFUSE(t->palette, size - 4, SCENE_E_STRUCTURE);
    REFUSE(t->log2_width, 11, SCENE_E_RANGE);
    REFUSE(t->log2_width, 10, SCENE_E_STRUCTURE);
    REFUSE(t->log2_height, 255, SCENE_E_RANGE);
    REFUSE(t->log2_height, 10, SCENE_E_STRUCTURE);
    REFUSE(t->format, TEXTURE_FORMATS, SCENE_E_RANGE);
    REFUSE(t->format, TEXTURE_RGB565, SCENE_E_RANGE); /* with a palette */
    REFUSE(t->format, TEXTURE_BUMP8, SCENE_E_RANGE);
    REFUSE(t->flags, 8, SCENE_E_RANGE);
    REFUSE(t->contrast, t->contrast - 1, SCENE_E_RANGE);
    REFUSE(t->contrast, t->contrast + 1, SCENE_OK); /* a bound, not the value */
    REFUSE(t->steepness, 1, SCENE_E_RANGE);
    REFUSE(t->colours, 1, SCENE_E_INDEX); /* the texels have two */
    REFUSE(t->colours, 0, SCENE_E_RANGE);
    REFUSE(t->colours, 257, SCENE_E_RANGE);
    REFUSE(t->colours, 256, SCENE_E_STRUCTURE);
    REFUSE(t->reserved, 1, SCENE_E_RANGE);
    REFUSE(m->texture, 1, SCENE_E_INDEX);
    REFUSE(m->bump, 0, SCENE_E_INDEX); /* on a mesh without tangents */
    REFUSE(m->bump, 1, SCENE_E_INDEX);
    REFUSE(mesh->uvs, 0, SCENE_E_INDEX); /* under a texture */
    REFUSE(blob->effects, blob->effects & ~USES_TEXTURE, SCENE_E_RANGE);
    REFUSE(blob->fog.kind, FOG_EXPONENTIAL + 1, SCENE_E_RANGE);
    REFUSE(blob->fog.kind, FOG_LINEAR, SCENE_E_RANGE); /* from 0 to 0 */
    REFUSE(blob->fog.kind, FOG_EXPONENTIAL, SCENE_E_RANGE);
    REFUSE(blob->fog.to, 65536, SCENE_E_RANGE);
    REFUSE(blob->fog.density, 1, SCENE_E_RANGE);
    REFUSE(blob->fog.colour[0], 32769, SCENE_E_RANGE);
    free(blob);
    pack_free(&r);
}

static void a_checker_packs_exactly_and_upright(void **state)
{
    (void)state;
    struct pack_result r = case_scene(SCENE(PALETTE ", \"colours\": [[1, 0, 0], [0, 0.2, 1]], \"wrap\": \"clamp\""));
    const struct scene_texture *t = scene_textures(r.scene);
    assert_int_equal(t->log2_width, 3);
    assert_int_equal(t->log2_height, 2);
    assert_int_equal(t->flags, TEXTURE_BILINEAR | TEXTURE_CLAMP_U | TEXTURE_CLAMP_V);
    assert_int_equal(t->contrast, 255 << 8);
    assert_int_equal(texel_at(r.scene, t, 0), 0xff0000);
    assert_int_equal(texel_at(r.scene, t, 1), 0xff0000);
    assert_int_equal(texel_at(r.scene, t, 2), 0x0033ff);
    assert_int_equal(texel_at(r.scene, t, 8 + 2), 0x0033ff);
    assert_int_equal(texel_at(r.scene, t, 16), 0x0033ff);
    assert_true(r.report->textures[0].error == 0);
    assert_int_equal(r.report->textures[0].colours_read, 2);
    pack_free(&r);
}

static void other_sizes_are_resampled_to_powers_of_two(void **state)
{
    (void)state;
    struct pack_result r = case_scene(SCENE("\"pattern\": \"gradient\", \"size\": [100, 3], \"cells\": [1, 1], "
                                            "\"colours\": [[0, 0, 0], [1, 1, 1]], \"wrap\": \"clamp\""));
    const struct scene_texture *t = scene_textures(r.scene);
    assert_int_equal(t->log2_width, 7);
    assert_int_equal(t->log2_height, 2);
    assert_int_equal(r.report->textures[0].read[0], 100);
    assert_int_equal(r.report->textures[0].size[0], 128);
    for (uint32_t i = 0; i < 128; i++) { /* still a ramp, to 5 bits */
        const int green = (int)(texel_at(r.scene, t, i) >> 8 & 0xff);
        assert_true(abs(green - (int)lrint((i + .5) * 255 / 128)) <= 4);
    }
    pack_free(&r);
}

/* A triangle with these lines of texture coordinates, its texture repeating or clamped, packed. */
static int load_coordinates(const char *lines, int clamp, struct pack_result *r, char *said, size_t said_bytes)
{
    struct case_file file;
    char scene[96], text[512];
    const int length = snprintf(text, sizeof text, "v -1 -1 0\nv 1 -1 0\nv 1 1 0\n%sf 1/1 2/2 3/2\n", lines);
    case_write(&file, "far.obj", text, (size_t)length);
    snprintf(scene, sizeof scene, "%s/scene.json", file.folder);
    FILE *out = fopen(scene, "w");
    assert_non_null(out);
    fprintf(out,
            "{" CASE_CAMERA ", \"textures\": {\"t\": {\"pattern\": \"noise\", \"wrap\": \"%s\"}}, \"materials\": "
            "{\"m\": {\"texture\": \"t\"}}, \"meshes\": {\"p\": {\"file\": \"far.obj\", \"material\": \"m\"}}, "
            "\"objects\": [{\"mesh\": \"p\"}]}",
            clamp ? "clamp" : "repeat");
    fclose(out);
    const int answer = case_load_path(scene, NULL, r, said, said_bytes);
    unlink(scene);
    case_remove(&file);
    return answer;
}

static void whole_turns_are_taken_off_where_textures_repeat(void **state)
{
    (void)state;
    struct pack_result r;
    char said[256];
    static const char far[] = "vt 100 0\nvt 101 0\nvt 101 -37\nvt 130 0\n";
    assert_int_equal(load_coordinates(far, 1, &r, said, sizeof said), 1);
    assert_non_null(strstr(said, "beyond -6..6 of a clamped texture"));
    assert_int_equal(load_coordinates(far, 0, &r, said, sizeof said), 0);
    const int16_t(*uv)[2] = scene_at(r.scene, scene_meshes(r.scene)->uvs);
    assert_int_equal(uv[1][0] - uv[0][0], 4096);
    assert_int_equal(uv[0][0] % 4096, 0);
    pack_free(&r);
}

/* Interpolated modulo 16 turns, what is nearer to 8 than its roundings would come round to the other border. */
static void coordinates_of_a_clamped_texture_keep_away_from_8_turns(void **state)
{
    (void)state;
    struct pack_result r;
    char said[256];
    assert_int_equal(load_coordinates("vt -6 0\nvt 6 1\n", 1, &r, said, sizeof said), 0);
    pack_free(&r);
    assert_int_equal(load_coordinates("vt -6.01 0\nvt 1 1\n", 1, &r, said, sizeof said), 1);
    assert_int_equal(load_coordinates("vt 0 0\nvt 1 6.01\n", 1, &r, said, sizeof said), 1);
    assert_int_equal(load_coordinates("vt -8 0\nvt 7.9 1\n", 0, &r, said, sizeof said), 0);
    pack_free(&r);
}

static void median_cut_keeps_colours_near_and_few_ones_exact(void **state)
{
    (void)state;
    static uint32_t rgb[64 * 64], palette[256];
    static uint8_t index[64 * 64];
    unsigned different;
    double sum = 0;
    for (unsigned i = 0; i < 64 * 64; i++)
        rgb[i] = (i & 63) * 4 << 16 | (i >> 6) * 4 << 8 | ((i & 63) ^ (i >> 6)) * 4;
    assert_int_equal(palette_make(rgb, 64 * 64, index, palette, &different), 256);
    assert_int_equal(different, 64 * 64);
    for (unsigned i = 0; i < 64 * 64; i++)
        for (int shift = 0; shift < 24; shift += 8) {
            const double d = (double)(rgb[i] >> shift & 0xff) - (double)(palette[index[i]] >> shift & 0xff);
            sum += d * d;
        }
    assert_true(sqrt(sum / (3 * 64 * 64)) < 12); /* 16 colours in each of 256 boxes */
    for (unsigned i = 0; i < 64 * 64; i++)
        rgb[i] = (i % 256) * 0x010101;
    assert_int_equal(palette_make(rgb, 64 * 64, index, palette, &different), 256);
    for (unsigned i = 0; i < 64 * 64; i++)
        assert_int_equal(palette[index[i]], rgb[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(absurd_textures_are_refused),
        cmocka_unit_test(a_checker_packs_exactly_and_upright),
        cmocka_unit_test(other_sizes_are_resampled_to_powers_of_two),
        cmocka_unit_test(whole_turns_are_taken_off_where_textures_repeat),
        cmocka_unit_test(coordinates_of_a_clamped_texture_keep_away_from_8_turns),
        cmocka_unit_test(median_cut_keeps_colours_near_and_few_ones_exact),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

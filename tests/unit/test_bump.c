/* SPDX-License-Identifier: MIT */
/* Bump mapping: the renderer's three ways against each other and the truth, on the torus of 288 triangles. */
#include "reference/reference.h"
#include "shade/bump.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "frame_case.h"
#include "pack/pack.h"
#include "random.h"

#define SIDE 240

static struct pack_result load(const char *name)
{
    char path[128];
    struct pack_result packed;
    snprintf(path, sizeof path, "tests/scenes/%s.json", name);
    assert_int_equal(pack_load(path, NULL, &packed), PACK_OK);
    return packed;
}

static uint8_t *draw(const struct scene_header *scene, const struct glint_method *method, enum glint_format format,
                     unsigned rows, unsigned tables, struct glint_stats *stats)
{
    struct frame_case f = frame_case_small(SIDE, SIDE, format);
    f.config.method = method;
    f.config.band_rows = (uint16_t)rows;
    f.config.tables = (uint8_t)tables;
    return frame_case_picture(f, scene, 0, stats);
}

/* Over the covered pixels. */
static double psnr(const uint8_t *a, const uint8_t *b, size_t bytes, size_t covered)
{
    double sum = 0;
    for (size_t i = 0; i < bytes; i++)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return 10 * log10(255. * 255 * (double)covered / sum);
}

static void quadratic_vectors_are_as_good_as_normalised_ones_and_linear_ones_are_not(void **state)
{
    (void)state;
    struct pack_result packed = load("bump-nearest");
    for (unsigned tables = 0; tables < 2; tables++) { /* in runs, and straight into grey */
        struct glint_stats stats;
        uint8_t *truth = draw(packed.scene, &glint_bump_normalised, GLINT_GREY8, 0, tables, &stats);
        const size_t covered = stats.pixels[GLINT_BUMP_NORMALISED], all = SIDE * SIDE;
        assert_int_equal(covered, 25443);
        uint8_t *linear = draw(packed.scene, &glint_bump_linear, GLINT_GREY8, 0, tables, NULL);
        uint8_t *bent = draw(packed.scene, &glint_bump_quadratic, GLINT_GREY8, 0, tables, NULL);
        const double poor = psnr(linear, truth, all, covered), good = psnr(bent, truth, all, covered);
        assert_true(poor > 27 && poor < 30);
        assert_true(good > 53);
        free(linear);
        free(bent);
        for (int upright = 0; upright < 2; upright++) { /* the paper's middles */
            const struct glint_method *method = upright ? &glint_bump_upright : &glint_bump_frames;
            bent = draw(packed.scene, method, GLINT_GREY8, 0, tables, NULL);
            const double paper = psnr(bent, truth, all, covered);
            assert_true(upright ? paper > 40 && paper < 42 : paper > 38 && paper < 40);
            free(bent);
        }
        free(truth);
    }
    pack_free(&packed);
}

/* At most `above` values are off by more than `most`, and none by more than `beyond`. */
static void compare(const uint8_t *picture, const struct reference_image *truth, size_t bytes, double most,
                    size_t above, double beyond)
{
    size_t count = 0;
    for (size_t i = 0; i < bytes; i++) {
        const double difference = fabs(picture[i] - 255 * truth->value[i]);
        assert_true(difference <= beyond);
        count += difference > most;
    }
    assert_true(count <= above);
}

static void every_way_is_its_twin_in_double_precision(void **state)
{
    static const struct {
        const struct glint_method *method;
        enum reference_method twin;
    } ways[] = {{&glint_bump_linear, REFERENCE_BUMP_LINEAR},
                {&glint_bump_quadratic, REFERENCE_BUMP_QUADRATIC},
                {&glint_bump_frames, REFERENCE_BUMP_FRAMES},
                {&glint_bump_upright, REFERENCE_BUMP_UPRIGHT},
                {&glint_bump_normalised, REFERENCE_PHONG}};
    (void)state;
    for (int nearest = 0; nearest < 2; nearest++) {
        struct pack_result packed = load(nearest ? "bump-nearest" : "bump-torus288");
        for (size_t i = 0; i < sizeof ways / sizeof *ways; i++)
            for (unsigned tables = 0; tables < 2; tables++) {
                struct reference_options options = {.method = ways[i].twin, .grey = true};
                struct reference_image image;
                assert_true(reference_render(packed.scene, &options, &image));
                uint8_t *picture = draw(packed.scene, ways[i].method, GLINT_GREY8, 0, tables, NULL);
                /* of the nearest texel, a few pixels so near to a border take the neighbour's */
                compare(picture, &image, SIDE * SIDE, 1.5, nearest ? 40 : 0, nearest ? 12 : 1.5);
                free(picture);
                reference_free(&image);
            }
        pack_free(&packed);
    }
}

/* Without a highlight the table holds nothing: its loop makes the pixels of the others, which round once more. */
static void a_matt_map_is_the_same_by_a_table_and_without(void **state)
{
    static const struct glint_method *const methods[] = {&glint_bump_linear, &glint_bump_quadratic,
                                                         &glint_bump_normalised};
    (void)state;
    struct pack_result packed = load("bump-nearest");
    struct scene_material *material = (struct scene_material *)(uintptr_t)scene_materials(packed.scene);
    material->ks = 0;
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        int most = 0, brightest = 0;
        uint8_t *with = draw(packed.scene, methods[i], GLINT_GREY8, 0, 1, NULL);
        uint8_t *without = draw(packed.scene, methods[i], GLINT_GREY8, 0, 0, NULL);
        for (int k = 0; k < SIDE * SIDE; k++) {
            const int off = abs(with[k] - without[k]);
            most = off > most ? off : most;
            brightest = with[k] > brightest ? with[k] : brightest;
        }
        assert_in_range(most, 0, 1);
        assert_in_range(brightest, 100, 255);
        free(with);
        free(without);
    }
    pack_free(&packed);
}

static void auto_keeps_its_budget_with_texture_perspective_and_near_lights_too(void **state)
{
    static const unsigned budgets[] = {1, 2, 4, 8, 16, 32};
    (void)state;
    for (int brick = 0; brick < 2; brick++) {
        struct pack_result packed = load(brick ? "bump-brick" : "bump-torus288");
        struct reference_options options = {.method = REFERENCE_PHONG};
        struct reference_image image;
        uint32_t ways = 0;
        assert_true(reference_render(packed.scene, &options, &image));
        for (size_t i = 0; i < sizeof budgets / sizeof *budgets; i++) {
            struct frame_case f = frame_case_small(SIDE, SIDE, GLINT_RGB888);
            struct glint_stats stats;
            f.config.method = &glint_auto;
            f.config.budget = (uint16_t)(budgets[i] << 8);
            uint8_t *picture = frame_case_picture(f, packed.scene, 0, &stats);
            compare(picture, &image, 3 * SIDE * SIDE, 255, 0, budgets[i] + 1.5);
            for (int id = GLINT_BUMP_LINEAR; id <= GLINT_BUMP_NORMALISED; id++)
                ways |= (uint32_t)(stats.drawn[id] > 0) << (id - GLINT_BUMP_LINEAR);
            free(picture);
        }
        assert_int_equal(ways, brick ? 7 : 6); /* each has its turn; the torus never bears linear ones */
        reference_free(&image);
        pack_free(&packed);
    }
}

static void a_picture_does_not_depend_on_its_bands(void **state)
{
    static const struct glint_method *const methods[] = {&glint_bump_linear, &glint_bump_quadratic,
                                                         &glint_bump_normalised};
    (void)state;
    static const char *const names[] = {"bump-torus288", "bump-nearest", "bump-brick"};
    for (int scene = 0; scene < 3; scene++) {
        struct pack_result packed = load(names[scene]);
        for (size_t i = 0; i < 3; i++)
            for (unsigned tables = 0; tables < 2; tables++) {
                uint8_t *whole = draw(packed.scene, methods[i], GLINT_GREY8, 0, tables, NULL);
                uint8_t *bands = draw(packed.scene, methods[i], GLINT_GREY8, 7, tables, NULL);
                assert_memory_equal(whole, bands, SIDE * SIDE);
                free(whole);
                free(bands);
            }
        pack_free(&packed);
    }
}

/* The distance of interpolated L' from length 1, per cent, over all triangles. */
static void lengths(const struct pack_result *packed, double *mean, double *most)
{
    const struct scene_mesh *mesh = scene_meshes(packed->scene);
    const struct scene_vertex *vertex = scene_at(packed->scene, mesh->vertices);
    const struct scene_tangent *tangent = scene_at(packed->scene, mesh->tangents);
    const struct scene_triangle *triangle = scene_at(packed->scene, mesh->triangles);
    const int32_t light[3] = {7372, 8192, 12288};
    q14_t towards[3];
    size_t count = 0;
    object_unit(light, towards);
    *mean = *most = 0;
    for (uint32_t t = 0; t < mesh->triangle_count; t++) {
        int16_t turned[3][3];
        int32_t bulge[3][3];
        for (int k = 0; k < 3; k++) {
            struct bump_frame frame;
            const unsigned v = triangle[t].corner[k];
            bump_make_frame(tangent[v].tangent, tangent[v].sign, vertex[v].normal, &frame);
            bump_turn(&frame, towards, turned[k]);
        }
        for (int k = 0; k < 3; k++)
            bump_average(turned[k], turned[(k + 1) % 3], bulge[k]);
        for (int i = 0; i <= 16; i++)
            for (int j = 0; i + j <= 16; j++, count++) {
                const double at[3] = {(16 - i - j) / 16., i / 16., j / 16.};
                double square = 0;
                for (int axis = 0; axis < 3; axis++) {
                    double value = 0;
                    for (int k = 0; k < 3; k++)
                        value += at[k] * turned[k][axis] / 16384. -
                                 at[k] * at[(k + 1) % 3] * bulge[k][axis] / (double)(1 << 28);
                    square += value * value;
                }
                const double off = fabs(sqrt(square) - 1) * 100;
                *mean += off;
                *most = fmax(*most, off);
            }
    }
    *mean /= (double)count;
}

static void middles_that_are_averages_keep_the_length_of_vectors_on_the_torus(void **state)
{
    double mean, most;
    (void)state;
    struct pack_result packed = load("bump-torus288");
    lengths(&packed, &mean, &most);
    assert_true(mean < .024);
    assert_true(most < .12);
    pack_free(&packed);
}

static void a_middle_by_its_bulges_is_the_unit_average(void **state)
{
    (void)state;
    random_seed(1);
    for (int n = 0; n < 20000; n++) {
        q14_t a[3], b[3];
        int32_t bulge[3];
        double sum[3], length = 0;
        double from[3], to[3];
        random_direction(from, 3);
        random_direction(to, 3);
        for (int i = 0; i < 3; i++) {
            a[i] = (q14_t)lround(from[i] * 16384);
            b[i] = (q14_t)lround(to[i] * 16384);
        }
        for (int i = 0; i < 3; i++) {
            sum[i] = (a[i] + b[i]) / 16384.;
            length += sum[i] * sum[i];
        }
        if (length < .25)
            continue; /* more than 151 degrees apart */
        bump_average(a, b, bulge);
        for (int i = 0; i < 3; i++)
            assert_true(fabs(sum[i] / 2 - bulge[i] / 4. / (1 << 28) - sum[i] / sqrt(length)) < 3e-4);
    }
}

static void set_up(void (*shade)(struct shade_setup *, const struct shade_input *), unsigned highlights,
                   struct shade_setup *setup)
{
    static const int16_t place[3][3] = {{-800, -800, 0}, {800, -800, 0}, {0, 800, 0}};
    static const struct scene_vertex vertex[3] = {
        {{0, 0, 0}, {0, 0, 16384}}, {{1, 0, 0}, {0, 4588, 15729}}, {{0, 1, 0}, {0, -4588, 15729}}};
    static const struct scene_tangent tangent[3] = {{{16384, 0, 0}, 1}, {{16384, 0, 0}, 1}, {{16384, 0, 0}, 1}};
    static const int16_t uv[3][2] = {{0, 0}, {4096, 0}, {0, 4096}};
    static const struct scene_triangle triangle = {.corner = {0, 2, 1}};
    const struct object_state object = {.light[0] = {.towards = {0, 0, 16384}, .half = {0, 4588, 15729}}};
    const struct surface surface = {.channels = 1,
                                    .lights = 1,
                                    .highlights = (uint8_t)highlights,
                                    .fold = 65535,
                                    .bump = {.log2_width = 4, .log2_height = 4, .steepness = 16384}};
    const struct shade_input in = {.place = {place[0], place[1], place[2]},
                                   .triangle = &triangle,
                                   .vertices = vertex,
                                   .tangents = tangent,
                                   .uvs = uv,
                                   .object = &object,
                                   .surface = &surface,
                                   .texture = GLINT_TEXTURE_AFFINE,
                                   .grey_table = 1};
    *setup = (struct shade_setup){.perspective = 0};
    for (unsigned k = 0; k < SHADE_BUMP_CHANNELS; k++)
        setup->bump[k].p = (struct polynomial){1, 2, 3, 4, 5, 6};
    assert_int_equal(plane_setup(&setup->plane, in.place, SIDE, SIDE), 1);
    shade(setup, &in);
}

/* L' has 3 channels, H' 3 more; of 1 less the squares of their lengths, where these are to be divided by, each has one.
 */
static void a_light_fills_its_own_channels_alone(void **state)
{
    static void (*const shades[])(struct shade_setup *, const struct shade_input *) = {
        shade_bump_linear, shade_bump_quadratic, shade_bump_normalised};
    static const struct polynomial untouched = {1, 2, 3, 4, 5, 6};
    (void)state;
    for (int way = 0; way < 3; way++)
        for (unsigned highlights = 0; highlights < 2; highlights++) {
            struct shade_setup setup;
            set_up(shades[way], highlights, &setup);
            assert_int_equal(setup.in_steps, 1);
            assert_int_equal(setup.length, way == 2);
            for (unsigned k = 0; k < SHADE_BUMP_CHANNELS; k++) {
                const unsigned squares = way == 2 ? 1 + highlights : 0;
                const int filled = k < BUMP_SQUARE ? k < BUMP_HALF * (1 + highlights) : k < BUMP_SQUARE + squares;
                assert_int_equal(memcmp(&setup.bump[k].p, &untouched, sizeof untouched) != 0, filled);
            }
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quadratic_vectors_are_as_good_as_normalised_ones_and_linear_ones_are_not),
        cmocka_unit_test(every_way_is_its_twin_in_double_precision),
        cmocka_unit_test(a_matt_map_is_the_same_by_a_table_and_without),
        cmocka_unit_test(auto_keeps_its_budget_with_texture_perspective_and_near_lights_too),
        cmocka_unit_test(a_picture_does_not_depend_on_its_bands),
        cmocka_unit_test(middles_that_are_averages_keep_the_length_of_vectors_on_the_torus),
        cmocka_unit_test(a_middle_by_its_bulges_is_the_unit_average),
        cmocka_unit_test(a_light_fills_its_own_channels_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

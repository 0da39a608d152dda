/* SPDX-License-Identifier: MIT */
/* Whole pictures of the methods that interpolate normals: quality, bands, clipping, near lights. */
#include "compare/compare.h"
#include "pack/pack.h"
#include "reference/reference.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>

#include "frame_case.h"
#include "random.h"
#include "scene_case.h"

static const struct glint_method *const methods[] = {&glint_overveld, &glint_overveld_scan, &glint_biquadratic,
                                                     &glint_biquadratic_perspective, &glint_phong_perspective};

#define METHODS (sizeof methods / sizeof *methods)

static const char *name_of(const struct glint_method *method)
{
    unsigned i = 0;
    while (glint_choices[i].method != method)
        i++;
    return glint_choices[i].name;
}

static struct frame_case case_of(const struct glint_method *method, unsigned size, enum glint_format format)
{
    struct frame_case f = frame_case_small(size, size, format);
    f.config.method = method;
    return f;
}

/* An 8-bit picture of a scene against per-pixel Phong in double precision that is not rounded. */
static struct compare_result measure(const char *path, unsigned shininess, const struct glint_method *method)
{
    const struct pack_options pack = {.shininess = shininess};
    const struct reference_options options = {.method = REFERENCE_PHONG, .grey = true};
    struct pack_result packed;
    struct reference_image truth;
    struct compare_result result;
    assert_int_equal(pack_load(path, &pack, &packed), PACK_OK);
    assert_true(reference_render(packed.scene, &options, &truth));
    size_t pixels = (size_t)truth.width * truth.height;
    double *value = malloc(pixels * sizeof *value);
    uint8_t *picture = frame_case_picture(case_of(method, truth.width, GLINT_GREY8), packed.scene, 0, NULL);
    for (size_t i = 0; i < pixels; i++) {
        value[i] = picture[i];
        truth.value[i] *= 255;
    }
    compare_values(value, truth.value, truth.covered, pixels, 1, &result);
    print_message("%s n %u %s: %.2f dB, largest %.2f\n", path, shininess, name_of(method), result.psnr_db, result.max);
    free(picture);
    free(value);
    reference_free(&truth);
    pack_free(&packed);
    return result;
}

/* Torus 288. Ideal arithmetic with an output that is not rounded has 60.1 / 2.5, 59.0 / 3.7 and 59.1 / 4.2; rounding it
 * to 8 bits alone is 58.9 dB and half a step. */
static void biquadratic_is_nearly_as_good_as_in_ideal_arithmetic(void **state)
{
    static const struct {
        unsigned shininess;
        double psnr, max;
    } wanted[] = {{5, 55.9, 3.0}, {20, 55.3, 4.2}, {50, 55.2, 4.7}};
    (void)state;
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        struct compare_result flat = measure("tests/scenes/torus288.json", wanted[i].shininess, &glint_biquadratic);
        struct compare_result correct =
            measure("tests/scenes/torus288-persp.json", wanted[i].shininess, &glint_biquadratic_perspective);
        assert_true(flat.psnr_db > wanted[i].psnr && flat.max < wanted[i].max);
        assert_true(correct.psnr_db > wanted[i].psnr && correct.max < wanted[i].max);
    }
    /* 51.7 before rounding */
    assert_true(measure("tests/scenes/torus288-persp.json", 20, &glint_biquadratic).psnr_db < 51.5);
}

/* In two levels it is what the table of ideal figures has: 26.4 / 90, 28.1 / 70, 28.6 / 74. */
static void overveld_is_as_bad_as_in_ideal_arithmetic(void **state)
{
    static const struct {
        unsigned shininess;
        double psnr, max, six;
    } wanted[] = {{5, 26.4, 90, 38.13}, {20, 28.1, 70, 39.26}, {50, 28.6, 74, 40.31}};
    (void)state;
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        struct compare_result scan = measure("tests/scenes/torus288.json", wanted[i].shininess, &glint_overveld_scan);
        struct compare_result six = measure("tests/scenes/torus288.json", wanted[i].shininess, &glint_overveld);
        assert_true(fabs(scan.psnr_db - wanted[i].psnr) < .06 && fabs(scan.max - wanted[i].max) < 1);
        assert_true(fabs(six.psnr_db - wanted[i].six) < .06);
    }
}

/* Linear on the screen, phong has 50.9 dB there. */
static void phong_in_perspective_is_the_truth_rounded(void **state)
{
    static const char *const paths[] = {"tests/scenes/torus288-persp.json", "tests/scenes/torus800-persp.json",
                                        "tests/scenes/sphere690-persp.json"};
    (void)state;
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++) {
        struct compare_result result = measure(paths[i], 20, &glint_phong_perspective);
        assert_true(result.max < .75 && result.psnr_db > 58.3);
    }
}

/* No edge of a sphere has an inflection. */
static void triangles_without_a_zigzag_edge_are_drawn_as_by_phong(void **state)
{
    static const char *const paths[] = {"tests/scenes/sphere690.json", "tests/scenes/sphere690-persp.json"};
    const struct glint_method *const pairs[][2] = {{&glint_phong, &glint_biquadratic},
                                                   {&glint_phong_perspective, &glint_biquadratic_perspective}};
    (void)state;
    for (int i = 0; i < 4; i++) {
        struct pack_result packed;
        assert_int_equal(pack_load(paths[i / 2], NULL, &packed), PACK_OK);
        uint8_t *wanted = frame_case_picture(case_of(pairs[i & 1][0], 120, GLINT_RGB565), packed.scene, 0, NULL);
        uint8_t *got = frame_case_picture(case_of(pairs[i & 1][1], 120, GLINT_RGB565), packed.scene, 0, NULL);
        assert_memory_equal(wanted, got, 120 * 120 * 2);
        free(wanted);
        free(got);
        pack_free(&packed);
    }
}

static void bands_of_every_height_give_the_same_normals(void **state)
{
    struct pack_result packed;
    (void)state;
    assert_int_equal(pack_load("tests/golden/clip.json", NULL, &packed), PACK_OK);
    for (size_t m = 0; m < METHODS; m++) {
        struct frame_case f = case_of(methods[m], 48, GLINT_RGB888);
        uint8_t *wanted = frame_case_picture(f, packed.scene, 900, NULL);
        for (f.config.band_rows = 1; f.config.band_rows < 48; f.config.band_rows++) {
            uint8_t *got = frame_case_picture(f, packed.scene, 900, NULL);
            assert_memory_equal(got, wanted, 48 * 48 * 3);
            free(got);
        }
        free(wanted);
    }
    pack_free(&packed);
}

/* A triangle before the camera, with a highlight; `scatter`: how far its normals lean from the eye. */
static void set_triangle(struct scene_case *c, struct scene_vertex vertex[3], struct scene_triangle *triangle,
                         const int16_t position[3][3], double scatter)
{
    scene_case_default(c, 64, 64);
    for (int k = 0; k < 3; k++) {
        double lean[3];
        random_direction(lean, 3);
        memcpy(vertex[k].position, position[k], sizeof position[k]);
        scene_case_normal(vertex[k].normal, scatter * lean[0], scatter * lean[1], 1);
        triangle->corner[k] = (uint16_t)k;
    }
    triangle->material = 0;
    scene_case_bend(triangle, vertex);
    c->mesh[0] = (struct scene_case_mesh){c->mesh[0].head, vertex, triangle, 3, 1};
    c->material[0].ka = 4096;
    c->material[0].kd = 16384;
    c->material[0].ks = 8192;
    c->material[0].shininess = 8;
    c->light[0].vector[0] = (int32_t)(.6 * (1 << 30));
    c->light[0].vector[2] = (int32_t)(.8 * (1 << 30));
}

/* The largest difference to a neighbour, in a picture 64 wide. */
static int steepness(const uint8_t *p)
{
    int across = abs(p[1] - p[0]) > abs(p[0] - p[-1]) ? abs(p[1] - p[0]) : abs(p[0] - p[-1]);
    int down = abs(p[64] - p[0]) > abs(p[0] - p[-64]) ? abs(p[64] - p[0]) : abs(p[0] - p[-64]);
    return across > down ? across : down;
}

/* Pieces are the same polynomial, but for corners on a grid of 1/16 pixel and normals of Q14. A span
 * between the ends of a row is another one where a row ends elsewhere, so overveld-scan is left out; and so are methods
 * that interpolate on the screen where space is cut. */
static void what_is_left_of_a_clipped_triangle_looks_as_before(void **state)
{
    static const int16_t position[3][3] = {{-14000, -12000, 9000}, {14000, -10000, -6000}, {-1000, 14000, -9000}};
    static struct scene_case c;
    struct scene_vertex vertex[3];
    struct scene_triangle triangle = {.corner = {0}};
    long compared = 0, bent = 0;
    (void)state;
    random_seed(31);
    for (int i = 0; i < 120; i++) {
        const struct glint_method *method = methods[i % METHODS];
        int perspective = method == &glint_biquadratic_perspective || method == &glint_phong_perspective;
        if (method == &glint_overveld_scan)
            continue;
        set_triangle(&c, vertex, &triangle, position, 1);
        c.head.camera.kind = perspective ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC;
        c.object[0].position[2] = -CASE_UNIT;
        c.head.camera.near_plane = CASE_UNIT / 4;
        struct frame_case f = case_of(method, 64, GLINT_GREY8);
        struct scene_header *blob = scene_case_blob(&c);
        struct glint_stats stats;
        uint8_t *whole = frame_case_picture(f, blob, 0, &stats);
        assert_int_equal(stats.clipped, 0);
        blob->camera.near_plane = CASE_UNIT * 9 / 10;
        uint8_t *cut = frame_case_picture(f, blob, 0, &stats);
        assert_int_equal(stats.clipped, 1);
        f.config.method = perspective ? &glint_phong_perspective : &glint_phong;
        uint8_t *linear = frame_case_picture(f, blob, 0, NULL);
        for (int p = 65; p < 63 * 64 - 1; p++)
            if (cut[p] && whole[p]) {
                if (abs(cut[p] - whole[p]) > 2 + steepness(whole + p) / 6)
                    fail_msg("case %d: pixel (%d, %d) is %d, not %d", i, p % 64, p / 64, cut[p], whole[p]);
                compared++;
                bent += abs(cut[p] - linear[p]) > 8;
            }
        free(whole);
        free(cut);
        free(linear);
        free(blob);
    }
    print_message("%ld pixels compared, %ld of them far from phong's\n", compared, bent);
    assert_true(compared > 40000 && bent > compared / 8);
}

/* Where normals are the face's, all are phong: also what a near light or eye is taken from, the place of each pixel. */
static void flat_triangles_under_a_near_light_look_as_by_phong(void **state)
{
    static const int16_t position[3][3] = {{-14000, -12000, 0}, {14000, -10000, 0}, {-1000, 14000, 0}};
    static struct scene_case c;
    struct scene_vertex vertex[3];
    struct scene_triangle triangle = {.corner = {0}};
    (void)state;
    random_seed(32);
    for (int i = 0; i < 60; i++) {
        const struct glint_method *method = methods[i % METHODS];
        long lit = 0;
        set_triangle(&c, vertex, &triangle, position, 0);
        c.head.camera.viewer = i & 1 ? VIEWER_LOCAL : VIEWER_INFINITE;
        c.head.camera.kind = i & 2 ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC;
        c.object[0].position[2] = -CASE_UNIT;
        c.light[0].kind = LIGHT_POINT;
        c.light[0].vector[0] = random_between(-CASE_UNIT / 4, CASE_UNIT / 4);
        c.light[0].vector[1] = random_between(-CASE_UNIT / 4, CASE_UNIT / 4);
        c.light[0].vector[2] = -CASE_UNIT * 3 / 4;
        struct frame_case f = case_of(method, 64, GLINT_GREY8);
        struct scene_header *blob = scene_case_blob(&c);
        uint8_t *got = frame_case_picture(f, blob, 0, NULL);
        f.config.method = &glint_phong;
        uint8_t *wanted = frame_case_picture(f, blob, 0, NULL);
        for (int p = 0; p < 64 * 64; p++) {
            assert_true(abs(got[p] - wanted[p]) <= 1);
            lit += got[p] > 100;
        }
        assert_true(lit > 50);
        free(wanted);
        free(got);
        free(blob);
    }
}

/* Normals of opposite corners vanish between them: such pixels have the ambient light or more, and no other value. */
static void opposite_normals_do_no_harm(void **state)
{
    static const int16_t position[3][3] = {{-14000, -12000, 0}, {14000, -12000, 100}, {-14000, 14000, 0}};
    static const q14_t normal[3][3] = {{0, 0, 16384}, {0, 0, -16384}, {16384, 0, 0}};
    static struct scene_case c;
    struct scene_vertex vertex[3];
    struct scene_triangle triangle = {.corner = {0}};
    (void)state;
    for (int i = 0; i < (int)METHODS * 3; i++) {
        set_triangle(&c, vertex, &triangle, position, 0);
        for (int k = 0; k < 3; k++)
            memcpy(vertex[k].normal, normal[(k + i) % 3], sizeof normal[k]);
        scene_case_bend(&triangle, vertex);
        c.object[0].position[2] = -CASE_UNIT;
        struct scene_header *blob = scene_case_blob(&c);
        struct glint_stats stats;
        uint8_t *got = frame_case_picture(case_of(methods[i / 3], 64, GLINT_GREY8), blob, 0, &stats);
        long drawn = 0, dark = 0, counted = 0;
        for (int id = 0; id < GLINT_METHODS; id++)
            counted += stats.pixels[id];
        for (int p = 0; p < 64 * 64; p++) {
            drawn += got[p] >= 31; /* an eighth: the ambient light */
            dark += got[p] == 0;
        }
        assert_int_equal(drawn + dark, 64 * 64);
        assert_int_equal(drawn, counted);
        assert_true(drawn > 500);
        free(got);
        free(blob);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(biquadratic_is_nearly_as_good_as_in_ideal_arithmetic),
        cmocka_unit_test(overveld_is_as_bad_as_in_ideal_arithmetic),
        cmocka_unit_test(phong_in_perspective_is_the_truth_rounded),
        cmocka_unit_test(triangles_without_a_zigzag_edge_are_drawn_as_by_phong),
        cmocka_unit_test(bands_of_every_height_give_the_same_normals),
        cmocka_unit_test(what_is_left_of_a_clipped_triangle_looks_as_before),
        cmocka_unit_test(flat_triangles_under_a_near_light_look_as_by_phong),
        cmocka_unit_test(opposite_normals_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

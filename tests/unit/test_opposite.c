/* SPDX-License-Identifier: MIT */
/* What opposite directions leave between them is nothing: pixels of ambient
 * light, or of any other, never of noise. */
#include "random.h"
#include "raster/normals.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "scene_case.h"

#define SIDE    97 /* odd: the middle of the picture is a pixel's */
#define MIDDLE  (SIDE / 2)
#define AMBIENT 64

static struct scene_case c;
static struct scene_vertex vertex[3];
static struct scene_triangle triangle = {.corner = {0, 1, 2}};

/* A triangle about the middle of the picture, a position unit a sub-pixel;
 * ambient light of 64, half of the rest diffuse. */
static void begin(void)
{
    static const int16_t corner[3][2] = {{-600, -500}, {600, -500}, {0, 1000}};
    scene_case_sub_pixels(&c, SIDE, SIDE);
    memset(vertex, 0, sizeof vertex);
    for (int k = 0; k < 3; k++) {
        memcpy(vertex[k].position, corner[k], sizeof corner[k]);
        scene_case_normal(vertex[k].normal, 0, 0, 1);
        c.head.ambient[k] = 32768 / 255 * AMBIENT + 64;
    }
    c.material[0].kd = 16384;
    c.mesh[0].vertices = vertex;
    c.mesh[0].triangles = &triangle;
    c.mesh[0].vertex_count = 3;
    c.mesh[0].triangle_count = 1;
}

static uint8_t *grey(const struct glint_method *method)
{
    struct frame_case f = frame_case_small(SIDE, SIDE, GLINT_GREY8);
    f.config.method = method;
    for (int k = 0; k < 3; k++)
        triangle.bend[k] = 0;
    scene_case_bend(&triangle, vertex);
    struct scene_header *blob = scene_case_blob(&c);
    uint8_t *picture = frame_case_picture(f, blob, 0, NULL);
    free(blob);
    return picture;
}

/* Barycentric coordinates of a pixel; 0 outside. */
static int weights(int x, int y, double w[3])
{
    const double px = 16 * (x - MIDDLE), py = 16 * (MIDDLE - y);
    w[2] = (py + 500) / 1500;
    w[1] = (px + 600 - 600 * w[2]) / 1200;
    w[0] = 1 - w[1] - w[2];
    return w[0] > 1e-9 && w[1] > 1e-9 && w[2] > 1e-9;
}

/* At 120 degrees from each other, in a plane with the light: in the middle
 * their mean is 0. */
static void three_normals_that_cancel_are_lit_as_their_formula_says(void **state)
{
    static const double turn[3] = {0, 2.09439510239, 4.18879020479};
    double middle[3];
    int drawn = 0;
    (void)state;
    begin();
    for (int k = 0; k < 3; k++)
        scene_case_normal(vertex[k].normal, cos(turn[k]), sin(turn[k]), 0);
    c.light[0].vector[0] = 1 << 30;
    c.light[0].vector[2] = 0;
    uint8_t *picture = grey(&glint_duff);
    assert_true(weights(MIDDLE, MIDDLE, middle));
    assert_true(fabs(middle[0] - middle[1]) < 1e-9 && fabs(middle[0] - middle[2]) < 1e-9);
    assert_in_range(picture[MIDDLE * SIDE + MIDDLE], AMBIENT - 1, AMBIENT + 8);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            double w[3], along = 0, across = 0;
            if (!weights(x, y, w))
                continue;
            for (int k = 0; k < 3; k++) {
                along += w[k] * cos(turn[k]);
                across += w[k] * sin(turn[k]);
            }
            const double length = hypot(along, across), wanted = AMBIENT + 127.5 * fmax(0, along / length);
            if (length > .02 && fabs(picture[y * SIDE + x] - wanted) > 3)
                fail_msg("(%d, %d): %d, not %.1f", x, y, picture[y * SIDE + x], wanted);
            drawn++;
        }
    assert_true(drawn > 3000);
    free(picture);
}

/* The eye in front of the triangle, the light as far behind it: half-way lies
 * in the triangle's plane, to one side or the other of the middle, by which
 * normals that lean are lit; there itself it is but the light's last bits. */
static void a_light_straight_behind_a_pixel_has_no_highlight(void **state)
{
    int lit = 0, dark = 0;
    (void)state;
    begin();
    for (int k = 0; k < 3; k++)
        scene_case_normal(vertex[k].normal, sin(.5), 0, cos(.5));
    c.light[0].vector[0] = CASE_UNIT / 8;
    c.head.camera.viewer = VIEWER_LOCAL;
    c.material[0].ks = 32768;
    c.light[0].kind = LIGHT_POINT;
    c.light[0].vector[2] = -16000 * CASE_UNIT;
    c.object[0].position[2] = -8000 * CASE_UNIT;
    c.mesh[0].head.radius = 6000 * CASE_UNIT;
    uint8_t *picture = grey(&glint_phong);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            double w[3];
            if (!weights(x, y, w) || abs(y - MIDDLE) > 2)
                continue;
            lit += picture[y * SIDE + x] > AMBIENT + 90;
            dark += picture[y * SIDE + x] <= AMBIENT + 1;
        }
    assert_true(lit > 40 && dark > 40);
    assert_in_range(picture[MIDDLE * SIDE + MIDDLE], AMBIENT - 1, AMBIENT + 1);
    free(picture);
}

/* N'.L' of L' = 0: the middle between opposite ends. The loop is called as for
 * the triangle drawn last. */
static void a_vector_of_no_length_has_no_light(void **state)
{
    static const int8_t flat[1][2] = {{0, 0}};
    static const struct scene_tangent tangent[3] = {{{16384, 0, 0}, 1}, {{16384, 0, 0}, 1}, {{16384, 0, 0}, 1}};
    static const int16_t uv[3][2] = {{0, 0}, {0, 0}, {0, 0}};
    (void)state;
    begin();
    c.bumps = flat;
    c.bump.steepness = 256;
    c.tangents = tangent;
    c.uvs = uv;
    struct frame_case f = frame_case_small(SIDE, SIDE, GLINT_GREY8);
    f.config.method = &glint_bump_normalised;
    struct scene_header *blob = scene_case_blob(&c);
    frame_case_open_for(&f, blob);
    frame_case_draw(&f, blob, 0);
    assert_in_range(f.picture[MIDDLE * SIDE + MIDDLE], AMBIENT + 126, AMBIENT + 129);
    struct raster *r = f.frame.raster;
    for (int empty = 0; empty < 2; empty++) {
        for (unsigned k = 0; empty && k < SHADE_BUMP_CHANNELS; k++)
            r->setup.bump[k] = (struct channel){.exact = 0};
        glint_bump_normalised.run(r, MIDDLE - 8, MIDDLE, RUN);
        for (int i = 0; i < RUN; i++)
            assert_in_range(r->sum[i][0] >> 15, empty ? AMBIENT - 1 : AMBIENT + 126, empty ? AMBIENT : AMBIENT + 129);
    }
    frame_case_close(&f);
    free(blob);
    c.bumps = NULL;
    c.tangents = NULL;
    c.uvs = NULL;
}

/* So far that all of the mesh is one place for it. */
static void a_light_beyond_all_places_shines_as_a_direction(void **state)
{
    (void)state;
    struct frame_case f = frame_case_small(64, 64, GLINT_GREY8);
    uint8_t *picture[2];
    for (int far = 0; far < 2; far++) {
        static const int16_t corner[3][3] = {{-9000, -9000, 0}, {9000, -9000, 0}, {0, 9000, 0}};
        scene_case_default(&c, 64, 64);
        for (int k = 0; k < 3; k++) {
            memcpy(vertex[k].position, corner[k], sizeof corner[k]);
            scene_case_normal(vertex[k].normal, .3 * (k - 1), .2 * k, 1);
        }
        triangle = (struct scene_triangle){.corner = {0, 1, 2}};
        scene_case_bend(&triangle, vertex);
        c.head.ambient[0] = c.head.ambient[1] = c.head.ambient[2] = 0;
        c.material[0].kd = c.material[0].ks = 16384;
        c.material[0].shininess = 20;
        c.object[0].position[2] = -2 * CASE_UNIT;
        c.mesh[0] = (struct scene_case_mesh){c.mesh[0].head, vertex, &triangle, 3, 1};
        if (far) {
            c.light[0].kind = LIGHT_POINT;
            c.light[0].vector[2] = 12000 * CASE_UNIT;
        }
        struct scene_header *blob = scene_case_blob(&c);
        picture[far] = frame_case_picture(f, blob, 0, NULL);
        free(blob);
    }
    assert_in_range(picture[0][32 * 64 + 32], 50, 250);
    assert_memory_equal(picture[0], picture[1], 64 * 64);
    free(picture[0]);
    free(picture[1]);
}

/* A raster of one channel under one far light along an axis, and nothing else. */
static struct raster raster;
static struct object_state object;

static void lit_along(int axis, int sign)
{
    memset(&raster, 0, sizeof raster);
    memset(&object, 0, sizeof object);
    object.light[0].source.at[axis] = sign * (1 << 28);
    object.light[0].source.shift = 14;
    raster.input.object = &object;
    raster.gloss = raster.sum[0];
    raster.surface.channels = raster.surface.lights = 1;
    raster.surface.base[0] = AMBIENT << 15;
    raster.surface.light[0].diffuse[0] = 128 << 8;
}

/* Whatever lay there before: each component alone, a unit below the shortest and one above. */
static void a_normal_below_the_shortest_is_none(void **state)
{
    (void)state;
    for (int axis = 0; axis < 3; axis++)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int size = 4095; size <= 4097; size += 2) {
                lit_along(axis, sign);
                raster.value[axis][0] = sign * size;
                raster.divisor[0].half = 1 << 30;
                normals_shade(&raster, 0, 0, 1);
                const double steps = raster.sum[0][0] / 32768.;
                assert_true(fabs(steps - (size < 4096 ? AMBIENT : AMBIENT + 128)) < .02);
            }
}

/* Of what is left between all but opposite normals, 2^-6 and less of their length, the direction is as good as ever. */
static void a_short_normal_is_as_exact_as_a_long_one(void **state)
{
    double most = 0;
    (void)state;
    random_seed(3);
    for (int i = 0; i < 20000; i++) {
        const double length = random_real(0x1p-10, 0x1p-6 - 0x1p-12);
        const int axis = i % 3;
        double v[3], squared = 0;
        lit_along(axis, 1);
        random_direction(v, 3);
        for (int k = 0; k < 3; k++) {
            const int32_t q30 = (int32_t)lrint(v[k] * length * 0x1p30);
            raster.setup.channel[k].p.f = (uint32_t)q30;
            v[k] = q30;
            squared += v[k] * v[k];
        }
        normals_run(&raster, 0, 0, 1);
        const double wanted = fmax(0, v[axis] / sqrt(squared));
        most = fmax(most, fabs((raster.sum[0][0] / 32768. - AMBIENT) / 128 - wanted));
    }
    print_message("N.L within %.3g of 2^-13\n", most * 8192);
    assert_true(most < 0x1p-13);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(three_normals_that_cancel_are_lit_as_their_formula_says),
        cmocka_unit_test(a_light_straight_behind_a_pixel_has_no_highlight),
        cmocka_unit_test(a_vector_of_no_length_has_no_light),
        cmocka_unit_test(a_light_beyond_all_places_shines_as_a_direction),
        cmocka_unit_test(a_normal_below_the_shortest_is_none),
        cmocka_unit_test(a_short_normal_is_as_exact_as_a_long_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Edges on which normals may be quadratic: where a mesh has an inflection, and not where an edge alone looks like one.
 */
#include "pack/inflection.h"

#include "glint.h"
#include "pack/pack.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "scene_case.h"

/* A strip of quads over x = 0 .. columns, z = height(x, y): normals from its slopes. */
#define COLUMNS 4
#define ROWS    2

static struct scene_vertex vertices[(COLUMNS + 1) * (ROWS + 1)];
static struct scene_triangle triangles[2 * COLUMNS * ROWS];

static void make_net(double (*slope_x)(double, double), double (*slope_y)(double, double),
                     double (*height)(double, double))
{
    memset(triangles, 0, sizeof triangles);
    for (int i = 0; i <= COLUMNS; i++)
        for (int j = 0; j <= ROWS; j++) {
            struct scene_vertex *v = &vertices[i * (ROWS + 1) + j];
            v->position[0] = (int16_t)(4000 * i);
            v->position[1] = (int16_t)(4000 * j);
            v->position[2] = (int16_t)lrint(4000 * height(i, j));
            scene_case_normal(v->normal, -slope_x(i, j), -slope_y(i, j), 1);
        }
    for (int i = 0; i < COLUMNS; i++)
        for (int j = 0; j < ROWS; j++) {
            const int a = i * (ROWS + 1) + j, b = a + ROWS + 1, corner[2][3] = {{a, b, b + 1}, {a, b + 1, a + 1}};
            for (int t = 0; t < 2; t++)
                for (int k = 0; k < 3; k++)
                    triangles[2 * (i * ROWS + j) + t].corner[k] = (uint16_t)corner[t][k];
        }
    inflection_mark(vertices, (COLUMNS + 1) * (ROWS + 1), triangles, 2 * COLUMNS * ROWS);
}

static double none(double x, double y)
{
    return 0 * (x + y);
}

/* Steps whose edges are all flanks: normals lean the same way at all of them. */
static double stairs(double x, double y)
{
    return .5 * x + 0 * y;
}

static double leaning(double x, double y)
{
    return .2 + 0 * (x + y);
}

/* Straight along x and bowed along y: neither has an inflection, but the cubic along a diagonal has one. */
static double fan(double x, double y)
{
    return .3 * (x + .6) * (y - 1) * (y - 1);
}

static double fan_x(double x, double y)
{
    return .3 * (y - 1) * (y - 1) + 0 * x;
}

static double fan_y(double x, double y)
{
    return .6 * (x + .6) * (y - 1);
}

static void a_flank_has_an_inflection_on_every_edge_across(void **state)
{
    (void)state;
    make_net(leaning, none, stairs);
    for (int t = 0; t < 2 * COLUMNS * ROWS; t++)
        for (int e = 0; e < 3; e++) {
            const struct scene_vertex *a = &vertices[triangles[t].corner[e]],
                                      *b = &vertices[triangles[t].corner[(e + 1) % 3]];
            assert_int_equal(triangles[t].flags >> e & 1, a->position[0] != b->position[0]);
        }
}

static void a_fan_has_none_though_a_diagonal_looks_like_it(void **state)
{
    (void)state;
    make_net(fan_x, fan_y, fan);
    for (int t = 0; t < 2 * COLUMNS * ROWS; t++)
        assert_int_equal(triangles[t].flags, 0);
}

/* Vertices of the same place and normal are one, though texture coordinates have parted them. */
static void a_seam_of_texture_coordinates_is_none(void **state)
{
    struct scene_vertex parted[6 * COLUMNS * ROWS];
    struct scene_triangle same[2 * COLUMNS * ROWS];
    (void)state;
    make_net(leaning, none, stairs);
    memcpy(same, triangles, sizeof same);
    for (int t = 0; t < 2 * COLUMNS * ROWS; t++)
        for (int k = 0; k < 3; k++) {
            parted[3 * t + k] = vertices[triangles[t].corner[k]];
            triangles[t].corner[k] = (uint16_t)(3 * t + k);
        }
    inflection_mark(parted, 6 * COLUMNS * ROWS, triangles, 2 * COLUMNS * ROWS);
    for (int t = 0; t < 2 * COLUMNS * ROWS; t++)
        assert_int_equal(triangles[t].flags, same[t].flags);
}

static uint8_t *picture_of(const struct scene_header *scene, const struct glint_method *method, unsigned flags)
{
    const struct scene_camera *camera = &scene->camera;
    struct frame_case f = frame_case_small(camera->reference_width, camera->reference_height, GLINT_GREY8);
    f.config.method = method;
    f.config.flags = (uint8_t)flags;
    return frame_case_picture(f, scene, 0, NULL);
}

/* The most by which biquadratic darkens a pixel of what phong draws. */
static int darkening(const char *path, unsigned flags)
{
    struct pack_result packed;
    int most = 0;
    assert_int_equal(pack_load(path, NULL, &packed), 0);
    const struct scene_header *scene = packed.scene;
    uint8_t *phong = picture_of(scene, &glint_phong, 0), *quadratic = picture_of(scene, &glint_biquadratic, flags);
    for (int i = 0; i < scene->camera.reference_width * scene->camera.reference_height; i++)
        most = phong[i] - quadratic[i] > most ? phong[i] - quadratic[i] : most;
    free(phong);
    free(quadratic);
    pack_free(&packed);
    return most;
}

static void the_teapots_dark_spots_are_gone(void **state)
{
    (void)state;
    const int every = darkening("tests/scenes/teapot896.json", GLINT_EVERY_ZIGZAG),
              agreed = darkening("tests/scenes/teapot896.json", 0);
    print_message("the teapot is darkened by up to %d of 255, by the test of an edge alone %d\n", agreed, every);
    assert_true(agreed <= 16 && every >= 90);
}

static void surfaces_that_have_inflections_keep_them(void **state)
{
    static const char *const scenes[] = {"tests/scenes/zigzag.json", "tests/scenes/serpentine.json"};
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct pack_result packed;
        assert_int_equal(pack_load(scenes[i], NULL, &packed), 0);
        const struct scene_header *scene = packed.scene;
        uint8_t *agreed = picture_of(scene, &glint_biquadratic, 0),
                *every = picture_of(scene, &glint_biquadratic, GLINT_EVERY_ZIGZAG);
        assert_memory_equal(agreed, every, scene->camera.reference_width * scene->camera.reference_height);
        assert_true(darkening(scenes[i], 0) > 40);
        free(agreed);
        free(every);
        pack_free(&packed);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flank_has_an_inflection_on_every_edge_across),
        cmocka_unit_test(a_fan_has_none_though_a_diagonal_looks_like_it),
        cmocka_unit_test(a_seam_of_texture_coordinates_is_none),
        cmocka_unit_test(the_teapots_dark_spots_are_gone),
        cmocka_unit_test(surfaces_that_have_inflections_keep_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Where numbers end on the way to the screen: depths at the planes, the guard band, exponents far apart. */
#include "geometry/clip.h"
#include "geometry/project.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "place_case.h"
#include "scene_case.h"

#include <stdlib.h>

/* An object of 2^7 times 2^14 units about the eye: a step of z is 2^-7. */
static void begin_large(struct transform *t, q16_t near_plane)
{
    struct view view;
    struct matrix to_eye;
    memset(&scene, 0, sizeof scene);
    memset(&mesh, 0, sizeof mesh);
    memset(&pose, 0, sizeof pose);
    width = height = scene.camera.reference_width = scene.camera.reference_height = 64;
    scene.camera.rotation[0] = pose.rotation.q[0] = 1 << 30;
    scene.camera.focal = 64 * PLACE_UNIT;
    scene.camera.near_plane = near_plane;
    scene.camera.far_plane = INT32_MAX;
    mesh.extent = (1 << 30) - 1;
    mesh.radius = (q16_t)(mesh.extent * 1.7320509 + 1);
    pose.scale = 128 * PLACE_UNIT;
    view_setup(&view, &scene, width, height);
    assert_true(transform_setup(t, &view, &mesh, &pose, &to_eye));
}

static void what_a_near_plane_is_rounded_by_is_no_nearer_than_the_nearest(void **state)
{
    struct transform t;
    struct screen_point at;
    (void)state;
    begin_large(&t, PLACE_UNIT * 14 / 1280); /* 1.4 steps: 1 */
    assert_int_equal(t.near_z, 1);
    assert_true(project_clipped(&t, &(struct eye_point){0, 0, 1}, &at));
    assert_in_range(at.depth, DEPTH_NEAR - 1, DEPTH_NEAR);
    assert_true(project_clipped(&t, &(struct eye_point){0, 0, 2}, &at)); /* 1.4 / 2 of the way from the far plane */
    assert_in_range(at.depth, DEPTH_FAR + 65519 * 6999 / 10000 - 50, DEPTH_FAR + 65519 * 7 / 10);
}

static void what_is_65536_near_planes_away_has_the_farthest_depth(void **state)
{
    struct transform t;
    struct screen_point at;
    (void)state;
    begin_large(&t, PLACE_UNIT / 128); /* a step */
    for (int power = 1; power < 22; power++) {
        assert_true(project_clipped(&t, &(struct eye_point){0, 0, 1 << power}, &at));
        const double depth = DEPTH_FAR + 65519 / exp2(power);
        assert_in_range(at.depth, ceil(depth - 2), floor(depth));
    }
}

/* By a step of x or y that is a sub-pixel. */
static void what_a_cut_is_rounded_out_by_is_put_where_the_guard_band_ends(void **state)
{
    const struct transform t = {.near_z = 1, .far_z = 100, .range = 99, .depth_scale = 1, .depth_shift = 47};
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2)
        for (int out = GUARD - 2; out <= INT16_MAX + 1; out++) {
            struct screen_point x, y;
            const int32_t put = sign * (out > GUARD + 1 ? GUARD + 1 : out), fits = out <= INT16_MAX;
            assert_int_equal(project_clipped(&t, &(struct eye_point){sign * out, 7, 50}, &x), fits);
            assert_int_equal(project_clipped(&t, &(struct eye_point){-7, sign * out, 50}, &y), fits);
            if (fits) {
                assert_int_equal(x.x, put);
                assert_int_equal(x.y, 7);
                assert_int_equal(y.x, -7);
                assert_int_equal(y.y, put);
            }
        }
}

/* The steps of x are up to 2^60 of what z has at the guard band. */
static void what_is_far_aside_of_a_long_lens_is_out_on_its_side(void **state)
{
    (void)state;
    for (int side = 0; side < 4; side++)
        for (int far = 20; far <= 30; far++) {
            struct transform t;
            struct clip_polygon polygon = {.count = 3}, other;
            static const int16_t corner[3][3] = {{-32768, -32768, 0}, {32767, 0, 1000}, {0, 32767, -1000}};
            struct view view;
            struct matrix to_eye;
            begin_large(&t, 256);
            width = height = 2048;
            scene.camera.reference_width = scene.camera.reference_height = 1;
            scene.camera.focal = (1 << 30) - 1;
            mesh.extent = pose.scale = PLACE_UNIT / 4;
            mesh.radius = PLACE_UNIT;
            pose.position[side & 1] = side & 2 ? 1 - (1 << far) : (1 << far) - 1;
            pose.position[2] = -PLACE_UNIT;
            view_setup(&view, &scene, width, height);
            assert_true(transform_setup(&t, &view, &mesh, &pose, &to_eye));
            for (int k = 0; k < 3; k++)
                polygon.corner[k].eye = transform_point(&t, corner[k]);
            clip_triangle(&t, &polygon, &other);
            assert_in_range(polygon.count, 0, 2);
        }
}

/* A zigzag in and out of the band at each of nine corners would become one of thirteen. */
static void a_polygon_that_is_bent_never_has_more_corners_than_there_is_room_for(void **state)
{
    const struct transform t = {.near_z = 1, .far_z = 100};
    struct {
        struct clip_polygon polygon, other;
        uint8_t beside[64];
    } at;
    (void)state;
    memset(&at, 0x5A, sizeof at);
    at.polygon.count = CLIP_MAX_CORNERS;
    for (int i = 0; i < CLIP_MAX_CORNERS; i++)
        at.polygon.corner[i] = (struct clip_corner){{i & 1 ? GUARD + 100 : GUARD - 100, 100 * i, 50}, {1 << 30, 0, 0}};
    clip_triangle(&t, &at.polygon, &at.other);
    assert_int_equal(at.polygon.count, CLIP_MAX_CORNERS);
    for (int i = 0; i < CLIP_MAX_CORNERS; i++) {
        assert_in_range(at.polygon.corner[i].eye.x, GUARD - 100, GUARD);
        assert_int_equal(at.polygon.corner[i].eye.z, 50);
    }
    for (size_t i = 0; i < sizeof at.beside; i++)
        assert_int_equal(at.beside[i], 0x5A);
}

/*
 * A wall of 2^21 units, under a lens of 2048 pixels: nearer than 8 steps of z, a step of x or y is so many sub-pixels
 * that a cut may be rounded out of the guard band as far as that reaches, or has no bits left. Nothing is drawn in a
 * wrong place then, the wall is dropped whole and counted; from 32 steps on it fills the picture.
 */
static void a_wall_before_the_eye_fills_the_picture_or_is_dropped_whole(void **state)
{
    struct scene_case c;
    struct scene_vertex vertex[3] = {{{-30000, -30000, 0}, {0}}, {{30000, -30000, 0}, {0}}, {{0, 30000, 0}, {0}}};
    struct scene_triangle triangle = {.corner = {0, 1, 2}};
    (void)state;
    scene_case_default(&c, 64, 64);
    c.head.camera.near_plane = CASE_UNIT / 128;
    c.head.camera.far_plane = INT32_MAX;
    c.head.camera.focal = 2048 * CASE_UNIT;
    c.object[0].scale = 128 * CASE_UNIT;
    c.mesh[0] = (struct scene_case_mesh){{.extent = (1 << 30) - 1, .radius = 1859775391}, vertex, &triangle, 3, 1};
    for (int k = 0; k < 3; k++)
        scene_case_normal(vertex[k].normal, 0, 0, 1);
    scene_case_bend(&triangle, vertex);
    c.material[0].flags = MATERIAL_TWO_SIDED;
    for (int steps = 1; steps <= 64; steps = steps == 7 ? 32 : steps + 1) {
        struct frame_case f = frame_case_small(64, 64, GLINT_GREY8);
        c.object[0].position[2] = -CASE_UNIT / 128 * steps;
        struct scene_header *blob = scene_case_blob(&c);
        f.config.max_triangles = f.config.max_clipped = 16;
        f.config.max_vertices = 3;
        f.config.max_objects = f.config.max_lights = 1;
        frame_case_open(&f);
        frame_case_draw(&f, blob, 0);
        size_t drawn = 0;
        for (size_t p = 0; p < f.picture_bytes; p++)
            drawn += f.picture[p] != 0;
        assert_int_equal(drawn, steps < 8 ? 0 : f.picture_bytes);
        assert_int_equal(f.frame.stats.dropped, steps < 8);
        assert_int_equal(f.frame.stats.clipped, steps >= 8);
        frame_case_close(&f);
        free(blob);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_a_near_plane_is_rounded_by_is_no_nearer_than_the_nearest),
        cmocka_unit_test(what_is_65536_near_planes_away_has_the_farthest_depth),
        cmocka_unit_test(what_a_cut_is_rounded_out_by_is_put_where_the_guard_band_ends),
        cmocka_unit_test(what_is_far_aside_of_a_long_lens_is_out_on_its_side),
        cmocka_unit_test(a_wall_before_the_eye_fills_the_picture_or_is_dropped_whole),
        cmocka_unit_test(a_polygon_that_is_bent_never_has_more_corners_than_there_is_room_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

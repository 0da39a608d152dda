/* SPDX-License-Identifier: MIT */
/* Rows and pixels at the ends of what numbers hold: slivers from a table, and
 * normals quadratic along rows. */
#include "raster/raster.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "scene_case.h"

static struct scene_case c;
static struct scene_vertex vertex[6];
static struct scene_triangle triangle[2];

/* Triangles of corners in sub-pixels, y down, clockwise; `lean`: of the normals
 * to the right. */
static void begin(unsigned width, unsigned height, const int corner[][2], const double lean[], unsigned count)
{
    scene_case_sub_pixels(&c, (uint16_t)width, (uint16_t)height);
    for (unsigned i = 0; i < 3 * count; i++) {
        struct scene_vertex *v = &vertex[i];
        *v = (struct scene_vertex){{(int16_t)corner[i][0], (int16_t)-corner[i][1], i < 3 && count > 1 ? 8 : 0}, {0}};
        scene_case_normal(v->normal, sin(lean[i]), 0, cos(lean[i]));
    }
    for (unsigned t = 0; t < count; t++) {
        triangle[t] =
            (struct scene_triangle){.corner = {(uint16_t)(3 * t), (uint16_t)(3 * t + 2), (uint16_t)(3 * t + 1)}};
        scene_case_bend(&triangle[t], vertex);
    }
    for (int k = 0; k < 3; k++)
        c.head.ambient[k] = 0;
    c.material[0].kd = 32768;
    c.mesh[0].vertices = vertex;
    c.mesh[0].triangles = triangle;
    c.mesh[0].vertex_count = 3 * count;
    c.mesh[0].triangle_count = count;
}

/* The nearer one comes first and leaves of the sliver's runs but a part. */
static void a_sliver_behind_another_shows_where_that_is_not(void **state)
{
    enum { WIDTH = 600, HEIGHT = 32 };
    static const int corner[6][2] = {{-100, -200}, {400, -200}, {-100, 300}, {-4000, 7}, {4000, 7}, {4000, 9}};
    static const double lean[6] = {1, 1, 1, 0, .1, .2};
    uint16_t *picture[3];
    int both = 0, behind = 0;
    (void)state;
    begin(WIDTH, HEIGHT, corner, lean, 2);
    for (int which = 0; which < 3; which++) {
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_RGB565);
        f.config.tables = 1;
        c.mesh[0].triangles = triangle + (which == 1);
        c.mesh[0].triangle_count = which < 2 ? 1 : 2;
        struct scene_header *blob = scene_case_blob(&c);
        picture[which] = (uint16_t *)(void *)frame_case_picture(f, blob, 0, NULL);
        free(blob);
    }
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        assert_int_equal(picture[2][i], picture[0][i] ? picture[0][i] : picture[1][i]);
        both += picture[0][i] && picture[1][i];
        behind += !picture[0][i] && picture[1][i];
    }
    assert_true(both > 3 && behind > 10);
    for (int which = 0; which < 3; which++)
        free(picture[which]);
}

/*
 * In row 980 the right edge crosses 2^14 sub-pixels from the left one and
 * 1/29263 more, at the centre of pixel 1024: that belongs to the triangle, but
 * the crossing is found 2^-8 to its left.
 */
static void the_last_pixel_of_the_longest_row_has_the_right_edges_normal(void **state)
{
    enum { SIZE = 2048, LEFT = -16376, TOP = -16379, ROW = 980, LAST = 1024 };
    static const int corner[3][2] = {{LEFT, TOP}, {LEFT + 30571, TOP + 29263}, {LEFT, TOP + 29263}};
    static const double lean[3] = {0, .9, 0};
    (void)state;
    begin(SIZE, SIZE, corner, lean, 1);
    struct frame_case f = frame_case_small(SIZE, SIZE, GLINT_GREY8);
    struct scene_header *blob = scene_case_blob(&c);
    struct glint_band band;
    f.config.method = &glint_overveld_scan;
    f.config.band_rows = 1;
    frame_case_open_for(&f, blob);
    assert_int_equal(glint_frame_begin(&f.frame, blob, 0), 0);
    assert_int_equal(glint_frame_band(&f.frame, ROW, f.config.band[0], &band), 1);
    const uint8_t *grey = band.pixels;
    assert_in_range(grey[0], 254, 255);
    assert_in_range(grey[LAST], 200, 245);
    assert_int_equal(grey[LAST], grey[LAST - 1]);
    assert_int_equal(grey[LAST + 1], 0);
    frame_case_guards(&f);
    frame_case_close(&f);
    free(blob);
}

/* A wall of eight position units of which a picture shows a hundredth: a row's
 * ends are one place in whole units. Its left edge is 500 pixels from the
 * middle, so that rows of the pieces between it and the guard band pass the
 * picture. */
static void a_row_whose_ends_are_one_place_does_not_bend(void **state)
{
    enum { SIZE = 64, UNIT = 64 }; /* UNIT: a position unit */
    static const int16_t corner[3][3] = {{0, -4, 0}, {8, 0, 0}, {0, 5, 0}};
    (void)state;
    scene_case_default(&c, SIZE, SIZE);
    for (int k = 0; k < 3; k++) {
        memcpy(vertex[k].position, corner[k], sizeof corner[k]);
        scene_case_normal(vertex[k].normal, 0, 0, 1);
        c.head.ambient[k] = 0;
    }
    triangle[0] = (struct scene_triangle){.corner = {0, 1, 2}};
    scene_case_bend(&triangle[0], vertex);
    c.material[0].kd = 32768;
    c.object[0].scale = 128 * CASE_UNIT;
    c.object[0].position[0] = -500 * CASE_UNIT / SIZE;
    c.object[0].position[1] = -UNIT / 2 * CASE_UNIT;
    c.object[0].position[2] = -CASE_UNIT;
    c.mesh[0] = (struct scene_case_mesh){{.extent = (1 << 30) - 1, .radius = 1859775391}, vertex, triangle, 3, 1};
    struct frame_case f = frame_case_small(SIZE, SIZE, GLINT_GREY8);
    struct scene_header *blob = scene_case_blob(&c);
    f.config.method = &glint_overveld_scan;
    f.config.max_triangles = f.config.max_clipped = 16;
    f.config.max_vertices = 3;
    f.config.max_objects = f.config.max_lights = 1;
    frame_case_open(&f);
    frame_case_draw(&f, blob, 0);
    for (size_t i = 0; i < f.picture_bytes; i++)
        assert_in_range(f.picture[i], 254, 255);
    frame_case_close(&f);
    free(blob);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sliver_behind_another_shows_where_that_is_not),
        cmocka_unit_test(the_last_pixel_of_the_longest_row_has_the_right_edges_normal),
        cmocka_unit_test(a_row_whose_ends_are_one_place_does_not_bend),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

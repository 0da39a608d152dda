/* SPDX-License-Identifier: MIT */
/* Fog and faces seen from behind in double precision. */
#include "reference/fog.h"
#include "reference/reference.h"

#include "glint.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene_case.h"

#define SIZE 16

static const struct scene_vertex square[4] = {{{-32767, -32767, 0}, {0, 0, 16384}},
                                              {{32767, -32767, 0}, {0, 0, 16384}},
                                              {{32767, 32767, 0}, {0, 0, 16384}},
                                              {{-32767, 32767, 0}, {0, 0, 16384}}};

/* A square across the view, 3 units away, half as bright as can be, on a black background. */
static void open_square(struct scene_case *c, struct scene_triangle triangles[2])
{
    scene_case_default(c, SIZE, SIZE);
    memset(triangles, 0, 2 * sizeof *triangles);
    for (int t = 0; t < 2; t++)
        for (int k = 0; k < 3; k++)
            triangles[t].corner[k] = (uint16_t)(k ? k + t : 0);
    c->mesh[0].vertices = square;
    c->mesh[0].triangles = triangles;
    c->mesh[0].vertex_count = 4;
    c->mesh[0].triangle_count = 2;
    c->object[0].position[2] = -3 * CASE_UNIT;
    c->material[0].ka = 1 << 14;
    for (int k = 0; k < 3; k++)
        c->head.fog.colour[k] = (uint16_t)(8192 * (k + 1));
}

/* The colour in the middle of the picture and in its corner, where nothing is. */
static void draw(const struct scene_case *c, double middle[3], double corner[3])
{
    struct scene_header *scene = scene_case_blob(c);
    const struct reference_options options = {.width = SIZE, .height = SIZE};
    struct reference_image image;
    assert_true(reference_render(scene, &options, &image));
    memcpy(middle, image.value + (size_t)(SIZE / 2 * SIZE + SIZE / 2) * 3, 3 * sizeof *middle);
    memcpy(corner, image.value, 3 * sizeof *corner);
    reference_free(&image);
    free(scene);
}

static void check_mixed(const struct scene_case *c, double part)
{
    double middle[3], corner[3];
    draw(c, middle, corner);
    for (int k = 0; k < 3; k++) {
        assert_true(fabs(middle[k] - (.5 + part * (.25 * (k + 1) - .5))) < 1e-9);
        assert_true(corner[k] == 0);
    }
}

static void fog_mixes_what_is_seen_by_its_distance(void **state)
{
    struct scene_case c;
    struct scene_triangle triangles[2];
    (void)state;
    for (int kind = CAMERA_PERSPECTIVE; kind <= CAMERA_ORTHOGRAPHIC; kind++) {
        open_square(&c, triangles);
        c.head.camera.kind = (uint16_t)kind;
        c.head.camera.focal = (kind == CAMERA_PERSPECTIVE ? SIZE : SIZE / 4) * CASE_UNIT;
        check_mixed(&c, 0);
        c.head.fog.kind = FOG_LINEAR;
        c.head.fog.from = 2 * CASE_UNIT;
        c.head.fog.to = 6 * CASE_UNIT;
        check_mixed(&c, .25);
        c.head.fog.to = 5 * CASE_UNIT / 2;
        check_mixed(&c, 1);
        c.head.fog.from = 3 * CASE_UNIT;
        c.head.fog.to = 4 * CASE_UNIT;
        check_mixed(&c, 0);
        c.head.fog.from = c.head.fog.to = 0;
        c.head.fog.kind = FOG_EXPONENTIAL;
        c.head.fog.density = 1u << 22;
        check_mixed(&c, 1 - exp(-.75));
    }
}

static void fog_goes_by_the_depth_not_by_the_way_to_the_eye(void **state)
{
    const struct decode_fog fog = {FOG_LINEAR, {0, 0, 0}, 1, 3, 0};
    (void)state;
    assert_true(fog_amount(&fog, 2) == .5);
    assert_true(fog_amount(&fog, .5) == 0);
    assert_true(fog_amount(&fog, 7) == 1);
}

static void a_back_is_dark_or_lit_as_if_built_that_way(void **state)
{
    struct scene_case c;
    struct scene_triangle triangles[2];
    double middle[3], corner[3];
    (void)state;
    for (int behind = 0; behind < 2; behind++) {
        open_square(&c, triangles);
        c.material[0].ka = 0;
        c.material[0].kd = 1 << 15;
        c.material[0].flags = MATERIAL_TWO_SIDED;
        c.object[0].rotation[0] = behind ? 0 : 1 << 30;
        c.object[0].rotation[2] = behind ? 1 << 30 : 0; /* half a turn about y */
        draw(&c, middle, corner);
        assert_true(fabs(middle[0] - 1) < 1e-6);
        c.light[0].vector[2] = -(1 << 30); /* behind what is seen */
        draw(&c, middle, corner);
        assert_true(middle[0] == 0);
        c.light[0].vector[2] = 1 << 30;
        c.material[0].flags = 0;
        draw(&c, middle, corner);
        assert_true(behind ? middle[0] == 0 : middle[0] > .99);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fog_mixes_what_is_seen_by_its_distance),
        cmocka_unit_test(fog_goes_by_the_depth_not_by_the_way_to_the_eye),
        cmocka_unit_test(a_back_is_dark_or_lit_as_if_built_that_way),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Objects turned by the user: about their own origin, in the eye's axes, light and camera staying. */
#include "geometry/rotation.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "frame_case.h"
#include "pack_case.h"
#include "scene_case.h"

#define QUARTER 16384
#define SIDE    64

static const struct matrix unturned = {{{1 << 30, 0, 0}, {0, 1 << 30, 0}, {0, 0, 1 << 30}}};

static struct matrix turned(uint16_t yaw, uint16_t pitch)
{
    struct rotation r = rotation_turn(&unturned, yaw, pitch);
    return rotation_matrix(&r);
}

static void quarter_turns_are_exact(void **state)
{
    (void)state;
    static const int sine[4] = {0, 1, 0, -1}, cosine[4] = {1, 0, -1, 0};
    for (unsigned i = 0; i < 4; i++) {
        /* the front, +z, goes to +x; or to +y */
        const int32_t s = sine[i] * (1 << 30), c = cosine[i] * (1 << 30), one = 1 << 30;
        const struct matrix right = {{{c, 0, s}, {0, one, 0}, {-s, 0, c}}}, up = {{{one, 0, 0}, {0, c, s}, {0, -s, c}}};
        struct matrix yaw = turned((uint16_t)(i * QUARTER), 0), pitch = turned(0, (uint16_t)(i * QUARTER));
        assert_memory_equal(&yaw, &right, sizeof right);
        assert_memory_equal(&pitch, &up, sizeof up);
    }
}

/* What an object's pose becomes for the eye is the pose, then the turn in the eye's axes. */
static void a_turn_is_in_the_eyes_axes(void **state)
{
    (void)state;
    random_seed(51);
    for (int i = 0; i < 100000; i++) {
        double q[4], length = 0, wanted[3][3], m[3][3];
        struct rotation camera;
        uint16_t yaw = (uint16_t)random_bits(), pitch = (uint16_t)random_bits();
        random_direction(q, 4);
        for (int k = 0; k < 4; k++) {
            camera.q[k] = (q30_t)lrint(q[k] * 0x1p30);
            length += (double)camera.q[k] * camera.q[k] * 0x1p-60;
        }
        struct matrix to_eye = rotation_matrix(&camera);
        struct rotation turn = rotation_turn(&to_eye, yaw, pitch), both = rotation_product(&camera, &turn);
        struct matrix got = rotation_matrix(&both);
        double a = yaw * 0x1p-15 * 3.14159265358979323846, b = pitch * 0x1p-15 * 3.14159265358979323846;
        for (int k = 0; k < 3; k++) {
            double x = to_eye.m[0][k] * 0x1p-30, y = to_eye.m[1][k] * 0x1p-30, z = to_eye.m[2][k] * 0x1p-30;
            m[0][k] = cos(a) * x + sin(a) * z;
            m[1][k] = y;
            m[2][k] = cos(a) * z - sin(a) * x;
            wanted[0][k] = m[0][k];
            wanted[1][k] = cos(b) * m[1][k] + sin(b) * m[2][k];
            wanted[2][k] = cos(b) * m[2][k] - sin(b) * m[1][k];
        }
        assert_true(fabs(length - 1) < 0x1p-28);
        for (int row = 0; row < 3; row++)
            for (int k = 0; k < 3; k++) /* three products of 2^-28 each, doubled in the matrix */
                assert_true(fabs(got.m[row][k] * 0x1p-30 - wanted[row][k]) < 0x1p-26);
    }
}

static uint8_t *picture(const void *scene, uint32_t yaw, uint32_t pitch, struct glint_stats *stats)
{
    struct frame_case f = frame_case_small(SIDE, SIDE, GLINT_GREY8);
    frame_case_open_for(&f, scene);
    glint_turn(&f.frame, (uint16_t)yaw, (uint16_t)pitch);
    frame_case_draw(&f, scene, 0);
    if (stats)
        *stats = f.frame.stats;
    uint8_t *drawn = f.picture;
    f.picture = NULL;
    frame_case_close(&f);
    return drawn;
}

static void assert_same(uint8_t *a, uint8_t *b, int same)
{
    assert_int_equal(memcmp(a, b, (size_t)SIDE * SIDE) == 0, same);
    free(a);
    free(b);
}

static void four_quarter_turns_are_none(void **state)
{
    (void)state;
    struct pack_result scene;
    assert_int_equal(pack_load("tests/scenes/demo.json", NULL, &scene), 0);
    assert_same(picture(scene.scene, 4 * QUARTER, 0, NULL), picture(scene.scene, 0, 0, NULL), 1);
    assert_same(picture(scene.scene, 0, 4 * QUARTER, NULL), picture(scene.scene, 0, 0, NULL), 1);
    for (uint32_t i = 1; i < 4; i++) {
        assert_same(picture(scene.scene, i * QUARTER, 0, NULL), picture(scene.scene, 0, 0, NULL), 0);
        assert_same(picture(scene.scene, i * QUARTER, 0, NULL), picture(scene.scene, (i + 4) * QUARTER, 0, NULL), 1);
    }
    pack_free(&scene);
}

static void a_turned_object_is_one_that_stands_so(void **state)
{
    (void)state;
    /* 90 degrees about an axis have the same rounded quaternion in a file. */
    static const char *const turns[] = {"", "{\"rotate\": [\"y\", 90]}, "};
    struct pack_result scene[2];
    char text[1024];
    for (int i = 0; i < 2; i++) {
        snprintf(text, sizeof text,
                 "\"lights\": [{\"type\": \"point\", \"position\": [2, 3, 4]}], \"meshes\": {\"a\": {\"shape\": "
                 "\"torus\", \"axis\": \"z\", \"rings\": 7, \"sides\": 5}}, \"objects\": [{\"mesh\": \"a\", "
                 "\"transform\": [{\"scale\": 0.7}, %s{\"move\": [1, 0, 0]}]}]",
                 turns[i]);
        scene[i] = case_scene(text);
    }
    assert_same(picture(scene[0].scene, QUARTER, 0, NULL), picture(scene[1].scene, 0, 0, NULL), 1);
    assert_same(picture(scene[0].scene, 0, 0, NULL), picture(scene[1].scene, 0, 0, NULL), 0);
    pack_free(&scene[0]);
    pack_free(&scene[1]);
}

/* A square that faces the eye and the light, right of the picture's centre. */
static struct scene_header *facing(void)
{
    static const struct scene_vertex vertices[4] = {{{-8192, -8192, 0}, {0, 0, 16384}},
                                                    {{8192, -8192, 0}, {0, 0, 16384}},
                                                    {{8192, 8192, 0}, {0, 0, 16384}},
                                                    {{-8192, 8192, 0}, {0, 0, 16384}}};
    static const struct scene_triangle triangles[2] = {{.corner = {0, 1, 2}}, {.corner = {0, 2, 3}}};
    static struct scene_case c;
    scene_case_default(&c, SIDE, SIDE);
    c.mesh[0].vertices = vertices;
    c.mesh[0].triangles = triangles;
    c.mesh[0].vertex_count = 4;
    c.mesh[0].triangle_count = 2;
    c.material[0].ka = 0;
    c.material[0].kd = 32768;
    c.object[0].position[0] = CASE_UNIT / 4;
    c.object[0].position[2] = -CASE_UNIT;
    return scene_case_blob(&c);
}

static void a_face_turned_from_the_light_darkens_by_the_cosine(void **state)
{
    (void)state;
    struct scene_header *scene = facing();
    for (uint32_t i = 0; i < 7; i++) { /* the eye sees it 14 degrees from the side */
        uint32_t angle = i * QUARTER / 8;
        int wanted = (int)lrint(255 * cos(angle * 0x1p-15 * 3.14159265358979323846));
        const uint32_t turns[4][2] = {{angle, 0}, {65536 - angle, 0}, {0, angle}, {0, 65536 - angle}};
        for (int t = 0; t < 4; t++) {
            struct glint_stats stats;
            uint8_t *drawn = picture(scene, turns[t][0], turns[t][1], &stats);
            /* its own origin stays where it is: a quarter of the picture right of the middle */
            assert_true(abs(drawn[SIDE / 2 * SIDE + SIDE * 3 / 4] - wanted) <= 1);
            assert_int_equal(frame_case_drawn(&(struct frame_case){.frame.stats = stats}), 2);
            free(drawn);
        }
    }
    free(scene);
}

static void a_face_turned_away_is_culled(void **state)
{
    (void)state;
    struct scene_header *scene = facing();
    for (int pitch = 0; pitch < 2; pitch++)
        for (uint32_t i = 0; i < 16; i++) {
            /* between the quarter turns, where the eye is surely before or behind it */
            uint32_t angle = (2 * i + 1) * QUARTER / 8;
            struct glint_stats stats;
            free(picture(scene, pitch ? 0 : angle, pitch ? angle : 0, &stats));
            int before = angle < QUARTER / 4 * 3 || angle > QUARTER / 4 * 13;
            int behind = angle > QUARTER / 4 * 5 && angle < QUARTER / 4 * 11;
            if (before || behind)
                assert_int_equal(stats.culled, behind ? 2 : 0);
        }
    free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quarter_turns_are_exact),
        cmocka_unit_test(a_turn_is_in_the_eyes_axes),
        cmocka_unit_test(four_quarter_turns_are_none),
        cmocka_unit_test(a_turned_object_is_one_that_stands_so),
        cmocka_unit_test(a_face_turned_from_the_light_darkens_by_the_cosine),
        cmocka_unit_test(a_face_turned_away_is_culled),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

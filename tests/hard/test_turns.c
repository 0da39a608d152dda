/* SPDX-License-Identifier: MIT */
/*
 * What a million steps of rotation do. The renderer adds none up: a pose is made from the time, and a user's turn from
 * two angles, anew for each picture. So what rotation_product() loses in a chain of a million is what an application
 * would that kept a quaternion.
 */
#include "geometry/rotation.h"
#include "geometry/transform.h"
#include "glint.h"
#include "pack/pack.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "tests/unit/frame_case.h"
#include "tests/unit/random.h"

#define STEPS 1000000

static void multiply(const double p[4], const double q[4], double r[4])
{
    const double w = p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
                 x = p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
                 y = p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
                 z = p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0];
    r[0] = w, r[1] = x, r[2] = y, r[3] = z;
}

static double length(const double q[4])
{
    return sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

/* The element of the two unit quaternions' matrices that differs most is at most twice this. */
static double apart(const double p[4], const double q[4])
{
    double d[4];
    for (int i = 0; i < 4; i++)
        d[i] = p[i] / length(p) - q[i] / length(q);
    return length(d);
}

static void a_million_products_drift_by_less_than_2_12(void **state)
{
    double turned = 0, grown = 0;
    (void)state;
    random_seed(1);
    for (int chain = 0; chain < 6; chain++) {
        double v[4], truth[4] = {1, 0, 0, 0}, step[4];
        struct rotation by, at = {{1 << 30, 0, 0, 0}};
        random_direction(v, 3);
        const double half = chain ? random_magnitude(1e-6, 1) : 0x1p-31;
        by.q[0] = (q30_t)lrint(cos(half) * 0x1p30);
        for (int i = 0; i < 3; i++)
            by.q[i + 1] = (q30_t)lrint(sin(half) * v[i] * 0x1p30);
        for (int i = 0; i < 4; i++)
            step[i] = by.q[i] * 0x1p-30;
        const double own = length(step); /* a rounded step is not quite a unit: lengths multiply */
        for (int i = 0; i < 4; i++)
            step[i] /= own;
        for (int i = 0; i < STEPS; i++) {
            at = rotation_product(&at, &by);
            multiply(truth, step, truth);
        }
        double got[4];
        for (int i = 0; i < 4; i++)
            got[i] = at.q[i] * 0x1p-30;
        turned = fmax(turned, apart(got, truth));
        grown = fmax(grown, fabs(length(got) / pow(own, STEPS) - 1));
    }
    print_message("a million products: turned by 2^%.1f, longer or shorter by 2^%.1f\n", log2(turned), log2(grown));
    assert_true(turned < 0x1p-12 && grown < 0x1p-12);
}

/* A matrix of every millionth of a turn, at each of which the object's own pose is made anew. */
static void a_million_poses_have_upright_matrices(void **state)
{
    const struct scene_object object = {
        .rotation = {1 << 30, 0, 0, 0},
        .scale = 65536,
        .motion = {.kind = MOTION_SPIN, .axis = {619925131, 619925131, 619925131}, .rate = 65536 * 100 / 3}};
    const struct scene_header scene = {.magic = SCENE_MAGIC};
    double worst = 0;
    (void)state;
    for (uint32_t i = 0; i < STEPS; i++) {
        const struct pose pose = pose_at(&scene, &object, i * 4294);
        const struct matrix m = rotation_matrix(&pose.rotation);
        for (int a = 0; a < 3; a++)
            for (int b = a; b < 3; b++) {
                double dot = 0;
                for (int k = 0; k < 3; k++)
                    dot += (double)m.m[a][k] * m.m[b][k] * 0x1p-60;
                worst = fmax(worst, fabs(dot - (a == b)));
            }
    }
    print_message("rows of a million matrices: off by at most 2^%.1f\n", log2(worst));
    assert_true(worst < 0x1p-26);
}

/* Round and round by the smallest angle, and back where it began: the same bits. */
static void a_million_turns_end_where_they_began(void **state)
{
    struct pack_result scene;
    (void)state;
    assert_int_equal(pack_load("tests/scenes/tiny.json", NULL, &scene), 0);
    struct frame_case f = frame_case_small(32, 24, GLINT_RGB888);
    frame_case_open_for(&f, scene.scene);
    frame_case_draw(&f, scene.scene, 0);
    uint8_t first[32 * 24 * 3], aside[32 * 24 * 3];
    memcpy(first, f.picture, sizeof first);
    uint16_t yaw = 0, pitch = 0;
    for (int i = 0; i < 16 * 65536; i++) { /* more than a million */
        glint_turn(&f.frame, yaw, pitch);
        yaw++;
        pitch = (uint16_t)(pitch - 3);
        if (i == 30000) {
            frame_case_draw(&f, scene.scene, 0);
            memcpy(aside, f.picture, sizeof aside);
        }
    }
    glint_turn(&f.frame, yaw, pitch);
    frame_case_draw(&f, scene.scene, 0);
    assert_memory_equal(f.picture, first, sizeof first);
    assert_true(memcmp(aside, first, sizeof first) != 0);
    frame_case_close(&f);
    pack_free(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_million_products_drift_by_less_than_2_12),
        cmocka_unit_test(a_million_poses_have_upright_matrices),
        cmocka_unit_test(a_million_turns_end_where_they_began),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

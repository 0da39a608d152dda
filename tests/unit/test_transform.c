/* SPDX-License-Identifier: MIT */
/* From positions to the screen, against double precision. */
#include "geometry/project.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "place_case.h"

#include <stdlib.h>

/* The sphere's largest distance ahead, and its reach to the sides, in sub-pixels at the distance of `at`. */
static void reach_of(const struct place *at, double *ahead, double *side)
{
    static const int16_t middle[3] = {0, 0, 0};
    struct place centre = truth(middle);
    double radius = mesh.radius / 65536. * pose.scale / 65536, f = 16 * real_focal();
    *ahead = fabs(centre.z) + radius;
    *side = f * (fmax(fabs(centre.x), fabs(centre.y)) + radius);
    if (scene.camera.kind == CAMERA_PERSPECTIVE)
        *side /= at->z;
}

static double worst, worst_share;
static long tested;

/*
 * How far before rounding the position may be off. The rows have 29 bits of the sphere's reach, of which a few units
 * are lost; the object's offset has 24 bits of a unit, its centre's part before it is scaled; and a distance that is
 * off by a share moves what is aside by it.
 */
static double allowed(const struct place *at)
{
    double ahead, side, grain = 0x1p-22 * 16 * real_focal() * fmax(1, pose.scale / 65536.),
                        aside = fmax(fabs(at->x), fabs(at->y));
    reach_of(at, &ahead, &side);
    if (scene.camera.kind == CAMERA_ORTHOGRAPHIC)
        return 0x1p-27 * side + grain + 0x1p-28 * GUARD;
    double off = fmax(fabs(at->sx), fabs(at->sy)) * ahead / at->z;
    return 0x1p-27 * (side + off) + grain / at->z * (1 + aside / at->z) + 0x1p-28 * GUARD;
}

static void check_vertex(const struct transform *t, const int16_t p[3])
{
    struct place at = truth(p);
    struct screen_point got;
    double near_z = scene.camera.near_plane / 65536., far_z = scene.camera.far_plane / 65536.;
    double ahead, side, slack, bound;
    int placed = project(t, transform_point(t, p), &got);
    reach_of(&at, &ahead, &side);
    slack = ahead * 0x1p-26 + 0x1p-16;
    int in_depth = at.z < near_z - slack || at.z > far_z + slack   ? 0
                   : at.z > near_z + slack && at.z < far_z - slack ? 1
                                                                   : -1;
    bound = allowed(&at);
    double out = fmax(fabs(at.sx), fabs(at.sy)) - GUARD;
    int expected = in_depth == 0 || (at.z > 0 && out > .5 + bound) ? 0 : in_depth == 1 && out < -.5 - bound ? 1 : -1;
    if (expected >= 0 && placed != expected)
        fail_msg("(%g, %g, %g) of near %g and far %g at (%g, %g)/16 px: %s", at.x, at.y, at.z, near_z, far_z, at.sx,
                 at.sy, placed ? "placed" : "not placed");
    if (!placed)
        return;
    double error = fmax(fabs(got.x - at.sx), fabs(got.y - at.sy)) - .5;
    tested++;
    worst_share = fmax(worst_share, error / bound);
    if (fabs(at.sx) <= 8192 && fabs(at.sy) <= 8192 && bound < 0x1p-8)
        worst = fmax(worst, error);
    if (error > bound)
        fail_msg("(%g, %g, %g) at (%.4f, %.4f)/16 px is put at (%d, %d): off by %g beyond rounding, not %g", at.x, at.y,
                 at.z, at.sx, at.sy, got.x, got.y, error, bound);
    double grain = 2 + 65519 * slack / (scene.camera.kind == CAMERA_PERSPECTIVE ? at.z : far_z - near_z);
    if (fabs(got.depth - at.depth) > grain)
        fail_msg("%g between %g and %g ahead: depth %d, not %.2f to %.2f", at.z, near_z, far_z, got.depth, at.depth,
                 grain);
}

static int setup(struct transform *t, struct matrix *to_eye)
{
    struct view view;
    view_setup(&view, &scene, width, height);
    return transform_setup(t, &view, &mesh, &pose, to_eye);
}

static void check_cases(enum scene_camera_kind kind, uint32_t seed)
{
    random_seed(seed);
    tested = 0;
    worst = worst_share = 0;
    for (int i = 0; i < 50000; i++) {
        struct transform t;
        struct matrix to_eye;
        random_case(kind);
        if (!setup(&t, &to_eye))
            continue;
        for (int j = 0; j < 8; j++) {
            int16_t p[3];
            random_position(p);
            check_vertex(&t, p);
        }
    }
    print_message("%ld vertices: at most 2^%.2f sub-pixel beyond rounding, %.2f of what is allowed\n", tested,
                  log2(worst), worst_share);
    assert_true(tested > 100000);
    assert_true(worst < 0x1p-8);
}

static void a_vertex_in_perspective_is_placed_to_the_nearest_sub_pixel(void **state)
{
    (void)state;
    check_cases(CAMERA_PERSPECTIVE, 51);
}

static void an_orthographic_vertex_is_placed_to_the_nearest_sub_pixel(void **state)
{
    (void)state;
    check_cases(CAMERA_ORTHOGRAPHIC, 52);
}

static void an_object_is_left_out_only_if_no_part_of_it_is_between_the_planes(void **state)
{
    (void)state;
    int out = 0, in = 0;
    random_seed(53);
    for (int i = 0; i < 100000; i++) {
        struct transform t;
        struct matrix to_eye;
        random_case(i & 1 ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC);
        if (i & 2) /* something behind it or far off */
            for (int k = 0; k < 3; k++)
                pose.position[k] = 2 * scene.camera.position[k] - pose.position[k];
        scene.camera.far_plane = scene.camera.near_plane + 1 + (random_bits() >> random_between(1, 31)) % 0x20000000;
        static const int16_t middle[3] = {0, 0, 0};
        double ahead = truth(middle).z, radius = mesh.radius / 65536. * pose.scale / 65536,
               slack = 0x1p-22 * (fabs(ahead) + radius + 1);
        double beyond =
            fmax(scene.camera.near_plane / 65536. - ahead - radius, ahead - radius - scene.camera.far_plane / 65536.);
        if (fabs(beyond) < slack * fmax(1, pose.scale / 65536.))
            continue;
        assert_int_equal(setup(&t, &to_eye), beyond < 0);
        out += beyond > 0;
        in += beyond < 0;
    }
    assert_true(out > 1000 && in > 1000);
}

/* Every field anywhere in the range that scene.h gives it: nothing overflows (a sanitizer would say so), the planes
 * stand in their order though both be nearer than a step of z, and what is placed is inside the guard band and the
 * depths. */
static void the_extremes_of_all_ranges_do_not_overflow(void **state)
{
    (void)state;
    int placed = 0;
    random_seed(54);
    for (int i = 0; i < 200000; i++) {
        struct scene_camera *c = &scene.camera;
        struct transform t;
        struct matrix to_eye;
        random_case(i & 1 ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC);
        for (int k = 0; k < 3; k++) {
            static const q16_t most[] = {(1 << 30) - 1, 1 - (1 << 30), 0};
            c->position[k] = i & 2 ? most[random_bits() % 3] : c->position[k];
            pose.position[k] = i & 4 ? most[random_bits() % 3] : pose.position[k];
            mesh.centre[k] = i & 8 ? most[random_bits() % 3] : mesh.centre[k];
        }
        mesh.extent = i & 16 ? random_bits() & 1 ? 1 << 6 : (1 << 30) - 1 : mesh.extent;
        mesh.radius = i & 32 ? random_bits() & 1 ? 1 : INT32_MAX : mesh.radius;
        if (mesh.radius < mesh.extent * 1.7320509) /* scene_check() would refuse it */
            mesh.radius = (q16_t)fmin(mesh.extent * 1.7320509 + 1, 0x1p31 - 1);
        pose.scale = i & 64 ? random_bits() & 1 ? 1 << 8 : (1 << 24) - 1 : pose.scale;
        c->focal = i & 128 ? random_bits() & 1 ? 1 << 12 : (1 << 30) - 1 : c->focal;
        c->near_plane = i & 256 ? 256 : c->near_plane;
        c->far_plane = i & 512 ? INT32_MAX : c->near_plane + 1;
        width = i & 1024 ? 2048 : 1;
        height = i & 2048 ? 2048 : 1;
        c->reference_width = i & 4096 ? 2048 : 1;
        c->reference_height = i & 8192 ? 2048 : 1;
        if (!setup(&t, &to_eye))
            continue;
        assert_true(t.near_z >= 1 && t.near_z <= t.far_z);
        for (int j = 0; j < 4; j++) {
            int16_t p[3];
            struct screen_point at;
            random_position(p);
            if (!project(&t, transform_point(&t, p), &at))
                continue;
            placed++;
            assert_true(at.x >= -GUARD && at.x <= GUARD && at.y >= -GUARD && at.y <= GUARD);
            assert_true(at.depth >= DEPTH_FAR && at.depth <= DEPTH_NEAR);
        }
    }
    assert_true(placed > 10000);
}

/* Whichever object a point belongs to, its depth is the same: the numbers of each object's rows differ. */
static void depth_does_not_depend_on_the_object(void **state)
{
    (void)state;
    random_seed(55);
    for (int i = 0; i < 20000; i++) {
        static const int16_t middle[3] = {0, 0, 0};
        struct screen_point at[3];
        int placed = 0;
        memset(&scene, 0, sizeof scene);
        memset(&mesh, 0, sizeof mesh);
        width = height = scene.camera.reference_width = scene.camera.reference_height = 64;
        scene.camera.kind = i & 1 ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC;
        scene.camera.rotation[0] = pose.rotation.q[0] = 1 << 30;
        pose.rotation.q[1] = pose.rotation.q[2] = pose.rotation.q[3] = 0;
        scene.camera.focal = 64 * PLACE_UNIT;
        scene.camera.near_plane = (q16_t)random_magnitude(PLACE_UNIT / 16, PLACE_UNIT);
        scene.camera.far_plane = (q16_t)random_magnitude(4 * PLACE_UNIT, 30000. * PLACE_UNIT);
        pose.position[0] = pose.position[1] = 0;
        pose.position[2] = -random_between(scene.camera.near_plane + 1, 4 * PLACE_UNIT - 1);
        pose.scale = PLACE_UNIT;
        for (int k = 0; k < 3; k++) { /* three sizes about the same point */
            struct transform t;
            struct matrix to_eye;
            mesh.extent = (q16_t)random_magnitude(64, 4000. * PLACE_UNIT);
            mesh.radius = (q16_t)(mesh.extent * 1.7320509 + 1);
            placed += setup(&t, &to_eye) && project(&t, transform_point(&t, middle), &at[k]);
        }
        assert_int_equal(placed, 3);
        assert_true(abs(at[0].depth - at[1].depth) <= 3 && abs(at[0].depth - at[2].depth) <= 3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_vertex_in_perspective_is_placed_to_the_nearest_sub_pixel),
        cmocka_unit_test(an_orthographic_vertex_is_placed_to_the_nearest_sub_pixel),
        cmocka_unit_test(an_object_is_left_out_only_if_no_part_of_it_is_between_the_planes),
        cmocka_unit_test(the_extremes_of_all_ranges_do_not_overflow),
        cmocka_unit_test(depth_does_not_depend_on_the_object),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* From positions and lights to screen and vertex records, against double precision. */
#include "geometry/object.h"
#include "geometry/project.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "scene_case.h"

/* A case: camera, object and mesh, from which both ways start. */
static struct scene_header scene;
static struct scene_mesh mesh;
static struct pose pose;
static uint16_t width, height;

struct place {
    double x, y, z; /* eye's axes, scene units, z ahead */
    double sx, sy;  /* sub-pixels from the picture's centre, y down */
    double depth;
};

/* The matrix of a quaternion as stored, rows first. */
static void real_matrix(const q30_t q[4], double m[3][3])
{
    const double w = q[0] * 0x1p-30, x = q[1] * 0x1p-30, y = q[2] * 0x1p-30, z = q[3] * 0x1p-30;
    const double rows[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                               {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                               {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
    memcpy(m, rows, sizeof rows);
}

static void apply(double m[3][3], const double v[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
}

static void world_place(const int16_t p[3], double out[3])
{
    double m[3][3], local[3];
    for (int i = 0; i < 3; i++)
        local[i] = (mesh.centre[i] + mesh.extent * (p[i] / 32768.)) / 65536 * (pose.scale / 65536.);
    real_matrix(pose.rotation.q, m);
    apply(m, local, out);
    for (int i = 0; i < 3; i++)
        out[i] += pose.position[i] / 65536.;
}

static double real_focal(void)
{
    const struct scene_camera *c = &scene.camera;
    return c->focal / 65536. * fmin(width / (double)c->reference_width, height / (double)c->reference_height);
}

static struct place truth(const int16_t p[3])
{
    const struct scene_camera *c = &scene.camera;
    double m[3][3], world[3], eye[3], f = 16 * real_focal();
    double near_z = c->near_plane / 65536., far_z = c->far_plane / 65536.;
    world_place(p, world);
    for (int i = 0; i < 3; i++)
        world[i] -= c->position[i] / 65536.;
    real_matrix(c->rotation, m);
    apply(m, world, eye);
    struct place at = {eye[0], eye[1], -eye[2], f * eye[0], -f * eye[1], (far_z + eye[2]) / (far_z - near_z)};
    if (c->kind == CAMERA_PERSPECTIVE) {
        at.sx /= at.z;
        at.sy /= at.z;
        at.depth = near_z / at.z;
    }
    at.depth = DEPTH_FAR + at.depth * (DEPTH_NEAR - DEPTH_FAR);
    return at;
}

static void random_rotation(q30_t q[4])
{
    double v[4];
    random_direction(v, 4);
    for (int i = 0; i < 4; i++)
        q[i] = (q30_t)lrint(v[i] * 0x1p30);
}

/* Something that is likely to be seen: in front of the camera, some pixels large, at any scale of the numbers. */
static void random_case(enum scene_camera_kind kind)
{
    struct scene_camera *c = &scene.camera;
    width = (uint16_t)random_between(1, 1024);
    height = (uint16_t)random_between(1, 1024);
    c->kind = (uint16_t)kind;
    random_rotation(c->rotation);
    random_rotation(pose.rotation.q);
    c->reference_width = (uint16_t)random_between(1, 2048);
    c->reference_height = (uint16_t)random_between(1, 2048);
    pose.scale = (q16_t)random_magnitude(1 << 8, (1 << 24) - 1);
    mesh.extent = (q16_t)random_magnitude(1 << 6, (1 << 30) - 1);
    mesh.radius = (q16_t)fmin(mesh.extent * 1.7320509 + 1, 0x1p31 - 1);
    double size = mesh.extent * (double)pose.scale / 65536, m[3][3], offset[3], ahead[3];
    double distance = fmin(size * random_magnitude(.5, 4000), 0x1p29);
    double most = 65536 * random_magnitude(1, 16384), aside = distance * random_real(0, .7);
    if (distance < 256)
        distance = 256;
    /* the object's centre, from the eye, turned back into the world */
    for (int i = 0; i < 3; i++)
        ahead[i] = i == 2 ? -distance : random_real(-aside, aside);
    real_matrix(c->rotation, m);
    for (int i = 0; i < 3; i++)
        offset[i] = m[0][i] * ahead[0] + m[1][i] * ahead[1] + m[2][i] * ahead[2];
    for (int i = 0; i < 3; i++) {
        mesh.centre[i] = random_bits() & 1 ? (q16_t)random_real(-mesh.extent, mesh.extent) : 0;
        c->position[i] = (q16_t)fmax(fmin(random_real(-most, most), 0x1p30 - 1), 1 - 0x1p30);
        pose.position[i] = (q16_t)fmax(fmin(c->position[i] + offset[i], 0x1p30 - 1), 1 - 0x1p30);
    }
    double pixels = random_magnitude(2, 600), f = pixels * 65536 / size;
    f = kind == CAMERA_PERSPECTIVE ? f * distance / 65536 : f;
    f *= 65536 / fmin(width / (double)c->reference_width, height / (double)c->reference_height);
    c->focal = (q16_t)fmax(fmin(f, 0x1p30 - 1), 4096);
    c->near_plane = (q16_t)fmax(fmin(distance * random_real(.001, 1), 0x1p30), 256);
    c->far_plane = (q16_t)fmin(c->near_plane + 2 * size + distance * random_real(1, 3), 0x1p31 - 1);
}

static void random_position(int16_t p[3])
{
    for (int i = 0; i < 3; i++)
        p[i] = (int16_t)(random_bits() % 4 ? random_between(-32768, 32767) : random_between(0, 1) * 65535 - 32768);
}

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_vertex_in_perspective_is_placed_to_the_nearest_sub_pixel),
        cmocka_unit_test(an_orthographic_vertex_is_placed_to_the_nearest_sub_pixel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

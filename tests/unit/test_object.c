/* SPDX-License-Identifier: MIT */
/* Lights as an object sees them, and vertex records, against double precision. */
#include "geometry/object.h"
#include "geometry/project.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "place_case.h"
#include "scene_case.h"

static double real_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A direction of the world in the object's axes, of length 1. */
static void to_object(const double v[3], double out[3])
{
    double m[3][3], length = sqrt(real_dot(v, v));
    real_matrix(pose.rotation.q, m);
    for (int i = 0; i < 3; i++)
        out[i] = (m[0][i] * v[0] + m[1][i] * v[1] + m[2][i] * v[2]) / length;
}

/* Towards a light, or a near eye, and half-way, as they should be; returns the length that half-way had. */
static double light_truth(const struct scene_light *light, const int16_t p[3], double towards[3], double half[3])
{
    double at[3], v[3], to_eye[3], m[3][3];
    world_place(p, at);
    for (int i = 0; i < 3; i++)
        v[i] = light->kind == LIGHT_POINT ? light->vector[i] / 65536. - at[i] : light->vector[i];
    to_object(v, towards);
    real_matrix(scene.camera.rotation, m);
    for (int i = 0; i < 3; i++)
        v[i] = scene.camera.viewer == VIEWER_LOCAL ? scene.camera.position[i] / 65536. - at[i] : m[2][i];
    to_object(v, to_eye);
    for (int i = 0; i < 3; i++)
        half[i] = towards[i] + to_eye[i];
    double length = sqrt(real_dot(half, half));
    for (int i = 0; i < 3; i++)
        half[i] /= length;
    return length;
}

/* Four lights about an object of about a unit, up to 1000 units away, none nearer than it is large. */
static void random_lights(struct scene_case *c)
{
    scene_case_default(c, 64, 64);
    c->light_count = 4;
    random_rotation(pose.rotation.q);
    random_rotation(c->head.camera.rotation);
    mesh.extent = (q16_t)random_magnitude(CASE_UNIT / 16, 16 * CASE_UNIT);
    pose.scale = (q16_t)random_magnitude(CASE_UNIT / 16, 16 * CASE_UNIT);
    double size = (double)mesh.extent * pose.scale / CASE_UNIT;
    for (int k = 0; k < 3; k++) {
        mesh.centre[k] = random_between(-mesh.extent, mesh.extent);
        pose.position[k] = random_between(-100 * CASE_UNIT, 100 * CASE_UNIT);
    }
    static const int16_t middle[3] = {0, 0, 0};
    double centre[3], v[3];
    world_place(middle, centre);
    for (int i = 0; i < 5; i++) { /* the last is the eye */
        double away = (i == 4 ? 3 : 2.5) * size + random_magnitude(fmin(size, CASE_UNIT), 1000. * CASE_UNIT);
        random_direction(v, 3);
        for (int k = 0; k < 3; k++)
            if (i == 4)
                c->head.camera.position[k] = (q16_t)(centre[k] * CASE_UNIT + v[k] * away);
            else
                c->light[i].vector[k] = (int32_t)(i & 1 ? centre[k] * CASE_UNIT + v[k] * away : v[k] * 0x1p30);
        if (i < 4)
            c->light[i].kind = i & 1 ? LIGHT_POINT : LIGHT_DIRECTIONAL;
    }
    c->head.camera.viewer = random_bits() & 1 ? VIEWER_LOCAL : VIEWER_INFINITE;
}

static void lights_are_turned_into_the_objects_axes(void **state)
{
    (void)state;
    static struct scene_case c;
    double largest = 0;
    random_seed(56);
    for (int i = 0; i < 3000; i++) {
        struct view view;
        struct object_state object;
        struct transform t;
        struct matrix to_eye;
        random_lights(&c);
        struct scene_header *blob = malloc(sizeof *blob + sizeof c.light);
        assert_non_null(blob);
        scene = c.head;
        *blob = c.head;
        blob->lights = sizeof *blob;
        blob->light_count = 4;
        memcpy(blob + 1, c.light, sizeof c.light);
        object.mesh = &mesh;
        view_setup(&view, blob, 64, 64);
        mesh.radius = (q16_t)fmin(mesh.extent * 1.7320818 + 1, 0x1p31 - 1);
        transform_setup(&t, &view, &mesh, &pose, &to_eye); /* seen or not, the matrix is set */
        object_light_setup(&object, blob, &view, &pose, &to_eye, 0);
        for (int j = 0; j < 8; j++) {
            int16_t p[3];
            random_position(p);
            const int32_t place[3] = {p[0], p[1], p[2]};
            for (unsigned l = 0; l < 4; l++) {
                q14_t towards[3], half[3];
                double wanted[3], wanted_half[3], length = light_truth(&c.light[l], p, wanted, wanted_half);
                object_light_at(&object, l, place, towards, half);
                for (int k = 0; k < 3; k++) {
                    double error = fabs(towards[k] / 16384. - wanted[k]);
                    double half_error = fabs(half[k] / 16384. - wanted_half[k]) * fmin(length, 1);
                    largest = fmax(largest, fmax(error, half_error));
                    assert_true(error < 0x1p-12 && half_error < 0x1p-11);
                }
            }
        }
        free(blob);
    }
    print_message("light vectors: at most 2^%.2f off\n", log2(largest));
}

#define VERTICES 60

/* Returns whether all were placed. */
static int check_records(const struct object_state *object, const struct scene_header *blob, const struct transform *t,
                         const struct scene_vertex *vertex)
{
    static int16_t record[VERTICES][VERTEX_LIGHTS + 8];
    int all = object_place_vertices(object, blob, t, 4, record[0], VERTEX_LIGHTS + 8), placed = 0;
    for (int v = 0; v < VERTICES; v++) {
        struct screen_point at;
        const int32_t place[3] = {vertex[v].position[0], vertex[v].position[1], vertex[v].position[2]};
        int wanted = project(t, transform_point(t, vertex[v].position), &at);
        if (record[v][VERTEX_X] != VERTEX_UNPLACED) {
            assert_true(wanted && record[v][VERTEX_X] == at.x && record[v][VERTEX_Y] == at.y &&
                        (uint16_t)record[v][VERTEX_DEPTH] == at.depth);
            placed++;
        } else {
            int edge = GUARD - 16; /* the last pixel of the guard band may be left to clipping */
            assert_true(!wanted || at.x > edge || at.y > edge || at.x < -edge || at.y < -edge);
        }
        for (unsigned l = 0; l < 4; l++) {
            q14_t way[2][3];
            object_light_at(object, l, place, way[0], way[1]);
            for (int h = 0; h < 2; h++) {
                double n[3] = {vertex[v].normal[0], vertex[v].normal[1], vertex[v].normal[2]};
                double w[3] = {way[h][0], way[h][1], way[h][2]};
                double dot = fmax(fmin(real_dot(n, w) / 16384, 16383), -16384);
                assert_true(fabs(record[v][VERTEX_LIGHTS + 2 * l + h] - dot) <= .5);
            }
        }
    }
    assert_int_equal(all, placed == VERTICES);
    return all;
}

/* The records of a mesh's vertices: dots of normal and light rounded to the nearest, places as above. */
static void a_vertex_record_holds_place_and_dots(void **state)
{
    (void)state;
    static struct scene_case c;
    static struct scene_vertex vertex[VERTICES];
    struct scene_triangle triangle = {.corner = {0, 1, 2}};
    int unplaced = 0, whole = 0;
    random_seed(57);
    for (int i = 0; i < 500; i++) {
        struct view view;
        struct object_state object;
        struct transform t;
        struct matrix to_eye;
        random_lights(&c);
        for (int v = 0; v < VERTICES; v++) {
            double n[3];
            random_direction(n, 3);
            scene_case_normal(vertex[v].normal, n[0], n[1], n[2]);
            random_position(vertex[v].position);
        }
        scene_case_bend(&triangle, vertex);
        c.mesh[0] = (struct scene_case_mesh){mesh, vertex, &triangle, VERTICES, 1};
        c.mesh[0].head.radius = mesh.radius = (q16_t)(mesh.extent * 1.7320818 + 1);
        memcpy(c.object[0].rotation, pose.rotation.q, sizeof c.object[0].rotation);
        memcpy(c.object[0].position, pose.position, sizeof c.object[0].position);
        c.object[0].scale = pose.scale;
        random_case(CAMERA_PERSPECTIVE); /* a new pose, seen from a new camera */
        c.head.camera = scene.camera;
        c.mesh[0].head = mesh;
        struct scene_header *blob = scene_case_blob(&c);
        object.mesh = scene_meshes(blob);
        view_setup(&view, blob, width, height);
        if (transform_setup(&t, &view, object.mesh, &pose, &to_eye)) {
            object_light_setup(&object, blob, &view, &pose, &to_eye, 0);
            int all = check_records(&object, blob, &t, vertex);
            whole += all;
            unplaced += !all;
        }
        free(blob);
    }
    assert_true(whole > 10 && unplaced > 10);
}

/* Q28, and a step of 2^-8 besides. */
static void a_light_in_the_very_place_shines_along_z(void **state)
{
    struct object_point point = {.near = 1};
    int32_t out[3];
    (void)state;
    random_seed(63);
    for (int i = 0; i < 9000; i++) {
        int32_t place[3];
        point.shift = (int16_t)(i % 9);
        for (int k = 0; k < 3; k++) {
            point.at[k] = random_between(-32768 << point.shift, 32767 << point.shift);
            place[k] = point.at[k] * (1 << (8 - point.shift));
        }
        object_towards(&point, place, out);
        assert_true(out[0] == 0 && out[1] == 0 && out[2] == 1 << 28);
        const int axis = i / 9 % 3, sign = i & 1 ? 1 : -1;
        point.at[axis] += sign;
        object_towards(&point, place, out);
        for (int k = 0; k < 3; k++)
            assert_in_range(out[k] * sign + (1 << 10), k == axis ? 1 << 28 : 1 << 10,
                            (k == axis ? 1 << 28 : 0) + (1 << 11));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lights_are_turned_into_the_objects_axes),
        cmocka_unit_test(a_vertex_record_holds_place_and_dots),
        cmocka_unit_test(a_light_in_the_very_place_shines_along_z),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

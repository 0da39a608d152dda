/* SPDX-License-Identifier: MIT */
/* What the papers' scenes under tests/scenes/ must be like to show what the papers show with them. */
#include "import/normals.h"
#include "scene/reader.h"
#include "scene/scene.h"
#include "scene/vec.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>

static struct model load(const char *name)
{
    struct model model;
    char path[64];
    snprintf(path, sizeof path, "tests/scenes/%s.json", name);
    assert_int_equal(reader_load(path, &model), 0);
    return model;
}

static double distance(const double a[3], const double b[3])
{
    double d[3];
    vec_sub(a, b, d);
    return vec_length(d);
}

static void normals_are_unit_and_on_the_side_of_their_faces(void **state)
{
    (void)state;
    /* how many corners are on the other: the lip of the teapot's spout turns over within one segment */
    static const struct {
        const char *name;
        unsigned wrong;
    } scenes[] = {{"torus512", 0}, {"sphere168", 0}, {"serpentine", 0}, {"zigzag", 0},
                  {"strip", 0},    {"bulb", 0},      {"pawn", 0},       {"teapot896", 6}};
    for (size_t s = 0; s < sizeof scenes / sizeof *scenes; s++) {
        struct model model = load(scenes[s].name);
        unsigned wrong = 0;
        for (const struct model_mesh *mesh = model.meshes; mesh < model.meshes + model.mesh_count; mesh++)
            for (size_t i = 0; i < mesh->triangle_count; i++) {
                double face[3];
                for (int k = 0; normals_face(mesh, &mesh->triangles[i], face) && k < 3; k++) {
                    const double *normal = mesh->vertices[mesh->triangles[i].corner[k]].normal;
                    assert_true(fabs(vec_length(normal) - 1) < 1e-15);
                    wrong += vec_dot(normal, face) <= 0;
                }
            }
        assert_int_equal(wrong, scenes[s].wrong);
        model_free(&model);
    }
}

/* Lee and Jen (2001), the test after eq. 6: whether the profile over the edge has an inflection, beyond rounding. */
static bool is_serpentine(const struct model_vertex *a, const struct model_vertex *b)
{
    double edge[3];
    vec_sub(b->position, a->position, edge);
    const double at_a = vec_dot(a->normal, edge), at_b = vec_dot(b->normal, edge);
    return fabs(at_a) > 1e-9 && fabs(at_b) > 1e-9 && (at_a > 0) == (at_b > 0);
}

static void edges_across_the_waves_are_serpentine_and_no_others(void **state)
{
    (void)state;
    static const char *const names[] = {"serpentine", "zigzag"};
    for (int s = 0; s < 2; s++) {
        struct model model = load(names[s]);
        const struct model_mesh *mesh = model.meshes;
        for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
            const uint32_t *corner = mesh->triangles[i / 3].corner;
            const struct model_vertex *a = &mesh->vertices[corner[i % 3]], *b = &mesh->vertices[corner[(i + 1) % 3]];
            assert_int_equal(is_serpentine(a, b), a->position[0] != b->position[0]);
        }
        model_free(&model);
    }
}

static void the_ideal_surfaces_go_through_the_vertices_with_their_normals(void **state)
{
    (void)state;
    static const char *const names[][2] = {{"serpentine", "serpentine-ideal"}, {"zigzag", "zigzag-ideal"}};
    for (int s = 0; s < 2; s++) {
        struct model model = load(names[s][0]), ideal = load(names[s][1]);
        for (size_t i = 0; i < model.meshes->vertex_count; i++) {
            const struct model_vertex *v = &model.meshes->vertices[i];
            double off = INFINITY;
            for (size_t j = 0; j < ideal.meshes->vertex_count; j++) {
                const struct model_vertex *w = &ideal.meshes->vertices[j];
                if (distance(v->position, w->position) < 1e-15)
                    off = fmin(off, distance(v->normal, w->normal));
            }
            assert_true(off < 1e-6); /* points of six digits in the file */
        }
        for (int k = 0; k < 3; k++)
            assert_true(model.lights->vector[k] == ideal.lights->vector[k]);
        assert_true(model.camera.focal == ideal.camera.focal);
        model_free(&model);
        model_free(&ideal);
    }
}

static void the_strips_light_band_runs_straight_into_the_distance(void **state)
{
    (void)state;
    struct model model = load("strip");
    const struct model_mesh *mesh = model.meshes;
    const double back[4] = {model.camera.rotation[0], -model.camera.rotation[1], -model.camera.rotation[2],
                            -model.camera.rotation[3]};
    double depth[4], halfway[3], most = 0, at = 0;
    for (int i = 0; i < 4; i++) {
        double eye[3];
        vec_sub(mesh->vertices[i].position, model.camera.position, eye);
        vec_quat_rotate(model.camera.rotation, eye, eye);
        depth[i] = -eye[2];
        assert_true(mesh->vertices[i].normal[2] == 0); /* a cylinder along z */
    }
    assert_true(depth[0] == depth[1] && fabs(depth[2] - depth[3]) < 1e-15);
    assert_true(depth[2] > 4 * depth[0]);
    vec_quat_rotate(back, (double[]){0, 0, 1}, halfway); /* the viewer is at infinity */
    for (int k = 0; k < 3; k++)
        halfway[k] += model.lights->vector[k];
    vec_normalise(halfway);
    for (double x = -1; x <= 1; x += 1. / 64) {
        double normal[3] = {.6 * x, .8, 0};
        vec_normalise(normal);
        const double product = vec_dot(normal, halfway);
        at = product > most ? x : at;
        most = fmax(most, product);
    }
    assert_true(most > .999);           /* the highlight is at its full */
    assert_true(at > .125 && at < .25); /* beside the middle, where both triangles see it */
    model_free(&model);
}

static void the_teapot_has_28_patches_and_four_lights_nearby(void **state)
{
    (void)state;
    struct model model = load("teapot896");
    assert_int_equal(model.meshes->triangle_count, 28 * 4 * 4 * 2);
    assert_int_equal(model.light_count, 4);
    for (int i = 0; i < 4; i++)
        assert_int_equal(model.lights[i].kind, LIGHT_POINT);
    assert_int_equal(model.camera.viewer, VIEWER_LOCAL);
    assert_int_equal(model.camera.size[0], 256);
    model_free(&model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normals_are_unit_and_on_the_side_of_their_faces),
        cmocka_unit_test(edges_across_the_waves_are_serpentine_and_no_others),
        cmocka_unit_test(the_ideal_surfaces_go_through_the_vertices_with_their_normals),
        cmocka_unit_test(the_strips_light_band_runs_straight_into_the_distance),
        cmocka_unit_test(the_teapot_has_28_patches_and_four_lights_nearby),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

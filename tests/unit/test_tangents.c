/* SPDX-License-Identifier: MIT */
/* The moving frames of bump mapping: host-tools/import/tangents.h. */
#include "import/tangents.h"

#include "import/normals.h"
#include "import/shape.h"
#include "scene/vec.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static void shape(struct model *model, int which, enum shape_axis axis)
{
    static const double size[2] = {2, 1}, profile[4][2] = {{0, 0}, {.6, .2}, {.4, 1}, {0, 1.2}};
    struct model_mesh *mesh = model_add_mesh(model, "");
    if (which == 0)
        shape_torus(mesh, axis, 1, .5, 12, 12);
    else if (which == 1)
        shape_sphere(mesh, axis, 1, 12, 8);
    else if (which == 2)
        shape_plane(mesh, axis, size, 3);
    else
        shape_revolve(mesh, axis, profile, 4, 24, 1);
}

static void forget(struct model_mesh *mesh)
{
    for (size_t i = 0; i < mesh->vertex_count; i++)
        memset(mesh->vertices[i].tangent, 0, sizeof mesh->vertices[i].tangent);
}

static void frames_stand_upright_on_every_shape_and_follow_its_coordinates(void **state)
{
    (void)state;
    for (int which = 0; which < 4; which++)
        for (int axis = SHAPE_X; axis <= SHAPE_Z; axis++) {
            struct model model = {0};
            shape(&model, which, (enum shape_axis)axis);
            struct model_mesh *mesh = model.meshes;
            tangents_make(mesh);
            for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
                const struct model_triangle *t = &mesh->triangles[i / 3];
                const struct model_vertex *v = &mesh->vertices[t->corner[i % 3]];
                double b[3], along[3];
                assert_true(fabs(vec_length(v->tangent) - 1) < 1e-12);
                assert_true(fabs(vec_dot(v->tangent, v->normal)) < 1e-12);
                vec_cross(v->normal, v->tangent, b);
                double face[3];
                if (!normals_face(mesh, t, face))
                    continue; /* at a pole */
                const struct model_vertex *o = &mesh->vertices[t->corner[(i + 1) % 3]];
                vec_sub(o->position, v->position, along);
                if (o->uv[1] == v->uv[1] && vec_length(along) > 1e-9)
                    assert_true(vec_dot(along, v->tangent) * (o->uv[0] - v->uv[0]) > 0);
                if (o->uv[0] == v->uv[0] && vec_length(along) > 1e-9)
                    assert_true(v->sign * vec_dot(along, b) * (o->uv[1] - v->uv[1]) > 0);
            }
            model_free(&model);
        }
}

static void tangents_from_the_triangles_of_a_torus_are_the_analytic_ones_at_its_seam_too(void **state)
{
    (void)state;
    struct model given = {0}, made = {0};
    shape(&given, 0, SHAPE_Z);
    shape(&made, 0, SHAPE_Z);
    forget(made.meshes);
    tangents_make(given.meshes);
    tangents_make(made.meshes);
    for (size_t i = 0; i < given.meshes->vertex_count; i++)
        assert_true(vec_dot(given.meshes->vertices[i].tangent, made.meshes->vertices[i].tangent) > cos(1e-6));
    model_free(&given);
    model_free(&made);
}

static uint32_t corner(struct model_mesh *mesh, double x, double y, double u, double v)
{
    return model_add_vertex(mesh, (double[]){x, y, 0}, (double[]){0, 0, 1}, u, v);
}

static void a_vertex_between_mirrored_triangles_becomes_two(void **state)
{
    (void)state;
    struct model model = {0};
    struct model_mesh *mesh = model_add_mesh(&model, "");
    uint32_t low = corner(mesh, 0, -1, 0, 0), high = corner(mesh, 0, 1, 0, 1);
    uint32_t right = corner(mesh, 1, 0, 1, .5), left = corner(mesh, -1, 0, 1, .5);
    model_add_triangle(mesh, low, right, high, 0);
    model_add_triangle(mesh, low, high, left, 0);
    tangents_make(mesh);
    assert_int_equal(mesh->vertex_count, 6);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++) {
            const struct model_vertex *v = &mesh->vertices[mesh->triangles[i].corner[k]];
            assert_true(v->sign == (i ? -1 : 1));
            assert_true(fabs(v->tangent[0] - (i ? -1 : 1)) < 1e-12);
        }
    model_free(&model);
}

static void without_texture_coordinates_frames_still_stand_upright(void **state)
{
    (void)state;
    struct model model = {0};
    shape(&model, 1, SHAPE_Y);
    forget(model.meshes);
    for (size_t i = 0; i < model.meshes->vertex_count; i++)
        model.meshes->vertices[i].uv[0] = model.meshes->vertices[i].uv[1] = .25;
    model.meshes->vertices[7].normal[0] = NAN;
    tangents_make(model.meshes);
    for (size_t i = 0; i < model.meshes->vertex_count; i++) {
        const struct model_vertex *v = &model.meshes->vertices[i];
        assert_true(v->sign == 1);
        assert_true(fabs(vec_length(v->tangent) - 1) < 1e-12);
        assert_true(i == 7 || fabs(vec_dot(v->tangent, v->normal)) < 1e-12);
    }
    model_free(&model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_stand_upright_on_every_shape_and_follow_its_coordinates),
        cmocka_unit_test(tangents_from_the_triangles_of_a_torus_are_the_analytic_ones_at_its_seam_too),
        cmocka_unit_test(a_vertex_between_mirrored_triangles_becomes_two),
        cmocka_unit_test(without_texture_coordinates_frames_still_stand_upright),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

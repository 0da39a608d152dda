/* SPDX-License-Identifier: MIT */
/* The scene made around a model that comes alone. */
#include "pack/frame.h"
#include "scene/vec.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "pack_case.h"

static const double turn = 6.283185307179586;

static struct model load(const char *name, const char *text)
{
    struct case_file file;
    struct model model;
    case_write(&file, name, text, strlen(text));
    int code = frame_load(file.path, &model);
    case_remove(&file);
    assert_int_equal(code, 0);
    return model;
}

/* A model vertex in the eye's axes, after `turned` radians of its spin. */
static void to_eye(const struct model *m, const double position[3], double turned, double out[3])
{
    const struct model_object *object = &m->objects[0];
    double spin[4];
    vec_quat_axis(object->motion.axis, turned, spin);
    vec_quat_rotate(spin, position, out);
    vec_quat_rotate(object->pose.rotation, out, out);
    vec_sub(out, m->camera.position, out);
    vec_quat_rotate(m->camera.rotation, out, out);
}

/* The largest part of half the picture that any vertex reaches in a whole turn, either way. */
static double filled(const struct model *m)
{
    double most = 0, eye[3];
    for (size_t i = 0; i < m->meshes[0].vertex_count; i++)
        for (int step = 0; step < 720; step++) {
            to_eye(m, m->meshes[0].vertices[i].position, turn * step / 720, eye);
            assert_true(-eye[2] > m->camera.near_plane && -eye[2] < m->camera.far_plane);
            for (int k = 0; k < 2; k++)
                most = fmax(most, m->camera.focal * fabs(eye[k]) / -eye[2] / (m->camera.size[k] / 2.));
        }
    return most;
}

static void a_whole_turn_fills_the_picture(void **state)
{
    (void)state;
    static const char *const shapes[] = {
        "v 0 0 0\nv 9 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 4\n", /* wide */
        "v 0 0 0\nv 1 0 0\nv 0 9 0\nv 0 0 1\nf 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 4\n", /* high */
        "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nf 1 3 2\nf 1 4 3\nf 1 2 4\nf 2 3 4\n",
    };
    for (int i = 0; i < 3; i++) {
        struct model m = load("m.obj", shapes[i]);
        double part = filled(&m);
        assert_true(part > 0.9399 && part < 0.9400001);
        model_free(&m);
    }
}

/* How far the first triangle is turned towards the eye: the cosine, up to the perspective. */
static double faces_eye(const struct model *m)
{
    double p[3][3], to_b[3], to_c[3], normal[3];
    for (int k = 0; k < 3; k++)
        to_eye(m, m->meshes[0].vertices[m->meshes[0].triangles[0].corner[k]].position, 0, p[k]);
    vec_sub(p[1], p[0], to_b);
    vec_sub(p[2], p[0], to_c);
    vec_cross(to_b, to_c, normal);
    assert_true(vec_normalise(normal) && vec_normalise(p[0]));
    return -vec_dot(normal, p[0]);
}

static void a_sheet_shows_its_front_whichever_way_it_faces(void **state)
{
    (void)state;
    char text[256];
    for (int step = 0; step < 8; step++) {
        double c = cos(turn * step / 8), s = sin(turn * step / 8);
        snprintf(text, sizeof text, "v %f 0 %f\nv %f 0 %f\nv 0 1 0\nf 1 2 3\n", -c, s, c, -s);
        struct model m = load("m.obj", text);
        assert_true(faces_eye(&m) > 0.5);
        model_free(&m);
        snprintf(text, sizeof text,
                 "solid s\nfacet normal 0 0 0\nouter loop\nvertex %f %f 0\nvertex %f %f 0\nvertex 0 0 1\nendloop\n"
                 "endfacet\nendsolid s\n",
                 -c, -s, c, s);
        m = load("m.stl", text);
        assert_true(faces_eye(&m) > 0.5);
        model_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_whole_turn_fills_the_picture),
        cmocka_unit_test(a_sheet_shows_its_front_whichever_way_it_faces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

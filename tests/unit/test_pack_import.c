/* SPDX-License-Identifier: MIT */
#include "import/import.h"
#include "import/normals.h"
#include "import/shape.h"
#include "pack/report.h"
#include "scene/vec.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "pack_case.h"

#define SQUARE_OBJ "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

/* Writes an OBJ and its MTL side by side, and imports them into mesh 0. */
static struct model import_obj(const char *obj, const char *mtl)
{
    struct case_file file;
    struct model model = {0};
    char path[80];
    case_write(&file, "m.obj", obj, strlen(obj));
    snprintf(path, sizeof path, "%s/m.mtl", file.folder);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(mtl, out);
    fclose(out);
    model_add_mesh(&model, "m");
    int code = import_file(file.path, IMPORT_CREASE * M_PI / 180, &model, 0);
    unlink(path);
    case_remove(&file);
    assert_int_equal(code, 0);
    return model;
}

static void mtl_colours_and_exponent_become_a_material(void **state)
{
    (void)state;
    struct model m = import_obj("mtllib m.mtl\n" SQUARE_OBJ "usemtl red\nf 1 2 3 4\n",
                                "newmtl red\nKd 0.8 0.2 0.1\nKs 0.5 0.4 0.3\nNs 41.6\nillum 2\n");
    int red = model_find_material(&m, "red");
    assert_true(red >= 0);
    const struct model_material *material = &m.materials[red];
    assert_int_equal(m.meshes[0].triangle_count, 2);
    assert_int_equal(m.meshes[0].triangles[0].material, red);
    assert_true(fabs(material->diffuse[0] - 0.8) < 1e-6 && fabs(material->diffuse[2] - 0.1) < 1e-6);
    assert_true(fabs(material->specular[1] - 0.4) < 1e-6);
    assert_true(material->kd == 1 && material->ks == 1 && material->shininess == 42);
    model_free(&m);
}

static void a_material_without_exponent_has_no_highlight(void **state)
{
    (void)state;
    struct model m =
        import_obj("mtllib m.mtl\n" SQUARE_OBJ "usemtl dull\nf 1 2 3 4\n", "newmtl dull\nKd 1 1 1\nKs 1 1 1\n");
    const struct model_material *material = &m.materials[model_find_material(&m, "dull")];
    assert_true(material->ks == 0 && material->shininess == 1);
    model_free(&m);
}

static void an_exponent_beyond_the_tables_is_clamped(void **state)
{
    (void)state;
    struct model m =
        import_obj("mtllib m.mtl\n" SQUARE_OBJ "usemtl mirror\nf 1 2 3 4\n", "newmtl mirror\nKs 1 1 1\nNs 5000\n");
    assert_true(m.materials[model_find_material(&m, "mirror")].shininess == 1023);
    model_free(&m);
}

static void given_normals_are_kept(void **state)
{
    (void)state;
    struct model m = import_obj(SQUARE_OBJ "vn 0 0.6 0.8\nf 1//1 2//1 3//1\n", "");
    assert_int_equal(m.meshes[0].normals, MODEL_NORMALS_GIVEN);
    assert_true(fabs(m.meshes[0].vertices[0].normal[1] - 0.6) < 1e-6);
    model_free(&m);
}

/* The glTF below: one triangle, its 36 bytes of positions in base64, and a material. */
static void metal_and_roughness_become_a_highlight(void **state)
{
    (void)state;
    static const char gltf[] =
        "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\": 0}], "
        "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"material\": 0}]}], "
        "\"materials\": [{\"name\": \"gold\", \"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 0.5, 0, 1], "
        "\"metallicFactor\": 1, \"roughnessFactor\": 0.5}}], "
        "\"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\", "
        "\"min\": [0, 0, 0], \"max\": [1, 1, 0]}], "
        "\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}], \"buffers\": [{\"byteLength\": 36, \"uri\": "
        "\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}";
    struct case_file file;
    struct model m = {0};
    case_write(&file, "t.gltf", gltf, strlen(gltf));
    model_add_mesh(&m, "m");
    assert_int_equal(import_file(file.path, 1, &m, 0), 0);
    case_remove(&file);
    const struct model_material *gold = &m.materials[model_find_material(&m, "gold")];
    assert_int_equal(m.meshes[0].triangle_count, 1);
    assert_true(fabs(gold->shininess - 30) < 1e-3);
    assert_true(fabs(gold->diffuse[0] - pow(0.5, 1 / 2.2)) < 1e-5);
    assert_true(gold->specular[0] == 1 && fabs(gold->specular[2]) < 1e-6); /* a metal's highlight has its colour */
    assert_true(m.meshes[0].normals == MODEL_NORMALS_SMOOTHED);
    model_free(&m);
}

static void smoothing_finds_a_spheres_normals(void **state)
{
    (void)state;
    struct model m = {0};
    struct model_mesh *mesh = model_add_mesh(&m, "ball");
    shape_sphere(mesh, SHAPE_Z, 2, 48, 32);
    normals_smooth(mesh, M_PI / 4);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double radial[3], normal[3];
        memcpy(radial, mesh->vertices[i].position, sizeof radial);
        memcpy(normal, mesh->vertices[i].normal, sizeof normal);
        if (!vec_normalise(normal))
            continue; /* of a pole's triangle without area */
        assert_true(vec_normalise(radial) && vec_dot(radial, normal) > cos(M_PI / 180));
    }
    model_free(&m);
}

/* Two squares that meet at a right angle along x = 1. */
#define CORNER_OBJ "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -1\nv 1 1 -1\nf 1 2 3 4\nf 2 5 6 3\n"

static void creases_stay_sharp_and_others_round(void **state)
{
    (void)state;
    struct model m = import_obj(CORNER_OBJ, "");
    for (int round = 0; round <= 1; round++) {
        normals_smooth(&m.meshes[0], round ? M_PI / 1.9 : M_PI / 2.1);
        for (size_t i = 0; i < m.meshes[0].vertex_count; i++) {
            double normal[3];
            memcpy(normal, m.meshes[0].vertices[i].normal, sizeof normal);
            assert_true(vec_normalise(normal));
            bool on_edge = m.meshes[0].vertices[i].position[0] == 1 && m.meshes[0].vertices[i].position[2] == 0;
            /* weighted by angle, a square counts the same however it was cut into triangles */
            double largest = fmax(normal[0], normal[2]);
            assert_true(fabs(largest - (round && on_edge ? sqrt(0.5) : 1)) < 1e-6);
        }
    }
    model_free(&m);
}

static void a_model_alone_is_framed_and_spins(void **state)
{
    (void)state;
    struct pack_result r;
    char said[256];
    assert_int_equal(case_load("m.obj", "v 10 0 0\nv 30 0 0\nv 10 5 0\nv 10 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
                               &r, said, sizeof said),
                     0);
    const struct scene_mesh *mesh = scene_meshes(r.scene);
    const struct scene_object *object = scene_objects(r.scene);
    assert_int_equal(r.scene->duration_ms, 6000);
    assert_int_equal(object->motion.kind, MOTION_SPIN);
    assert_int_equal(object->motion.rate, 10923); /* a sixth of a turn a second */
    assert_true(abs(mesh->radius - 65536) < 8 && abs(mesh->centre[0]) < 8);
    assert_int_equal(r.scene->light_count, 1);
    pack_free(&r);
}

static void unknown_endings_are_refused(void **state)
{
    (void)state;
    struct pack_result r;
    char said[256];
    assert_int_equal(case_load("m.txt", "hello", &r, said, sizeof said), 1);
    assert_non_null(strstr(said, "not a kind of file that is known"));
    assert_int_equal(case_load_path("/tmp", NULL, &r, said, sizeof said), 3);
    assert_string_equal(said, "/tmp: Is a directory\n");
    assert_int_equal(case_load_path("/dev/null", NULL, &r, said, sizeof said), 3);
    assert_string_equal(said, "/dev/null: not a regular file\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mtl_colours_and_exponent_become_a_material),
        cmocka_unit_test(a_material_without_exponent_has_no_highlight),
        cmocka_unit_test(an_exponent_beyond_the_tables_is_clamped),
        cmocka_unit_test(given_normals_are_kept),
        cmocka_unit_test(metal_and_roughness_become_a_highlight),
        cmocka_unit_test(smoothing_finds_a_spheres_normals),
        cmocka_unit_test(creases_stay_sharp_and_others_round),
        cmocka_unit_test(a_model_alone_is_framed_and_spins),
        cmocka_unit_test(unknown_endings_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

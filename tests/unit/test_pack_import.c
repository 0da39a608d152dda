/* SPDX-License-Identifier: MIT */
#include "import/import.h"
#include "import/limits.h"
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
#include "random.h"

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

/* Imports a glTF of one triangle, its 36 bytes of positions in base64, and a material "gold" with these members more.
 */
static struct model import_gold(const char *members)
{
    static const char text[] =
        "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\": 0}], "
        "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"material\": 0}]}], "
        "\"materials\": [{\"name\": \"gold\", %s\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 0.5, 0, 1], "
        "\"metallicFactor\": 1, \"roughnessFactor\": 0.5}}], "
        "\"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\", "
        "\"min\": [0, 0, 0], \"max\": [1, 1, 0]}], "
        "\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}], \"buffers\": [{\"byteLength\": 36, \"uri\": "
        "\"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}";
    char gltf[sizeof text + 64];
    struct case_file file;
    struct model m = {0};
    snprintf(gltf, sizeof gltf, text, members);
    case_write(&file, "t.gltf", gltf, strlen(gltf));
    model_add_mesh(&m, "m");
    assert_int_equal(import_file(file.path, 1, &m, 0), 0);
    case_remove(&file);
    return m;
}

static void a_double_sided_material_has_two_sides(void **state)
{
    (void)state;
    for (int two_sided = 0; two_sided < 2; two_sided++) {
        struct model m = import_gold(two_sided ? "\"doubleSided\": true, " : "");
        assert_int_equal(m.materials[model_find_material(&m, "gold")].two_sided, two_sided);
        model_free(&m);
    }
}

static void metal_and_roughness_become_a_highlight(void **state)
{
    (void)state;
    struct model m = import_gold("");
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

/* n random faces that share a corner at the origin; `bend` is how far from the xy plane they lean. */
static struct model fan(size_t n, double bend)
{
    struct model m = {0};
    struct model_mesh *mesh = model_add_mesh(&m, "fan");
    const double none[3] = {0, 0, 0};
    random_seed(1);
    model_add_vertex(mesh, none, none, 0, 0);
    for (size_t i = 0; i < 2 * n; i++) {
        double p[3];
        for (int k = 0; k < 3; k++)
            p[k] = random_real(-1, 1) * (k == 2 ? bend : 1);
        model_add_vertex(mesh, p, none, 0, 0);
        if (i % 2)
            model_add_triangle(mesh, 0, (uint32_t)i, (uint32_t)i + 1, 0);
    }
    return m;
}

/* The definition, pair by pair. */
static void mean_normal(const struct model_mesh *mesh, size_t of, double crease, double out[3])
{
    double mine[3], face[3], a[3], b[3];
    normals_face(mesh, &mesh->triangles[of], mine);
    memset(out, 0, 3 * sizeof *out);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const struct model_triangle *t = &mesh->triangles[i];
        memcpy(a, mesh->vertices[t->corner[1]].position, sizeof a);
        memcpy(b, mesh->vertices[t->corner[2]].position, sizeof b);
        assert_true(normals_face(mesh, t, face) && vec_normalise(a) && vec_normalise(b));
        for (int k = 0; vec_dot(mine, face) >= cos(crease) && k < 3; k++)
            out[k] += acos(vec_dot(a, b)) * face[k];
    }
}

static void smoothing_a_large_fan_is_the_mean_of_each_pair(void **state)
{
    (void)state;
    static const double bends[] = {1, 0.05, 0.001}, creases[] = {0.02, M_PI / 4, 2, M_PI};
    for (size_t b = 0; b < sizeof bends / sizeof *bends; b++)
        for (size_t c = 0; c < sizeof creases / sizeof *creases; c++) {
            struct model m = fan(700, bends[b]);
            struct model_mesh *mesh = &m.meshes[0];
            normals_smooth(mesh, creases[c]);
            for (size_t i = 0; i < mesh->triangle_count; i++) {
                double want[3];
                mean_normal(mesh, i, creases[c], want);
                for (int k = 0; k < 3; k++)
                    assert_true(fabs(mesh->vertices[3 * i].normal[k] - want[k]) < 1e-9);
            }
            model_free(&m);
        }
}

/* Rounding turns the faces of a flat fan apart by some 1e-16: not for a crease of 0 either are they an edge. */
static void a_flat_fan_is_smooth_at_any_crease(void **state)
{
    (void)state;
    for (int crease = 0; crease <= 180; crease += 45) {
        struct model m = fan(100000, 0);
        struct model_mesh *mesh = &m.meshes[0];
        for (size_t i = 1; i < mesh->vertex_count; i++) { /* onto x + y + z = 0 */
            double *p = mesh->vertices[i].position;
            p[2] = -p[0] - p[1];
        }
        for (size_t i = 0; i < mesh->triangle_count; i++) { /* all counter-clockwise */
            double face[3];
            uint32_t *corner = mesh->triangles[i].corner;
            if (normals_face(mesh, &mesh->triangles[i], face) && face[2] < 0) {
                uint32_t swap = corner[1];
                corner[1] = corner[2];
                corner[2] = swap;
            }
        }
        normals_smooth(mesh, crease * M_PI / 180);
        for (size_t i = 0; i < mesh->vertex_count; i += 3)
            assert_memory_equal(mesh->vertices[i].normal, mesh->vertices[0].normal, sizeof mesh->vertices[0].normal);
        model_free(&m);
    }
}

/* The sparse file would take 3 seconds a MiB. */
static void processor_time_grows_with_a_gltfs_buffers(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "{\"buffers\": [{\"uri\": \"d.bin\"}, {\"uri\": \"data:,d.bin\"}, {\"uri\": \"no.bin\"}, {}]}",
        "{\"buffers\": {\"b\": {\"uri\": \"d.bin\"}}}",
        "not JSON",
    };
    for (int i = 0; i < 3; i++) {
        struct case_file file;
        char path[80];
        case_write(&file, "t.gltf", texts[i], strlen(texts[i]));
        snprintf(path, sizeof path, "%s/d.bin", file.folder);
        FILE *out = fopen(path, "w");
        assert_true(out && ftruncate(fileno(out), 100 << 20) == 0 && fclose(out) == 0);
        unsigned long seconds = limits_seconds(file.path), alone = limits_seconds(path);
        unlink(path);
        case_remove(&file);
        assert_int_equal(alone, 5 + 300);
        assert_int_equal(seconds, i < 2 ? 5 + 300 : 5);
    }
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
        cmocka_unit_test(a_double_sided_material_has_two_sides),
        cmocka_unit_test(metal_and_roughness_become_a_highlight),
        cmocka_unit_test(smoothing_finds_a_spheres_normals),
        cmocka_unit_test(creases_stay_sharp_and_others_round),
        cmocka_unit_test(smoothing_a_large_fan_is_the_mean_of_each_pair),
        cmocka_unit_test(a_flat_fan_is_smooth_at_any_crease),
        cmocka_unit_test(processor_time_grows_with_a_gltfs_buffers),
        cmocka_unit_test(a_model_alone_is_framed_and_spins),
        cmocka_unit_test(unknown_endings_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
#include "pack/quantise.h"
#include "pack/report.h"
#include "scene/vec.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "pack_case.h"

#define OBJECT(shape) "\"meshes\": {\"m\": {" shape "}}, \"objects\": [{\"mesh\": \"m\"}]"

static const struct scene_mesh *mesh_of(const struct pack_result *r)
{
    return scene_meshes(r->scene);
}

static void check_counts(const char *scene, unsigned vertices, unsigned triangles, unsigned degenerate)
{
    struct pack_result r;
    char path[128], said[256];
    snprintf(path, sizeof path, "tests/scenes/%s.json", scene);
    assert_int_equal(case_load_path(path, NULL, &r, said, sizeof said), 0);
    assert_int_equal(mesh_of(&r)->vertex_count, vertices);
    assert_int_equal(mesh_of(&r)->triangle_count, triangles);
    assert_int_equal(r.report->meshes[0].degenerate, degenerate);
    pack_free(&r);
}

static void the_project_scenes_have_the_counts_in_their_names(void **state)
{
    (void)state;
    check_counts("torus288", 144, 288, 0);
    check_counts("torus288-persp", 144, 288, 0);
    check_counts("torus800", 400, 800, 0);
    check_counts("torus800-persp", 400, 800, 0);
    check_counts("sphere690", 347, 690, 46);
    check_counts("sphere690-persp", 347, 690, 46);
    check_counts("bench-torus288", 144, 288, 0);
    check_counts("bench-torus4000", 2000, 4000, 0);
    check_counts("demo", 144, 288, 0);
    check_counts("torus512", 256, 512, 0);
    check_counts("torus512-persp", 256, 512, 0);
    check_counts("sphere168", 86, 168, 24);
    check_counts("sphere168-persp", 86, 168, 24);
    /* 13 rings of 16 vertices from rim to bottom, a tip, a ring of 8 and 8 of 16 the lid, 9 rings of 8 handle and spout
     * each: patches share the vertices of their sides */
    check_counts("teapot896", 13 * 16 + (1 + 8 + 8 * 16) + 2 * 9 * 8, 896, 0);
}

static void a_coarse_sphere_loses_its_poles_triangles(void **state)
{
    (void)state;
    struct pack_result r = case_scene(OBJECT("\"shape\": \"sphere\", \"slices\": 12, \"stacks\": 8"));
    assert_int_equal(mesh_of(&r)->triangle_count, 168);
    assert_int_equal(mesh_of(&r)->vertex_count, 12 * 7 + 2);
    pack_free(&r);
}

static void the_torus_of_the_papers_bends_by_41_degrees(void **state)
{
    (void)state;
    struct pack_result r;
    char said[256];
    assert_int_equal(case_load_path("tests/scenes/torus288.json", NULL, &r, said, sizeof said), 0);
    assert_true(fabs(report_bend_degrees(r.scene, mesh_of(&r)) - 41.4) < 0.05);
    pack_free(&r);
}

/* A vertex in units, and its normal. */
static void decode(const struct pack_result *r, unsigned corner, double position[3], double normal[3])
{
    const struct scene_mesh *m = mesh_of(r);
    const struct scene_vertex *v = (const struct scene_vertex *)scene_at(r->scene, m->vertices) + corner;
    for (int k = 0; k < 3; k++) {
        position[k] = ldexp(m->centre[k], -16) + v->position[k] * ldexp(m->extent, -31);
        normal[k] = ldexp(v->normal[k], -14);
    }
}

/* Each triangle's corners turn counter-clockwise seen from where their normals point. */
static void check_outward(const struct pack_result *r)
{
    const struct scene_triangle *t = scene_at(r->scene, mesh_of(r)->triangles);
    for (unsigned i = 0; i < mesh_of(r)->triangle_count; i++) {
        double p[3][3], n[3][3], u[3], v[3], face[3];
        for (int k = 0; k < 3; k++)
            decode(r, t[i].corner[k], p[k], n[k]);
        vec_sub(p[1], p[0], u);
        vec_sub(p[2], p[0], v);
        vec_cross(u, v, face);
        for (int k = 0; k < 3; k++)
            assert_true(vec_dot(face, n[k]) > 0);
    }
}

static void every_shape_faces_outwards_about_every_axis(void **state)
{
    (void)state;
    static const char *const shapes[] = {
        "\"shape\": \"torus\", \"rings\": 9, \"sides\": 7",
        "\"shape\": \"sphere\", \"slices\": 7, \"stacks\": 5",
        "\"shape\": \"plane\", \"size\": [2, 1], \"segments\": 3",
        "\"shape\": \"revolution\", \"slices\": 8, \"profile\": [[0, -1], [1, -1], [1.2, 0], [0.3, 1], [0, 1]]",
    };
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++)
        for (char axis = 'x'; axis <= 'z'; axis++) {
            char text[512];
            snprintf(text, sizeof text, OBJECT("%s, \"axis\": \"%c\""), shapes[i], axis);
            struct pack_result r = case_scene(text);
            check_outward(&r);
            pack_free(&r);
        }
}

static void the_two_torus_conventions_lie_where_they_should(void **state)
{
    (void)state;
    for (int z = 0; z <= 1; z++) {
        struct pack_result r = case_scene(z ? OBJECT("\"shape\": \"torus\", \"axis\": \"z\", \"tube\": 0.42")
                                            : OBJECT("\"shape\": \"torus\", \"axis\": \"y\", \"tube\": 0.42"));
        double reach[3] = {0}, p[3], n[3];
        for (unsigned i = 0; i < mesh_of(&r)->vertex_count; i++) {
            decode(&r, i, p, n);
            for (int k = 0; k < 3; k++)
                reach[k] = fmax(reach[k], fabs(p[k]));
        }
        assert_true(fabs(reach[0] - 1.42) < 1e-4);
        assert_true(fabs(reach[z ? 2 : 1] - 0.42) < 1e-4);
        assert_true(fabs(reach[z ? 1 : 2] - 1.42) < 1e-4);
        pack_free(&r);
    }
}

static void quads_split_from_their_first_corner(void **state)
{
    (void)state;
    struct pack_result r = case_scene(OBJECT("\"shape\": \"torus\", \"rings\": 12, \"sides\": 12"));
    const struct scene_triangle *t = scene_at(r.scene, mesh_of(&r)->triangles);
    double p[3], n[3];
    /* of the first quad, both triangles have (0, 0) and (1, 1) */
    const double expected[2][2] = {{0, 0}, {M_PI / 6, M_PI / 6}};
    for (int tri = 0; tri < 2; tri++)
        for (int e = 0; e < 2; e++) {
            double u = expected[e][0], v = expected[e][1], radius = 1 + .5 * cos(v);
            const double want[3] = {radius * cos(u), .5 * sin(v), radius * sin(u)};
            bool found = false;
            for (int k = 0; k < 3; k++) {
                decode(&r, t[tri].corner[k], p, n);
                found = found || hypot(hypot(p[0] - want[0], p[1] - want[1]), p[2] - want[2]) < 1e-4;
            }
            assert_true(found);
        }
    pack_free(&r);
}

static void bends_are_those_of_the_vertex_normals(void **state)
{
    (void)state;
    struct pack_result r = case_scene(OBJECT("\"shape\": \"torus\", \"rings\": 11, \"sides\": 7"));
    const struct scene_triangle *t = scene_at(r.scene, mesh_of(&r)->triangles);
    for (unsigned i = 0; i < mesh_of(&r)->triangle_count; i++)
        for (int e = 0; e < 3; e++) {
            double p[3], a[3], b[3];
            decode(&r, t[i].corner[e], p, a);
            decode(&r, t[i].corner[(e + 1) % 3], p, b);
            /* normals are rounded to 2^-15, the bend is not made from the rounded ones */
            assert_true(fabs((1 - vec_dot(a, b)) / 2 - t[i].bend[e] / 65536.) < 1e-4);
        }
    pack_free(&r);
}

static void rounding_is_as_small_as_reported(void **state)
{
    (void)state;
    struct pack_result r = case_scene(OBJECT("\"shape\": \"sphere\", \"slices\": 40, \"stacks\": 30"));
    double worst = 0, p[3], n[3];
    for (unsigned i = 0; i < mesh_of(&r)->vertex_count; i++) {
        decode(&r, i, p, n);
        worst = fmax(worst, fabs(vec_length(p) - 1));
        assert_true(fabs(vec_length(n) - 1) < 1. / 8192);
    }
    assert_true(worst <= r.report->meshes[0].position_error);
    assert_true(r.report->meshes[0].position_error < ldexp(1, -16) * 1.8);
    assert_true(r.report->meshes[0].normal_error < 0.004);
    pack_free(&r);
}

static void a_flat_material_splits_vertices(void **state)
{
    (void)state;
    struct pack_result r = case_scene("\"materials\": {\"f\": {\"flat\": true}, \"s\": {}}, "
                                      "\"meshes\": {\"m\": {\"shape\": \"torus\", \"rings\": 12, \"sides\": 12, "
                                      "\"material\": \"f\"}}, "
                                      "\"objects\": [{\"mesh\": \"m\"}, {\"mesh\": \"m\", \"material\": \"s\"}]");
    const struct scene_triangle *t = scene_at(r.scene, mesh_of(&r)->triangles);
    assert_int_equal(r.scene->mesh_count, 2); /* one for each choice of material */
    assert_int_equal(r.scene->material_count, 2);
    assert_true(mesh_of(&r)[0].vertex_count >= 288 + 144); /* a torus' quads are flat: four vertices each at least */
    assert_int_equal(mesh_of(&r)[1].vertex_count, 144);
    assert_int_equal(scene_materials(r.scene)[t[0].material].flags, MATERIAL_FLAT);
    for (unsigned i = 0; i < 288; i++)
        for (int e = 0; e < 3; e++)
            assert_int_equal(t[i].bend[e], 0);
    pack_free(&r);
}

static void objects_of_the_same_mesh_share_it(void **state)
{
    (void)state;
    struct pack_result r =
        case_scene("\"meshes\": {\"m\": {\"shape\": \"plane\"}, \"unused\": {\"shape\": \"torus\"}}, "
                   "\"objects\": [{\"mesh\": \"m\"}, {\"mesh\": \"m\"}, {\"mesh\": \"m\"}]");
    assert_int_equal(r.scene->object_count, 3);
    assert_int_equal(r.scene->mesh_count, 1);
    assert_int_equal(r.scene->material_count, 1);
    assert_int_equal(r.report->unused_meshes, 1);
    pack_free(&r);
}

static void materials_of_one_exponent_share_a_table(void **state)
{
    (void)state;
    struct pack_result r = case_scene(
        "\"materials\": {\"a\": {\"shininess\": 9}, \"b\": {\"shininess\": 30.4}, \"c\": {\"shininess\": 8.6}}, "
        "\"meshes\": {\"m\": {\"shape\": \"plane\"}}, \"objects\": [{\"mesh\": \"m\", \"material\": \"a\"}, "
        "{\"mesh\": \"m\", \"material\": \"b\"}, {\"mesh\": \"m\", \"material\": \"c\"}]");
    assert_int_equal(r.scene->power_count, 2);
    assert_int_equal(scene_materials(r.scene)[1].shininess, 30);
    assert_int_equal(scene_materials(r.scene)[2].power, scene_materials(r.scene)[0].power);
    pack_free(&r);
}

static void a_mesh_beyond_16_bits_is_split_on_one_grid(void **state)
{
    (void)state;
    struct pack_result r = case_scene(OBJECT("\"shape\": \"torus\", \"rings\": 300, \"sides\": 250, \"uvs\": true"));
    assert_int_equal(r.scene->mesh_count, 3);
    assert_int_equal(r.scene->object_count, 3);
    uint32_t triangles = 0;
    for (int i = 0; i < 3; i++) {
        triangles += mesh_of(&r)[i].triangle_count;
        assert_int_equal(mesh_of(&r)[i].extent, mesh_of(&r)[0].extent);
        assert_memory_equal(mesh_of(&r)[i].centre, mesh_of(&r)[0].centre, sizeof mesh_of(&r)->centre);
    }
    assert_int_equal(triangles, 2 * 300 * 250);
    assert_int_equal(r.report->meshes[0].parts, 3);
    pack_free(&r);
}

static void texture_coordinates_keep_seams_apart(void **state)
{
    (void)state;
    struct pack_result r = case_scene(OBJECT("\"shape\": \"torus\", \"rings\": 12, \"sides\": 12, \"uvs\": true"));
    const int16_t *uvs = scene_at(r.scene, mesh_of(&r)->uvs);
    int most = 0;
    assert_int_not_equal(mesh_of(&r)->uvs, 0);
    assert_int_equal(mesh_of(&r)->vertex_count, 169);
    for (unsigned i = 0; i < 2 * 169; i++)
        most = uvs[i] > most ? uvs[i] : most;
    assert_int_equal(most, 4096);
    pack_free(&r);
}

static void a_texture_coordinate_that_is_no_number_drops_them_all(void **state)
{
    (void)state;
    for (int k = 0; k <= 1; k++)
        for (int corner = 0; corner < 3; corner++) {
            struct model m = {0};
            struct quantise_mesh out;
            struct pack_mesh_report report = {0};
            struct model_mesh *mesh = model_add_mesh(&m, "m");
            model_add_material(&m, "a");
            mesh->has_uvs = mesh->keeps_uvs = true;
            for (int i = 0; i < 3; i++)
                model_add_vertex(mesh, (double[]){i == 1, i == 2, 0}, (double[]){0, 0, 1}, 0.5, 0.5);
            model_add_triangle(mesh, 0, 1, 2, 0);
            mesh->vertices[corner].uv[k] = NAN;
            assert_null(quantise_mesh(&m, mesh, -1, &out, &report));
            assert_true(report.uvs_dropped);
            assert_null(out.parts[0].uvs);
            quantise_free(&out);
            model_free(&m);
        }
}

static void shininess_can_be_overridden_in_every_kind_of_file(void **state)
{
    (void)state;
    struct pack_result from_json, from_blob;
    struct case_file file;
    char said[256];
    const struct pack_options fifty = {.shininess = 50};
    assert_int_equal(case_load_path("tests/scenes/torus288.json", &fifty, &from_json, said, sizeof said), 0);
    assert_int_equal(scene_materials(from_json.scene)->shininess, 50);
    struct pack_result plain;
    assert_int_equal(case_load_path("tests/scenes/torus288.json", NULL, &plain, said, sizeof said), 0);
    case_write(&file, "a.glt", plain.scene, plain.size);
    assert_int_equal(case_load_path(file.path, &fifty, &from_blob, said, sizeof said), 0);
    assert_int_equal(from_blob.size, from_json.size);
    assert_memory_equal(from_blob.scene, from_json.scene, from_json.size);
    case_remove(&file);
    pack_free(&plain);
    pack_free(&from_json);
    pack_free(&from_blob);
}

static void a_written_blob_is_read_back_the_same(void **state)
{
    (void)state;
    struct pack_result r = case_scene(OBJECT("\"shape\": \"sphere\"")), again;
    struct case_file file;
    char said[256];
    case_write(&file, "b.glt", "", 0);
    assert_int_equal(pack_write_blob(file.path, &r), 0);
    assert_int_equal(case_load_path(file.path, NULL, &again, said, sizeof said), 0);
    assert_int_equal(again.size, r.size);
    assert_memory_equal(again.scene, r.scene, r.size);
    assert_null(again.report);
    case_remove(&file);
    pack_free(&again);
    pack_free(&r);
}

static void the_words_in_c_are_the_blobs(void **state)
{
    (void)state;
    struct pack_result r = case_scene(OBJECT("\"shape\": \"plane\""));
    struct case_file file;
    char line[256];
    size_t words = 0;
    unsigned long length = 0;
    case_write(&file, "c.c", "", 0);
    assert_int_equal(pack_write_c(file.path, "plane", &r), 0);
    FILE *in = fopen(file.path, "r");
    assert_non_null(in);
    while (fgets(line, sizeof line, in)) {
        sscanf(line, "const uint32_t plane_length = %lu;", &length);
        for (char *word = strstr(line, "0x"); word; word = strstr(word + 2, "0x"), words++)
            assert_int_equal(strtoul(word, NULL, 16), ((const uint32_t *)(const void *)r.scene)[words]);
    }
    fclose(in);
    assert_int_equal(length, r.size);
    assert_int_equal(4 * words, r.size);
    case_remove(&file);
    pack_free(&r);
}

static void names_for_c_come_from_file_names(void **state)
{
    (void)state;
    static const char *const cases[][2] = {{"a/b/torus.glt", "torus"}, {"bench-torus288.c", "bench_torus288"},
                                           {"3d.json", "_3d"},         {".hidden", "_hidden"},
                                           {"no_ending", "no_ending"}, {"a.b.c", "a_b"},
                                           {"int.c", "scene_int"},     {"a/_Bool.c", "scene__Bool"},
                                           {"main.c", "scene_main"},   {"uint32_t.c", "scene_uint32_t"},
                                           {"integer.c", "integer"},   {"folder/", "scene_"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char name[32];
        pack_name(cases[i][0], name, sizeof name);
        assert_string_equal(name, cases[i][1]);
        assert_true(pack_is_name(name));
    }
    char small[4];
    pack_name("abcdef.c", small, sizeof small);
    assert_string_equal(small, "abc");
    pack_name("integer.c", small, sizeof small); /* which cut short is one */
    assert_string_equal(small, "sce");
    static const char *const refused[] = {"", "3d", "a-b", "int", "while", "main", "_Alignas", "int8_t", "int long"};
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        assert_false(pack_is_name(refused[i]));
}

/* Between ```json and ``` */
static void the_example_of_the_manual_packs(void **state)
{
    (void)state;
    char text[16384] = "", said[256];
    struct pack_result r;
    FILE *in = fopen("host-tools/README.md", "r");
    assert_non_null(in);
    text[fread(text, 1, sizeof text - 1, in)] = 0;
    fclose(in);
    char *begin = strstr(text, "```json\n"), *end = begin ? strstr(begin + 8, "```") : NULL;
    assert_non_null(end);
    *end = 0;
    assert_int_equal(case_load("readme.json", begin + 8, &r, said, sizeof said), 0);
    assert_string_equal(said, "");
    assert_int_equal(r.scene->object_count, 3);
    pack_free(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_project_scenes_have_the_counts_in_their_names),
        cmocka_unit_test(a_coarse_sphere_loses_its_poles_triangles),
        cmocka_unit_test(the_torus_of_the_papers_bends_by_41_degrees),
        cmocka_unit_test(every_shape_faces_outwards_about_every_axis),
        cmocka_unit_test(the_two_torus_conventions_lie_where_they_should),
        cmocka_unit_test(quads_split_from_their_first_corner),
        cmocka_unit_test(bends_are_those_of_the_vertex_normals),
        cmocka_unit_test(rounding_is_as_small_as_reported),
        cmocka_unit_test(a_flat_material_splits_vertices),
        cmocka_unit_test(objects_of_the_same_mesh_share_it),
        cmocka_unit_test(materials_of_one_exponent_share_a_table),
        cmocka_unit_test(a_mesh_beyond_16_bits_is_split_on_one_grid),
        cmocka_unit_test(texture_coordinates_keep_seams_apart),
        cmocka_unit_test(a_texture_coordinate_that_is_no_number_drops_them_all),
        cmocka_unit_test(shininess_can_be_overridden_in_every_kind_of_file),
        cmocka_unit_test(a_written_blob_is_read_back_the_same),
        cmocka_unit_test(the_words_in_c_are_the_blobs),
        cmocka_unit_test(names_for_c_come_from_file_names),
        cmocka_unit_test(the_example_of_the_manual_packs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

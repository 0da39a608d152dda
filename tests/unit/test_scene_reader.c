/* SPDX-License-Identifier: MIT */
#include "pack/report.h"
#include "scene/reader.h"
#include "scene/vec.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>

#include "pack_case.h"

#define CAM  CASE_CAMERA ", "
#define MESH "\"meshes\": {\"m\": {\"shape\": \"plane\"}}, "

/* A scene that is refused with exactly this message after its file's name. */
static void refuse(const char *text, const char *message)
{
    char said[1024];
    struct pack_result r;
    int code = case_load("s.json", text, &r, said, sizeof said);
    const char *colon = strstr(said, "s.json:");
    assert_int_equal(code, 1);
    assert_null(r.scene);
    assert_non_null(colon);
    said[strlen(said) - 1] = 0; /* the one newline */
    assert_string_equal(colon + strlen("s.json:"), message);
}

static void syntax_errors_name_the_line(void **state)
{
    (void)state;
    refuse("", "1: '[' or '{' expected near end of file");
    refuse("{\n\n  \"camera\": nonsense\n}", "3: invalid token near 'nonsense'");
    refuse("{\"lights\": [1, 2,\n]}", "2: unexpected token near ']'");
    refuse("{\"duration\": 1,\n\"duration\": 2}", "2: duplicate object key near '\"duration\"'");
    refuse("{\"duration\": 1e999}", "1: real number overflow near '1e999'");
}

static void structure_errors_name_the_place(void **state)
{
    (void)state;
    refuse("[]", " must be an object");
    refuse("{}", " camera: missing");
    refuse("{\"colour\": 1}",
           " unknown member \"colour\"; known are: materials textures bumps meshes objects lights camera "
           "ambient background fog duration");
    refuse("{" CAM "\"objects\": {}}", " objects: must be an array");
    refuse("{" CAM "\"objects\": [{\"mesh\": \"foo\"}]}", " objects[0].mesh: no mesh named \"foo\"");
    refuse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\"}, {\"mesh\": \"m\", \"material\": \"gold\"}]}",
           " objects[1].material: no material named \"gold\"");
    refuse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\", \"material\": \"m\"}]}",
           " objects[0].material: no material named \"m\"");
    refuse("{" CAM "\"meshes\": {\"m\": {\"shape\": \"plane\"}, \"n\": {\"shape\": \"plane\", \"material\": \"m\"}}}",
           " meshes.n.material: no material named \"m\"");
    refuse("{" CAM MESH "\"objects\": [{\"mesh\": 1}]}", " objects[0].mesh: must be a string");
    refuse("{" CAM MESH "\"objects\": [{}]}", " objects[0].mesh: missing");
    refuse("{" CAM "\"meshes\": {\"m\": {\"shape\": \"cube\"}}}",
           " meshes.m.shape: \"cube\" is none of: torus sphere plane revolution patches triangles");
    refuse("{" CAM "\"meshes\": {\"m\": {\"shape\": \"plane\", \"tube\": 1}}}",
           " meshes.m: unknown member \"tube\"; known are: shape axis size segments material shading uvs fit");
    refuse("{" CAM "\"meshes\": {\"m\": {}}}", " meshes.m: must be an object with either \"file\" or \"shape\"");
    refuse("{" CAM "\"lights\": [{\"type\": \"point\", \"towards\": [0, 1, 0]}]}", " lights[0].position: missing");
    refuse("{" CAM "\"materials\": {\"a\": {\"flat\": 1}}}", " materials.a.flat: must be true or false");
}

static void a_fog_is_read_or_refused(void **state)
{
    char said[1024];
    struct pack_result r;
    (void)state;
    assert_int_equal(case_load("s.json",
                               "{" CAM MESH "\"objects\": [{\"mesh\": \"m\"}], \"fog\": {\"kind\": \"linear\", "
                               "\"colour\": [0.5, 1, 0], \"from\": 2, \"to\": 4.5}}",
                               &r, said, sizeof said),
                     0);
    const struct scene_fog *fog = &r.scene->fog;
    assert_int_equal(fog->kind, FOG_LINEAR);
    assert_int_equal(fog->colour[0], 1 << 14);
    assert_int_equal(fog->from, 2 << 16);
    assert_int_equal(fog->to, 9 << 15);
    assert_true(r.scene->effects & USES_FOG);
    pack_free(&r);
    assert_int_equal(case_load("s.json",
                               "{" CAM MESH "\"objects\": [{\"mesh\": \"m\"}], \"fog\": {\"kind\": "
                               "\"exponential\", \"density\": 0.25}}",
                               &r, said, sizeof said),
                     0);
    assert_int_equal(r.scene->fog.kind, FOG_EXPONENTIAL);
    assert_int_equal(r.scene->fog.density, 1 << 22);
    pack_free(&r);
    refuse("{" CAM "\"fog\": {\"from\": 1}}", " fog.kind: missing");
    refuse("{" CAM "\"fog\": {\"kind\": \"thick\"}}", " fog.kind: \"thick\" is none of: linear exponential");
    refuse("{" CAM "\"fog\": {\"kind\": \"linear\", \"from\": 1}}", " fog.to: missing");
    refuse("{" CAM "\"fog\": {\"kind\": \"linear\", \"from\": 2, \"to\": 2}}",
           " fog: \"from\" must be less than \"to\"");
    refuse("{" CAM "\"fog\": {\"kind\": \"exponential\", \"to\": 2}}",
           " fog: unknown member \"to\"; known are: kind colour density");
    refuse("{" CAM "\"fog\": {\"kind\": \"exponential\", \"density\": 0}}", " fog.density: 0 is outside 1e-06 .. 16");
    refuse("{" CAM "\"materials\": {\"a\": {\"two_sided\": 1}}}", " materials.a.two_sided: must be true or false");
}

static void numbers_out_of_range_are_refused(void **state)
{
    (void)state;
    refuse("{" CAM "\"ambient\": [0, 0, 1.5]}", " ambient[2]: 1.5 is outside 0 .. 1");
    refuse("{" CAM "\"ambient\": [0, 0]}", " ambient: must have 3 elements");
    refuse("{" CAM "\"background\": [0, 0, \"1\"]}", " background[2]: must be a number");
    refuse("{" CAM "\"duration\": -1}", " duration: -1 is outside 0 .. 1000000");
    refuse("{" CAM "\"materials\": {\"a\": {\"shininess\": 1024}}}",
           " materials.a.shininess: 1024 is outside 1 .. 1023");
    refuse("{" CAM "\"materials\": {\"a\": {\"ks\": 0.5}}}", " materials.a.shininess: missing");
    refuse("{" CAM "\"meshes\": {\"m\": {\"shape\": \"torus\", \"rings\": 2}}}",
           " meshes.m.rings: 2 is outside 3 .. 1024");
    refuse("{" CAM "\"meshes\": {\"m\": {\"shape\": \"torus\", \"rings\": 4.5}}}",
           " meshes.m.rings: must be a whole number");
    refuse("{" CAM "\"lights\": [{\"towards\": [0, 0, 0]}]}", " lights[0].towards: must not be zero");
    refuse("{" CAM "\"lights\": [{\"towards\": [0, 0, 1], \"spin\": {\"axis\": \"y\", \"rate\": 256}}]}",
           " lights[0].spin.rate: 256 is outside -255.99 .. 255.99");
    refuse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\", \"transform\": [{\"scale\": 255}, {\"scale\": 2}]}]}",
           " objects[0].transform: a scale of 510 in all is outside 1/256 .. 255.99");
    refuse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\", \"transform\": [{\"move\": [16000, 0, 0]}, {\"scale\": 2}]}]}",
           " objects[0].transform: ends further than 16383 units from the origin");
    refuse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\", \"transform\": [{\"rotate\": [\"y\", 1], \"scale\": 2}]}]}",
           " objects[0].transform[0]: must have exactly one of: rotate move scale");
    refuse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\", \"transform\": [{\"rotate\": [[0, 0, 0], 1]}]}]}",
           " objects[0].transform[0].rotate[0]: must be \"x\", \"y\", \"z\" or three numbers that are not all zero");
    refuse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\", \"keys\": [{\"time\": 1}, {\"time\": 1.0001}]}]}",
           " objects[0].keys[1]: keys must come in the order of their times, a millisecond apart or more");
}

/* A scene with one mesh of these members. */
#define POINTS(members) "{" CAM "\"meshes\": {\"m\": {" members "}}}"
#define CORNERS         "\"vertices\": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]"
#define TRIANGLES       "\"shape\": \"triangles\", "
#define PATCHES         "\"shape\": \"patches\", \"points\": [[0, 0, 0], [1, 0, 0]], "

static void bad_triangles_are_refused(void **state)
{
    (void)state;
    refuse(POINTS(TRIANGLES "\"triangles\": [[0, 1, 2]]"), " meshes.m.vertices: missing");
    refuse(POINTS(TRIANGLES CORNERS), " meshes.m.triangles: missing");
    refuse(POINTS(TRIANGLES "\"vertices\": [[0, 0, 0]]"), " meshes.m.vertices: must have 3 to 65535 elements");
    refuse(POINTS(TRIANGLES "\"vertices\": [0, 1, 2], \"triangles\": [[0, 1, 2]]"),
           " meshes.m.vertices[0]: must be an array");
    refuse(POINTS(TRIANGLES "\"vertices\": [[0, 0, 0], [1, 0], [0, 1, 0]], \"triangles\": [[0, 1, 2]]"),
           " meshes.m.vertices[1]: must have 3 elements");
    refuse(POINTS(TRIANGLES "\"vertices\": [[0, 0, 0], [1, 0, 2e4], [0, 1, 0]], \"triangles\": [[0, 1, 2]]"),
           " meshes.m.vertices[1][2]: 20000 is outside -16383 .. 16383");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": []"), " meshes.m.triangles: must have 1 to 65535 elements");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": [[0, 1, 2], [0, 1, 3]]"),
           " meshes.m.triangles[1][2]: 3 is outside 0 .. 2");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": [[0, 1, 1.5]]"),
           " meshes.m.triangles[0][2]: must be a whole number");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": [[0, 1]]"), " meshes.m.triangles[0]: must have 3 elements");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": [{}]"), " meshes.m.triangles[0]: must be an array");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": [[0, 1, 2]], \"normals\": [[0, 0, 1], [0, 0, 1]]"),
           " meshes.m.normals: must have 3 elements");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": [[0, 1, 2]], \"normals\": [[0, 0, 1], [0, 0, 0], [0, 0, 1]]"),
           " meshes.m.normals[1]: must not be zero");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": [[0, 1, 2]], \"normals\": [], \"crease\": 1"),
           " meshes.m.crease: not together with \"normals\"");
    refuse(POINTS(TRIANGLES CORNERS ", \"triangles\": [[0, 1, 2]], \"crease\": 181"),
           " meshes.m.crease: 181 is outside 0 .. 180");
    refuse(
        POINTS(TRIANGLES CORNERS ", \"axis\": \"z\""),
        " meshes.m: unknown member \"axis\"; known are: shape vertices normals triangles crease material shading uvs "
        "fit");
}

static void bad_patches_are_refused(void **state)
{
    (void)state;
    refuse(POINTS("\"shape\": \"patches\", \"patches\": [[]]"), " meshes.m.points: missing");
    refuse(POINTS("\"shape\": \"patches\", \"points\": [], \"patches\": [[]]"),
           " meshes.m.points: must have 1 to 65535 elements");
    refuse(POINTS("\"shape\": \"patches\", \"points\": [[0, 0, true]], \"patches\": [[]]"),
           " meshes.m.points[0][2]: must be a number");
    refuse(POINTS(PATCHES "\"segments\": 4"), " meshes.m.patches: missing");
    refuse(POINTS(PATCHES "\"patches\": [[0, 0, 0, 0]]"), " meshes.m.patches[0]: must have 16 elements");
    refuse(POINTS(PATCHES "\"patches\": [[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2]]"),
           " meshes.m.patches[0][15]: 2 is outside 0 .. 1");
    refuse(POINTS(PATCHES "\"patches\": [[-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]]"),
           " meshes.m.patches[0][0]: -1 is outside 0 .. 1");
    refuse(POINTS(PATCHES "\"patches\": [], \"segments\": 4"), " meshes.m.patches: must have 1 to 1024 elements");
    refuse(POINTS(PATCHES "\"patches\": [[]], \"segments\": 33"), " meshes.m.segments: 33 is outside 1 .. 32");
    refuse("{" CAM "\"meshes\": {\"m\": {" PATCHES
           "\"patches\": [[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1]]}}, \"objects\": [{\"mesh\": \"m\"}]}",
           " mesh \"m\" has no triangle with an area");
}

static void triangles_without_normals_get_them_from_their_faces(void **state)
{
    (void)state;
    static const char roof[] = "\"meshes\": {\"m\": {\"shape\": \"triangles\", %s \"vertices\": [[0, 0, 0], [0, 1, 0], "
                               "[1, 0, -1], [-1, 0, -1]], \"triangles\": [[0, 2, 1], [0, 1, 3]]}}, "
                               "\"objects\": [{\"mesh\": \"m\"}]";
    static const struct {
        const char *members;
        unsigned vertices, normals;
    } cases[] = {
        {"", 6, MODEL_NORMALS_SMOOTHED}, /* the ridge is sharper than 45 degrees */
        {"\"crease\": 100,", 4, MODEL_NORMALS_SMOOTHED},
        {"\"normals\": [[0, 0, 1], [0, 0, 2], [0, 0, 1], [0, 0, 1]],", 4, MODEL_NORMALS_GIVEN},
        {"\"crease\": 100, \"shading\": \"flat\",", 6, MODEL_NORMALS_FLAT},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512];
        snprintf(text, sizeof text, roof, cases[i].members);
        struct pack_result r = case_scene(text);
        assert_int_equal(scene_meshes(r.scene)->triangle_count, 2);
        assert_int_equal(scene_meshes(r.scene)->vertex_count, cases[i].vertices);
        assert_int_equal(r.report->meshes[0].normals, cases[i].normals);
        if (cases[i].vertices == 4) { /* of the ridge's ends, both between the two faces or as given */
            const struct scene_vertex *v = scene_at(r.scene, scene_meshes(r.scene)->vertices);
            assert_int_equal(v[0].normal[2], 16384);
        }
        pack_free(&r);
    }
}

static void cameras_that_see_nothing_are_refused(void **state)
{
    (void)state;
    refuse("{\"camera\": {\"near\": 1, \"far\": 2}}", " camera: needs either \"focal\" (pixels) or \"fov\" (degrees)");
    refuse("{\"camera\": {\"focal\": 9, \"near\": 2, \"far\": 2}}", " camera: \"near\" must be less than \"far\"");
    refuse("{\"camera\": {\"focal\": 9, \"far\": 2}}", " camera.near: missing");
    refuse("{\"camera\": {\"focal\": 9, \"near\": 1, \"far\": 2, \"look_at\": [0, 0, 0]}}",
           " camera.look_at: the camera must not be there, nor look along \"up\"");
    refuse("{\"camera\": {\"type\": \"orthographic\", \"fov\": 40, \"near\": 1, \"far\": 2}}",
           " camera.fov: not for an orthographic camera");
    refuse("{\"camera\": {\"focal\": 9, \"near\": 1, \"far\": 2, \"size\": [2049, 1]}}",
           " camera.size[0]: 2049 is outside 1 .. 2048");
    refuse("{\"camera\": {\"focal\": 9, \"near\": 1, \"far\": 2, \"transform\": [{\"scale\": 2}]}}",
           " camera.transform: a camera cannot be scaled");
}

static void a_mesh_without_area_is_refused(void **state)
{
    (void)state;
    refuse("{" CAM "\"meshes\": {\"m\": {\"shape\": \"revolution\", \"profile\": [[0, 0], [0, 1]]}}, "
           "\"objects\": [{\"mesh\": \"m\"}]}",
           " mesh \"m\" has no triangle with an area");
}

/* Parses a text that must be good; its model is the caller's. */
static struct model parse(const char *text)
{
    struct case_file file;
    struct model model;
    case_write(&file, "s.json", text, strlen(text));
    assert_int_equal(reader_load(file.path, &model), 0);
    case_remove(&file);
    return model;
}

static void assert_near(const double *got, double x, double y, double z)
{
    if (fabs(got[0] - x) > 1e-12 || fabs(got[1] - y) > 1e-12 || fabs(got[2] - z) > 1e-12)
        fail_msg("(%g, %g, %g), not (%g, %g, %g)", got[0], got[1], got[2], x, y, z);
}

static void steps_are_applied_in_their_order(void **state)
{
    (void)state;
    struct model m = parse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\", \"transform\": [{\"move\": [1, 0, 0]}, "
                           "{\"rotate\": [\"z\", 90]}, {\"scale\": 2}, {\"rotate\": [[1, 0, 0], 1.5707963267948966, "
                           "\"rad\"]}, {\"move\": [0, 0, 1]}]}]}");
    const struct model_pose *pose = &m.objects[0].pose;
    double x[3] = {1, 0, 0};
    assert_near(pose->position, 0, 0, 3); /* x to y, twice as far, y to z, one more */
    vec_quat_rotate(pose->rotation, x, x);
    assert_near(x, 0, 0, 1);
    assert_true(pose->scale == 2);
    model_free(&m);
}

static void a_camera_looks_at_its_target(void **state)
{
    (void)state;
    struct model m =
        parse("{\"camera\": {\"fov\": 90, \"size\": [200, 100], \"near\": 1, \"far\": 9, \"position\": [3, "
              "0, 0], \"look_at\": [1, 0, 0]}}");
    double ahead[3] = {-1, 0, 0}, up[3] = {0, 1, 0};
    vec_quat_rotate(m.camera.rotation, ahead, ahead);
    vec_quat_rotate(m.camera.rotation, up, up);
    assert_near(ahead, 0, 0, -1);
    assert_near(up, 0, 1, 0);
    assert_true(fabs(m.camera.focal - 50) < 1e-12);
    model_free(&m);
}

static void a_camera_can_be_placed_by_steps(void **state)
{
    (void)state;
    struct model m =
        parse("{\"camera\": {\"focal\": 90, \"near\": 1, \"far\": 9, \"transform\": [{\"move\": [0, 0, 5]}, "
              "{\"rotate\": [\"y\", 90]}]}}");
    double ahead[3] = {-1, 0, 0};
    assert_near(m.camera.position, 5, 0, 0);
    vec_quat_rotate(m.camera.rotation, ahead, ahead);
    assert_near(ahead, 0, 0, -1);
    model_free(&m);
}

static void keys_follow_the_objects_own_steps(void **state)
{
    (void)state;
    struct model m = parse("{" CAM MESH "\"objects\": [{\"mesh\": \"m\", \"transform\": [{\"move\": [1, 0, 0]}], "
                           "\"keys\": [{\"time\": 0}, {\"time\": 0.5, \"transform\": [{\"rotate\": [\"z\", 90]}]}]}]}");
    assert_int_equal(m.key_count, 2);
    assert_int_equal(m.keys[1].time_ms, 500);
    assert_near(m.keys[0].pose.position, 1, 0, 0);
    assert_near(m.keys[1].pose.position, 0, 1, 0);
    model_free(&m);
}

static void keys_turn_the_short_way(void **state)
{
    (void)state;
    struct pack_result r = case_scene(MESH "\"objects\": [{\"mesh\": \"m\", \"keys\": [{\"time\": 0, \"transform\": "
                                           "[{\"rotate\": [\"z\", 10]}]}, {\"time\": 1, \"transform\": [{\"rotate\": "
                                           "[\"z\", 350]}]}]}]");
    const struct scene_key *key = scene_keys(r.scene);
    int64_t dot = 0;
    for (int k = 0; k < 4; k++)
        dot += (int64_t)key[0].rotation[k] * key[1].rotation[k];
    assert_true(dot > 0);
    pack_free(&r);
}

static void model_files_are_found_beside_the_scene(void **state)
{
    (void)state;
    static const char obj[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    static const char text[] = "{" CASE_CAMERA ", \"meshes\": {\"m\": {\"file\": \"t.obj\", \"fit\": true}}, "
                               "\"objects\": [{\"mesh\": \"m\"}]}";
    struct case_file model;
    struct pack_result r;
    char path[80], said[256];
    case_write(&model, "t.obj", obj, strlen(obj));
    snprintf(path, sizeof path, "%s/s.json", model.folder);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(text, out);
    fclose(out);
    int code = case_load_path(path, NULL, &r, said, sizeof said);
    unlink(path);
    case_remove(&model);
    assert_int_equal(code, 0);
    assert_int_equal(scene_meshes(r.scene)->triangle_count, 4);
    assert_int_equal(r.report->meshes[0].normals, MODEL_NORMALS_SMOOTHED);
    assert_int_equal(scene_meshes(r.scene)->vertex_count, 12); /* all its edges are sharper than the crease */
    assert_true(abs(scene_meshes(r.scene)->radius - 65536) < 8);
    pack_free(&r);
}

static void a_model_that_is_missing_is_named(void **state)
{
    (void)state;
    struct pack_result r;
    char said[256];
    int code = case_load("s.json", "{" CASE_CAMERA ", \"meshes\": {\"m\": {\"file\": \"/no/such.obj\"}}}", &r, said,
                         sizeof said);
    assert_int_equal(code, 3);
    assert_string_equal(said, "/no/such.obj: No such file or directory\n");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(syntax_errors_name_the_line),
        cmocka_unit_test(structure_errors_name_the_place),
        cmocka_unit_test(a_fog_is_read_or_refused),
        cmocka_unit_test(numbers_out_of_range_are_refused),
        cmocka_unit_test(bad_triangles_are_refused),
        cmocka_unit_test(bad_patches_are_refused),
        cmocka_unit_test(triangles_without_normals_get_them_from_their_faces),
        cmocka_unit_test(cameras_that_see_nothing_are_refused),
        cmocka_unit_test(a_mesh_without_area_is_refused),
        cmocka_unit_test(steps_are_applied_in_their_order),
        cmocka_unit_test(a_camera_looks_at_its_target),
        cmocka_unit_test(a_camera_can_be_placed_by_steps),
        cmocka_unit_test(keys_follow_the_objects_own_steps),
        cmocka_unit_test(keys_turn_the_short_way),
        cmocka_unit_test(model_files_are_found_beside_the_scene),
        cmocka_unit_test(a_model_that_is_missing_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Configurations, and stores that are full. */
#include "geometry/object.h"
#include "list.h"
#include "pack/pack.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"

static struct pack_result tiny, torus, clipped;

static int load(void **state)
{
    (void)state;
    return pack_load("tests/scenes/tiny.json", NULL, &tiny) || pack_load("tests/scenes/torus288.json", NULL, &torus) ||
           pack_load("tests/golden/clip.json", NULL, &clipped);
}

static int unload(void **state)
{
    (void)state;
    pack_free(&tiny);
    pack_free(&torus);
    pack_free(&clipped);
    return 0;
}

static void *copy_of(const struct pack_result *scene)
{
    void *copy = malloc(scene->size);
    assert_non_null(copy);
    return memcpy(copy, scene->scene, scene->size);
}

static void a_byte_less_than_needed_is_refused(void **state)
{
    (void)state;
    static const uint16_t sizes[][3] = {{1, 1, 1}, {3, 5, 2}, {33, 7, 7}, {320, 240, 240}, {2048, 1, 1}, {1, 2048, 9}};
    for (unsigned i = 0; i < 6 * 8; i++) {
        struct frame_case f =
            frame_case_small(sizes[i / 8][0], sizes[i / 8][1], (enum glint_format)(i % GLINT_FORMATS));
        f.config.band_rows = sizes[i / 8][2];
        f.config.max_vertices = (uint16_t)(7 * i);
        f.config.max_triangles = (uint16_t)(5 * i + 1);
        f.config.max_clipped = (uint16_t)(3 * i);
        f.config.max_objects = (uint8_t)i;
        f.config.max_lights = (uint8_t)(i % 9);
        f.config.tables = i % 3 == 0;
        frame_case_open(&f); /* takes exactly what is needed */
        struct glint_config config = f.config;
        struct glint_frame frame;
        config.memory_bytes--;
        assert_int_equal(glint_init(&frame, &config), GLINT_E_MEMORY);
        config = f.config;
        config.memory = (uint8_t *)f.config.memory + 1;
        assert_int_equal(glint_init(&frame, &config), GLINT_E_MEMORY);
        config.memory = NULL;
        assert_int_equal(glint_init(&frame, &config), GLINT_E_MEMORY);
        frame_case_close(&f);
    }
}

static void refuse(const struct glint_config *config)
{
    struct glint_frame frame;
    assert_int_equal(glint_memory_needed(config), 0);
    assert_int_equal(glint_init(&frame, config), GLINT_E_ARGUMENT);
}

#define REFUSE(member, value)                 \
    do {                                      \
        struct glint_config wrong = f.config; \
        wrong.member = (value);               \
        refuse(&wrong);                       \
    } while (0)

static void configurations_that_make_no_sense_are_refused(void **state)
{
    (void)state;
    struct frame_case f = frame_case_small(32, 24, GLINT_RGB565);
    struct glint_frame frame;
    struct glint_band band;
    frame_case_open_for(&f, tiny.scene);
    REFUSE(width, 0);
    REFUSE(width, 2049);
    REFUSE(height, 0);
    REFUSE(height, 2049);
    REFUSE(band_rows, 0);
    REFUSE(band_rows, 25);
    REFUSE(format, GLINT_FORMATS);
    REFUSE(method, NULL);
    REFUSE(max_lights, 9);
    assert_int_equal(glint_memory_needed(NULL), 0);
    assert_int_equal(glint_init(NULL, &f.config), GLINT_E_ARGUMENT);
    assert_int_equal(glint_init(&frame, NULL), GLINT_E_ARGUMENT);
    struct glint_config config = f.config;
    config.band[0] = NULL;
    assert_int_equal(glint_init(&frame, &config), GLINT_E_ARGUMENT);
    for (int i = 0; i < 2; i++) {
        config = f.config;
        config.band[i] = (uint8_t *)config.band[i] + 2;
        assert_int_equal(glint_init(&frame, &config), GLINT_E_ARGUMENT);
    }
    assert_int_equal(glint_frame_next_band(&f.frame, &band), GLINT_E_ARGUMENT); /* no frame has begun */
    assert_int_equal(glint_frame_begin(&f.frame, NULL, 0), GLINT_E_ARGUMENT);
    assert_int_equal(glint_frame_begin(NULL, tiny.scene, 0), GLINT_E_ARGUMENT);
    assert_int_equal(glint_frame_begin(&f.frame, tiny.scene, 0), 0);
    assert_int_equal(glint_frame_next_band(NULL, &band), GLINT_E_ARGUMENT);
    assert_int_equal(glint_frame_next_band(&f.frame, NULL), GLINT_E_ARGUMENT);
    frame_case_close(&f);
}

static void a_scene_that_cannot_be_drawn_is_refused(void **state)
{
    (void)state;
    struct frame_case f = frame_case_small(32, 24, GLINT_RGB565);
    glint_fit_stores(&f.config, tiny.scene);
    assert_int_equal(f.config.max_lights, 2);
    f.config.max_lights = 1;
    frame_case_open(&f);
    assert_int_equal(glint_frame_begin(&f.frame, tiny.scene, 0), GLINT_E_SCENE);
    frame_case_close(&f);

    f = frame_case_small(32, 24, GLINT_RGB565);
    frame_case_open_for(&f, tiny.scene);
    struct scene_header *blob = copy_of(&tiny);
    blob->version++;
    assert_int_equal(glint_frame_begin(&f.frame, blob, 0), GLINT_E_SCENE);
    assert_int_equal(glint_scene_check(blob, tiny.size), GLINT_E_SCENE);
    assert_string_equal(glint_scene_problem(blob, tiny.size), scene_fault_text(SCENE_E_VERSION));
    assert_int_equal(glint_scene_check(tiny.scene, tiny.size), 0);
    free(blob);
    frame_case_close(&f);
}

static void a_full_triangle_store_drops_whole_triangles_and_counts_them(void **state)
{
    (void)state;
    struct frame_case whole = frame_case_small(40, 40, GLINT_GREY8);
    struct scene_header *blob = copy_of(&torus);
    struct scene_mesh *mesh = (struct scene_mesh *)((uint8_t *)blob + blob->meshes);
    uint32_t all = mesh->triangle_count, seen = 0;
    frame_case_open_for(&whole, blob);
    for (uint32_t count = 1; count <= all; count++) {
        mesh->triangle_count = count; /* what the store holds when it is full: the first ones */
        frame_case_draw(&whole, blob, 0);
        frame_case_sums(&whole);
        assert_int_equal(whole.frame.stats.dropped, 0);
        if (frame_case_drawn(&whole) == seen)
            continue;
        seen = frame_case_drawn(&whole);
        mesh->triangle_count = all;
        for (uint32_t room = seen - 1; room <= seen; room += seen) { /* and none at all, the first time */
            struct frame_case f = frame_case_small(40, 40, GLINT_GREY8);
            glint_fit_stores(&f.config, blob);
            f.config.max_triangles = (uint16_t)(seen == 1 ? room : seen);
            frame_case_open(&f);
            frame_case_draw(&f, blob, 0);
            frame_case_sums(&f);
            assert_int_equal(frame_case_drawn(&f), f.config.max_triangles);
            if (f.config.max_triangles == seen)
                assert_memory_equal(f.picture, whole.picture, f.picture_bytes);
            frame_case_close(&f);
        }
    }
    assert_true(seen > 100);
    free(blob);
    frame_case_close(&whole);
}

/* Objects in `kept` alone: a bit each. */
static uint8_t *picture_of_some(const struct pack_result *scene, unsigned kept)
{
    struct scene_header *blob = copy_of(scene);
    struct scene_object *object = (struct scene_object *)((uint8_t *)blob + blob->objects);
    unsigned count = 0;
    for (unsigned i = 0; i < blob->object_count; i++)
        if (kept >> i & 1)
            object[count++] = object[i];
    blob->object_count = (uint16_t)count;
    uint8_t *picture = frame_case_picture(frame_case_small(48, 36, GLINT_RGB888), blob, 500, NULL);
    free(blob);
    return picture;
}

static void full_object_and_vertex_stores_drop_whole_objects(void **state)
{
    (void)state;
    const struct scene_header *s = tiny.scene;
    const struct scene_object *object = scene_objects(s);
    const struct scene_mesh *mesh = scene_meshes(s);
    uint32_t first = mesh[object[0].mesh].vertex_count, second = mesh[object[1].mesh].vertex_count;
    assert_true(s->object_count == 2 && first > second);
    const struct {
        uint32_t objects, vertices;
        unsigned kept;
    } cases[] = {{0, 999, 0},
                 {1, 999, 1},
                 {2, 999, 3},
                 {2, 0, 0},
                 {2, second - 1, 0},
                 {2, second, 2},
                 {2, first - 1, 2},
                 {2, first, 1},
                 {2, first + second - 1, 1},
                 {2, first + second, 3},
                 {255, 65535, 3}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct frame_case f = frame_case_small(48, 36, GLINT_RGB888);
        glint_fit_stores(&f.config, s);
        f.config.max_objects = (uint8_t)cases[i].objects;
        f.config.max_vertices = (uint16_t)cases[i].vertices;
        frame_case_open(&f);
        frame_case_draw(&f, s, 500);
        uint32_t dropped = 0;
        for (unsigned k = 0; k < 2; k++)
            dropped += cases[i].kept >> k & 1 ? 0 : mesh[object[k].mesh].triangle_count;
        assert_int_equal(f.frame.stats.dropped, dropped);
        uint8_t *wanted = picture_of_some(&tiny, cases[i].kept);
        assert_memory_equal(f.picture, wanted, f.picture_bytes);
        free(wanted);
        frame_case_close(&f);
    }
}

/* Draws one triangle of a mesh with too little room in either store; returns
 * the pieces that it has. */
static uint32_t check_clipped(const struct scene_header *blob)
{
    struct glint_stats stats;
    free(frame_case_picture(frame_case_small(48, 36, GLINT_RGB888), blob, 0, &stats));
    uint32_t pieces = stats.drawn[GLINT_X];
    if (stats.clipped == 0)
        return 0;
    for (uint32_t room = 0; room < 2 * pieces; room++) {
        struct frame_case f = frame_case_small(48, 36, GLINT_RGB888);
        glint_fit_stores(&f.config, blob);
        f.config.max_clipped = room < pieces ? (uint16_t)room : 8;
        f.config.max_triangles = room < pieces ? 8 : (uint16_t)(room - pieces);
        frame_case_open(&f);
        frame_case_draw(&f, blob, 0);
        assert_true(f.frame.stats.dropped > 0);
        if (frame_case_drawn(&f) != 0)
            fail_msg("%u of %u pieces are drawn with room for %u", frame_case_drawn(&f), pieces, room % pieces);
        frame_case_close(&f);
    }
    return pieces;
}

static void a_clipped_triangle_is_drawn_whole_or_not_at_all(void **state)
{
    (void)state;
    struct scene_header *blob = copy_of(&clipped);
    struct scene_object *object = (struct scene_object *)((uint8_t *)blob + blob->objects);
    unsigned many = 0, objects = blob->object_count;
    blob->object_count = 1;
    for (unsigned i = 0; i < objects; i++) {
        object[0] = object[i];
        struct scene_mesh *mesh = (struct scene_mesh *)((uint8_t *)blob + blob->meshes) + object->mesh, all = *mesh;
        mesh->triangle_count = 1;
        for (uint32_t t = 0; t < all.triangle_count; t++) {
            mesh->triangles = all.triangles + t * (uint32_t)sizeof(struct scene_triangle);
            many += check_clipped(blob) > 1;
        }
        *mesh = all;
    }
    assert_true(many > 0);
    free(blob);
}

static void stores_of_any_size_are_never_overrun(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 600; i++) {
        struct frame_case f = frame_case_small(40, 30, (enum glint_format)(i % GLINT_FORMATS));
        glint_fit_stores(&f.config, clipped.scene);
        f.config.band_rows = (uint16_t)(1 + i % 30);
        f.config.max_vertices = (uint16_t)(i & 4 ? f.config.max_vertices : i);
        f.config.max_triangles = (uint16_t)(i & 8 ? i / 16 : f.config.max_triangles);
        f.config.max_clipped = (uint16_t)(i & 16 ? i / 32 : f.config.max_clipped);
        f.config.max_objects = (uint8_t)(i & 32 ? i / 64 : f.config.max_objects);
        f.config.method = glint_choices[i / 3 % glint_choice_count].method;
        frame_case_open(&f);
        frame_case_draw(&f, clipped.scene, 40 * i);
        frame_case_close(&f);
    }
}

/* All vertices moved after their triangles were listed: as they are, between
 * two rows of centres, onto a line, mirrored. */
static void what_is_listed_and_has_no_row_or_area_is_not_drawn(void **state)
{
    (void)state;
    for (int way = 0; way < 4; way++) {
        struct frame_case f = frame_case_small(40, 30, GLINT_GREY8);
        f.config.method = &glint_flat;
        frame_case_open_for(&f, tiny.scene);
        assert_int_equal(glint_frame_begin(&f.frame, tiny.scene, 0), 0);
        for (unsigned v = 0; v < f.frame.vertex_count; v++) {
            int16_t *record = list_record(&f.frame, v);
            record[VERTEX_Y] = way == 1 ? record[VERTEX_Y] % 7 : way == 2 ? record[VERTEX_X] : record[VERTEX_Y];
            record[VERTEX_X] = (int16_t)(way == 3 ? -record[VERTEX_X] : record[VERTEX_X]);
        }
        while (frame_case_band(&f))
            ;
        frame_case_guards(&f);
        size_t drawn = 0;
        for (size_t i = 0; i < f.picture_bytes; i++)
            drawn += f.picture[i] != f.picture[0];
        assert_true(f.frame.triangle_count > 50);
        assert_int_equal(f.frame.stats.setups, f.frame.triangle_count);
        assert_int_equal(frame_case_drawn(&f), way ? 0 : f.frame.triangle_count);
        assert_int_equal(drawn > 0, way == 0);
        frame_case_close(&f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_byte_less_than_needed_is_refused),
        cmocka_unit_test(configurations_that_make_no_sense_are_refused),
        cmocka_unit_test(a_scene_that_cannot_be_drawn_is_refused),
        cmocka_unit_test(a_full_triangle_store_drops_whole_triangles_and_counts_them),
        cmocka_unit_test(full_object_and_vertex_stores_drop_whole_objects),
        cmocka_unit_test(a_clipped_triangle_is_drawn_whole_or_not_at_all),
        cmocka_unit_test(stores_of_any_size_are_never_overrun),
        cmocka_unit_test(what_is_listed_and_has_no_row_or_area_is_not_drawn),
    };
    return cmocka_run_group_tests(tests, load, unload);
}

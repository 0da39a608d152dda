/* SPDX-License-Identifier: MIT */
/* Memory, stores and stacks of every size, for every method: refused, or drawn, or dropped and counted; never a byte
 * beside what was given (sentinels around each block). */
#include "glint.h"
#include "pack/pack.h"
#include "raster/raster.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/unit/frame_case.h"
#include "tests/unit/random.h"

#define WIDTH  40
#define HEIGHT 30

static struct pack_result clipped, several; /* cut by planes and guard band; of several objects, materials and lights */

static int load(void **state)
{
    const struct pack_options options = {.shininess = 0};
    (void)state;
    assert_int_equal(pack_load("tests/golden/clip.json", &options, &clipped), PACK_OK);
    assert_int_equal(pack_load("tests/golden/materials.json", &options, &several), PACK_OK);
    return 0;
}

static int unload(void **state)
{
    (void)state;
    pack_free(&clipped);
    pack_free(&several);
    return 0;
}

static struct frame_case case_of(const struct pack_result *scene, unsigned method, enum glint_format format)
{
    struct frame_case f = frame_case_small(WIDTH, HEIGHT, format);
    glint_fit_stores(&f.config, scene->scene);
    f.config.method = glint_choices[method % glint_choice_count].method;
    return f;
}

/* Of blocks from nothing to a few words more than is needed, every 4 bytes: too small is an error and leaves the block
 * alone, enough draws the one picture. */
static void memory_of_any_size_is_refused_or_enough(void **state)
{
    (void)state;
    for (unsigned m = 0; m < glint_choice_count; m++) {
        struct frame_case f = case_of(&clipped, m, (enum glint_format)(m % GLINT_FORMATS));
        f.config.max_clipped = 40;
        f.config.max_triangles = 100;
        frame_case_open(&f);
        frame_case_draw(&f, clipped.scene, 0);
        const size_t needed = f.config.memory_bytes;
        uint8_t *const whole = f.picture;
        struct frame_case other = f;
        memset(other.block, 0, sizeof other.block);
        other.config.memory = frame_case_block(&other, 0, needed + 16);
        other.picture = malloc(f.picture_bytes);
        for (size_t bytes = 0; bytes <= needed + 16; bytes += 4) {
            other.config.memory_bytes = bytes;
            const int answer = glint_init(&other.frame, &other.config);
            assert_int_equal(answer, bytes < needed ? GLINT_E_MEMORY : 0);
            if (bytes < needed)
                continue;
            frame_case_draw(&other, clipped.scene, 0);
            assert_memory_equal(other.picture, whole, f.picture_bytes);
        }
        for (int off = 1; off < 3; off++) { /* not where a pointer may stand */
            other.config.memory = other.block[0] + FRAME_SENTINELS + off;
            other.config.memory_bytes = needed;
            assert_int_equal(glint_init(&other.frame, &other.config), GLINT_E_MEMORY);
        }
        frame_case_guards(&f);
        frame_case_close(&other);
        frame_case_close(&f);
    }
}

static void a_workers_memory_of_any_size_is_refused_or_enough(void **state)
{
    (void)state;
    for (unsigned m = 0; m < glint_choice_count; m++) {
        struct frame_case f = case_of(&clipped, m, GLINT_RGB565);
        f.config.band_rows = HEIGHT / 2;
        frame_case_open(&f);
        frame_case_draw(&f, clipped.scene, 0);
        const size_t needed = glint_worker_memory_needed(&f.config);
        uint8_t *block = malloc(needed + 2 * FRAME_SENTINELS), *memory = block + FRAME_SENTINELS;
        memset(block, 0xA5, needed + 2 * FRAME_SENTINELS);
        struct glint_frame worker;
        for (size_t bytes = 0; bytes < needed; bytes += 4)
            assert_int_equal(glint_worker_init(&worker, &f.frame, memory, bytes), GLINT_E_MEMORY);
        assert_int_equal(glint_worker_init(&worker, &f.frame, memory, needed), 0);
        assert_int_equal(glint_frame_begin(&f.frame, clipped.scene, 0), 0);
        glint_worker_begin(&worker, &f.frame);
        struct glint_band band;
        for (unsigned i = 0; i < 2; i++) {
            assert_int_equal(glint_frame_band(&worker, i, f.config.band[0], &band), 1);
            assert_memory_equal(f.config.band[0], f.picture + i * f.picture_bytes / 2, f.picture_bytes / 2);
        }
        assert_int_equal(glint_frame_band(&worker, 2, f.config.band[0], &band), 0);
        assert_int_equal(glint_frame_band(&worker, UINT32_MAX, f.config.band[0], &band), 0);
        for (size_t i = 0; i < FRAME_SENTINELS; i++)
            assert_true(block[i] == 0xA5 && memory[needed + i] == 0xA5);
        free(block);
        frame_case_guards(&f);
        frame_case_close(&f);
    }
}

/* Each store with room for 0, 1, 2, ... things, all others as they should be, by each method in turn. */
static void every_store_may_be_full_at_any_count(void **state)
{
    struct frame_case fit = case_of(&clipped, 0, GLINT_GREY8);
    const unsigned most[] = {fit.config.max_vertices, 120, 120, fit.config.max_objects, 255};
    unsigned long dropped = 0, frames = 0;
    (void)state;
    for (unsigned store = 0; store < 5; store++)
        for (unsigned room = 0; room <= most[store]; room++)
            for (unsigned m = room; m < room + (room < 4 ? glint_choice_count : 2); m++) {
                struct frame_case f = case_of(&clipped, m, (enum glint_format)(m / 3 % GLINT_FORMATS));
                f.config.max_vertices = (uint16_t)(store == 0 ? room : f.config.max_vertices);
                f.config.max_triangles = (uint16_t)(store == 1 ? room : f.config.max_triangles);
                f.config.max_clipped = (uint16_t)(store == 2 ? room : f.config.max_clipped);
                f.config.max_objects = (uint8_t)(store == 3 ? room : f.config.max_objects);
                f.config.tables = (uint8_t)(store == 4 && room < 6 ? room : 0);
                f.config.band_rows = (uint16_t)(1 + room % HEIGHT);
                if (store == 4 && room >= 6)
                    continue;
                frame_case_open(&f);
                frame_case_draw(&f, clipped.scene, 0);
                dropped += f.frame.stats.dropped;
                assert_true(frame_case_drawn(&f) <= f.config.max_triangles);
                assert_true(f.frame.triangle_count <= f.config.max_triangles);
                assert_true(f.frame.clipped_count <= f.config.max_clipped);
                assert_true(f.frame.vertex_count <= f.config.max_vertices);
                if (store != 4 && room == 0 && store != 2)
                    assert_int_equal(frame_case_drawn(&f), 0);
                frames++;
                frame_case_close(&f);
            }
    print_message("%lu pictures, %lu triangles dropped\n", frames, dropped);
    assert_true(dropped > 10000);
}

/* Without clipping every triangle is counted once, whatever there is room for. */
static void what_is_dropped_is_counted_once(void **state)
{
    (void)state;
    const struct scene_header *scene = several.scene;
    struct frame_case fit = case_of(&several, 0, GLINT_GREY8);
    for (unsigned room = 0; room <= fit.config.max_triangles + 1u; room++) {
        struct frame_case f = case_of(&several, room, GLINT_RGB888);
        f.config.max_triangles = (uint16_t)room;
        frame_case_open(&f);
        frame_case_draw(&f, scene, 0);
        frame_case_sums(&f);
        assert_true(frame_case_drawn(&f) == room || f.frame.stats.dropped == 0);
        frame_case_close(&f);
    }
}

/* Any bytes for a configuration: not taken, and then needs no memory; or taken with what it says it needs. */
static void any_configuration_is_refused_or_drawn(void **state)
{
    static const uint16_t sizes[] = {0, 1, 2, 15, 16, 17, 2047, 2048, 2049, 65535};
    long taken = 0, refused = 0;
    (void)state;
    random_seed(9);
    for (int i = 0; i < 6000; i++) {
        struct glint_config c = {0};
        struct frame_case f;
        memset(&f, 0, sizeof f);
        c.width = sizes[random_between(0, 9)];
        c.height = sizes[random_between(0, random_between(0, 9) ? 5 : 9)];
        c.band_rows = random_between(0, 3) ? (uint16_t)random_between(0, c.height) : sizes[random_between(0, 9)];
        c.format = (uint8_t)(random_between(0, 4) ? random_between(0, 3) : random_between(4, 255));
        c.flags = (uint8_t)random_bits();
        c.method = random_between(0, 19) ? glint_choices[random_bits() % glint_choice_count].method : NULL;
        c.texture = (uint8_t)random_bits();
        c.max_vertices = (uint16_t)(random_bits() >> random_between(16, 31));
        c.max_triangles = (uint16_t)(random_bits() >> random_between(16, 31));
        c.max_clipped = (uint16_t)(random_bits() >> random_between(16, 31));
        c.max_objects = (uint8_t)(random_bits() >> random_between(24, 31));
        c.max_lights = (uint8_t)(random_between(0, 9) ? random_between(0, 8) : random_between(9, 255));
        c.tables = (uint8_t)(random_bits() >> random_between(26, 31));
        c.budget = (uint16_t)(random_between(0, 1) ? random_bits() : random_bits() >> 31);
        c.subdivide_area = (uint16_t)random_bits();
        c.subdivide_threshold = (uint8_t)random_bits();
        c.subdivide_tolerance = (uint8_t)random_bits();
        const size_t needed = glint_memory_needed(&c);
        if (!needed) {
            uint32_t word[2] = {0, 0};
            c.band[0] = word;
            c.memory = word;
            c.memory_bytes = SIZE_MAX;
            assert_int_equal(glint_init(&f.frame, &c), GLINT_E_ARGUMENT);
            assert_true(glint_worker_memory_needed(&c) == 0);
            refused++;
            continue;
        }
        f.config = c;
        frame_case_open(&f);
        glint_turn(&f.frame, (uint16_t)random_bits(), (uint16_t)random_bits());
        if (c.max_lights >= clipped.scene->light_count) {
            static const uint32_t times[] = {0, 1, INT32_MAX, UINT32_C(1) << 31, UINT32_MAX};
            frame_case_draw(&f, clipped.scene, times[random_between(0, 4)]);
            taken++;
        } else {
            assert_int_equal(glint_frame_begin(&f.frame, clipped.scene, 0), GLINT_E_SCENE);
        }
        frame_case_guards(&f);
        frame_case_close(&f);
    }
    print_message("%ld drawn, %ld refused\n", taken, refused);
    assert_true(taken > 1000 && refused > 1000);
}

/* The parts of a triangle as wide as there are: split to the last level, by each method that splits, in one piece and
 * row by row. */
static void subdivision_to_its_last_level_stays_within_its_stack(void **state)
{
    (void)state;
    struct pack_result demo;
    const struct pack_options options = {.shininess = 200};
    assert_int_equal(pack_load("tests/scenes/two-sided-bowl.json", &options, &demo), PACK_OK);
    for (unsigned m = 0; m < glint_choice_count; m++) {
        if (strncmp(glint_choices[m].name, "subdivide", 9) != 0)
            continue;
        struct frame_case f = frame_case_small(2048, 1024, GLINT_GREY8);
        f.config.method = glint_choices[m].method;
        f.config.subdivide_area = 1;
        f.config.subdivide_tolerance = 1;
        f.config.subdivide_threshold = 1;
        uint8_t *whole = frame_case_picture(f, demo.scene, 0, NULL);
        frame_case_same(&f, whole, demo.scene, 64, 0, glint_choices[m].name);
        free(whole);
    }
    pack_free(&demo);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_of_any_size_is_refused_or_enough),
        cmocka_unit_test(a_workers_memory_of_any_size_is_refused_or_enough),
        cmocka_unit_test(every_store_may_be_full_at_any_count),
        cmocka_unit_test(what_is_dropped_is_counted_once),
        cmocka_unit_test(any_configuration_is_refused_or_drawn),
        cmocka_unit_test(subdivision_to_its_last_level_stays_within_its_stack),
    };
    return cmocka_run_group_tests(tests, load, unload);
}

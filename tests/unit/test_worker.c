/* SPDX-License-Identifier: MIT */
/* One picture by several: the same bits, whoever draws what and when. */
#include "pack/pack.h"

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "random.h"

#define MOST_WORKERS 4

static struct pack_result materials, clipped, torus;

static int load(void **state)
{
    (void)state;
    return pack_load("tests/golden/materials.json", NULL, &materials) ||
           pack_load("tests/golden/clip.json", NULL, &clipped) || pack_load("tests/scenes/torus288.json", NULL, &torus);
}

static int unload(void **state)
{
    (void)state;
    pack_free(&materials);
    pack_free(&clipped);
    pack_free(&torus);
    return 0;
}

/* A frame with workers, each in memory of exactly the size it asks for. */
struct team {
    struct frame_case frame;
    struct glint_frame worker[MOST_WORKERS];
    void *memory[MOST_WORKERS];
    unsigned count, bands;
    uint8_t *bytes; /* of all bands, one after the other */
    size_t band_bytes;
    atomic_uint next;
};

static struct glint_frame *member(struct team *team, unsigned i)
{
    return i ? &team->worker[i] : &team->frame.frame;
}

static void team_open(struct team *team, struct frame_case frame, const void *scene, unsigned count)
{
    *team = (struct team){.frame = frame, .count = count};
    frame_case_open_for(&team->frame, scene);
    const struct glint_config *c = &team->frame.config;
    size_t bytes = glint_worker_memory_needed(c);
    assert_true(bytes > 0);
    for (unsigned i = 1; i < count; i++) {
        team->memory[i] = malloc(bytes);
        assert_non_null(team->memory[i]);
        assert_int_equal(glint_worker_init(&team->worker[i], &team->frame.frame, team->memory[i], bytes - 1),
                         GLINT_E_MEMORY);
        assert_int_equal(glint_worker_init(&team->worker[i], &team->frame.frame, team->memory[i], bytes), 0);
    }
    team->bands = (c->height + c->band_rows - 1u) / c->band_rows;
    team->band_bytes = glint_band_bytes(c);
    team->bytes = malloc(team->band_bytes * team->bands);
    assert_non_null(team->bytes);
}

static void team_close(struct team *team)
{
    for (unsigned i = 1; i < team->count; i++)
        free(team->memory[i]);
    free(team->bytes);
    frame_case_close(&team->frame);
}

static void team_begin(struct team *team, const void *scene)
{
    memset(team->bytes, 0x5A, team->band_bytes * team->bands);
    assert_int_equal(glint_frame_begin(&team->frame.frame, scene, 0), 0);
    for (unsigned i = 1; i < team->count; i++)
        glint_worker_begin(&team->worker[i], &team->frame.frame);
    atomic_store(&team->next, 0);
}

/* Draws a band: 1, or 0 where there is none. */
static int draw(struct team *team, unsigned i, unsigned band)
{
    struct glint_band drawn;
    uint8_t *pixels = team->bytes + team->band_bytes * (band < team->bands ? band : 0);
    int more = glint_frame_band(member(team, i), band, pixels, &drawn);
    return more == 1 && drawn.pixels == pixels && drawn.y == band * team->frame.config.band_rows;
}

/* All bands are there, and the counts are those of one alone. */
static void team_check(struct team *team, const uint8_t *picture, const struct glint_stats *alone)
{
    struct glint_frame *frame = &team->frame.frame;
    const struct glint_config *c = &team->frame.config;
    size_t row_bytes = glint_row_bytes(c);
    for (unsigned i = 1; i < team->count; i++)
        glint_worker_end(&team->worker[i], frame);
    for (unsigned y = 0; y < c->height; y++) {
        const uint8_t *row = team->bytes + team->band_bytes * (y / c->band_rows) + row_bytes * (y % c->band_rows);
        assert_memory_equal(row, picture + y * row_bytes, row_bytes);
    }
    assert_memory_equal(&frame->stats, alone, sizeof *alone);
    frame_case_guards(&team->frame);
}

static struct frame_case small(const struct glint_method *method, unsigned band_rows)
{
    struct frame_case f = frame_case_small(64, 60, GLINT_RGB565);
    f.config.method = method;
    f.config.band_rows = (uint16_t)band_rows;
    f.config.tables = 2; /* of the scenes' materials, some have one and some have none */
    return f;
}

static void every_division_among_two_gives_the_same_bits(void **state)
{
    (void)state;
    struct glint_stats alone;
    struct frame_case f = small(&glint_x, 10);
    uint8_t *picture = frame_case_picture(f, materials.scene, 0, &alone);
    struct team team;
    team_open(&team, f, materials.scene, 2);
    for (unsigned division = 0; division < 1u << team.bands; division++) {
        team_begin(&team, materials.scene);
        for (unsigned band = 0; band < team.bands; band++)
            assert_true(draw(&team, division >> band & 1, band));
        team_check(&team, picture, &alone);
    }
    team_close(&team);
    free(picture);
}

static void bands_in_any_order_give_the_same_bits(void **state)
{
    (void)state;
    struct glint_stats alone;
    struct frame_case f = small(&glint_gouraud, 7);
    uint8_t *picture = frame_case_picture(f, clipped.scene, 0, &alone);
    struct team team;
    random_seed(1);
    team_open(&team, f, clipped.scene, 3);
    for (int pass = 0; pass < 200; pass++) {
        unsigned order[16];
        team_begin(&team, clipped.scene);
        for (unsigned i = 0; i < team.bands; i++) {
            unsigned j = (unsigned)random_between(0, (int32_t)i);
            order[i] = order[j];
            order[j] = i;
        }
        for (unsigned i = 0; i < team.bands; i++)
            assert_true(draw(&team, (unsigned)random_between(0, 2), order[i]));
        assert_false(draw(&team, 0, team.bands));
        team_check(&team, picture, &alone);
    }
    team_close(&team);
    free(picture);
}

struct thread {
    struct team *team;
    unsigned index;
};

/* Takes the next band as long as there is one. */
static void *work(void *argument)
{
    struct thread *thread = argument;
    while (draw(thread->team, thread->index, atomic_fetch_add(&thread->team->next, 1)))
        ;
    return NULL;
}

static void by_threads(const struct glint_method *method, unsigned band_rows, const void *scene, unsigned count)
{
    struct glint_stats alone;
    struct frame_case f = small(method, band_rows);
    uint8_t *picture = frame_case_picture(f, scene, 0, &alone);
    struct team team;
    team_open(&team, f, scene, count);
    for (int pass = 0; pass < 3; pass++) {
        pthread_t id[MOST_WORKERS];
        struct thread thread[MOST_WORKERS];
        team_begin(&team, scene);
        for (unsigned i = 0; i < count; i++) {
            thread[i] = (struct thread){&team, i};
            assert_int_equal(pthread_create(&id[i], NULL, work, &thread[i]), 0);
        }
        for (unsigned i = 0; i < count; i++)
            assert_int_equal(pthread_join(id[i], NULL), 0);
        team_check(&team, picture, &alone);
    }
    team_close(&team);
    free(picture);
}

static void threads_draw_what_one_draws_by_every_method(void **state)
{
    (void)state;
    const void *scenes[] = {materials.scene, clipped.scene, torus.scene};
    for (unsigned i = 0; i < glint_choice_count; i++)
        for (unsigned s = 0; s < 3; s++)
            by_threads(glint_choices[i].method, 1 + (i + 3 * s) % 9, scenes[s], 2 + (i + s) % (MOST_WORKERS - 1));
}

static void a_worker_needs_a_frame_and_memory(void **state)
{
    (void)state;
    struct frame_case f = small(&glint_x, 10);
    struct glint_frame worker;
    struct glint_band band;
    uint32_t pixels[64 * 10];
    frame_case_open_for(&f, torus.scene);
    size_t bytes = glint_worker_memory_needed(&f.config);
    uint8_t *memory = malloc(bytes + 1);
    assert_int_equal(glint_worker_memory_needed(NULL), 0);
    assert_int_equal(glint_worker_init(NULL, &f.frame, memory, bytes), GLINT_E_ARGUMENT);
    assert_int_equal(glint_worker_init(&worker, NULL, memory, bytes), GLINT_E_ARGUMENT);
    assert_int_equal(glint_worker_init(&worker, &f.frame, NULL, bytes), GLINT_E_MEMORY);
    assert_int_equal(glint_worker_init(&worker, &f.frame, memory + 1, bytes), GLINT_E_MEMORY);
    assert_int_equal(glint_worker_init(&worker, &f.frame, memory, bytes), 0);
    assert_int_equal(glint_frame_band(&worker, 0, pixels, &band), GLINT_E_ARGUMENT); /* no picture has begun */
    assert_int_equal(glint_frame_begin(&f.frame, torus.scene, 0), 0);
    glint_worker_begin(&worker, &f.frame);
    assert_int_equal(glint_frame_band(NULL, 0, pixels, &band), GLINT_E_ARGUMENT);
    assert_int_equal(glint_frame_band(&worker, 0, NULL, &band), GLINT_E_ARGUMENT);
    assert_int_equal(glint_frame_band(&worker, 0, (uint8_t *)pixels + 2, &band), GLINT_E_ARGUMENT);
    assert_int_equal(glint_frame_band(&worker, 0, pixels, &band), 1);
    free(memory);
    frame_case_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_division_among_two_gives_the_same_bits),
        cmocka_unit_test(bands_in_any_order_give_the_same_bits),
        cmocka_unit_test(threads_draw_what_one_draws_by_every_method),
        cmocka_unit_test(a_worker_needs_a_frame_and_memory),
    };
    return cmocka_run_group_tests(tests, load, unload);
}

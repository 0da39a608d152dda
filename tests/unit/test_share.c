/* SPDX-License-Identifier: MIT */
/* The handheld's pictures by one CPU and by two, here threads: what the display gets, and when. */
#include "pack/pack.h"

#include <pthread.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#include <cmocka.h>

#include "app/share.c" /* not in the tools' library */

#include "frame_case.h"

#define WIDTH    64u
#define HEIGHT   60u
#define PICTURES 5u

static struct pack_result scene;

uint32_t clock_us(void)
{
    return 0;
}

static int load(void **state)
{
    (void)state;
    return pack_load("tests/scenes/torus288.json", NULL, &scene);
}

static int unload(void **state)
{
    (void)state;
    pack_free(&scene);
    return 0;
}

/* A second CPU that is a thread. It sleeps in pause() and ends there when it is told to. */
static pthread_mutex_t lock[HAL_LOCKS] = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_MUTEX_INITIALIZER};
static pthread_mutex_t event_lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t event = PTHREAD_COND_INITIALIZER;
static uint32_t events, ending;
static pthread_t second;
static void (*second_job)(void *);

static void *second_main(void *argument)
{
    second_job(argument);
    return NULL;
}

static void core_start(void (*job)(void *), void *argument)
{
    second_job = job;
    ending = 0;
    assert_int_equal(pthread_create(&second, NULL, second_main, argument), 0);
}

/* So many claims are refused, as if the other had the lock, who then lets it go. */
static atomic_uint refused[HAL_LOCKS];
static void core_notify(void);

static int core_claim(enum hal_lock which)
{
    unsigned left = atomic_load(&refused[which]);
    if (left && atomic_compare_exchange_strong(&refused[which], &left, left - 1)) {
        core_notify();
        return 0;
    }
    return pthread_mutex_trylock(&lock[which]) == 0;
}

static void core_release(enum hal_lock which)
{
    pthread_mutex_unlock(&lock[which]);
}

/* As an event register: what happened since the last pause() ends this one at once. */
static void core_pause(void)
{
    static _Thread_local uint32_t seen;
    pthread_mutex_lock(&event_lock);
    while (seen == events && !ending)
        pthread_cond_wait(&event, &event_lock);
    seen = events;
    int end = ending && pthread_equal(pthread_self(), second);
    pthread_mutex_unlock(&event_lock);
    if (end)
        pthread_exit(NULL);
}

static void core_notify(void)
{
    pthread_mutex_lock(&event_lock);
    events++;
    pthread_cond_broadcast(&event);
    pthread_mutex_unlock(&event_lock);
}

static void core_end(void)
{
    pthread_mutex_lock(&event_lock);
    ending = 1;
    pthread_cond_broadcast(&event);
    pthread_mutex_unlock(&event_lock);
    pthread_join(second, NULL);
}

static const struct hal_core core = {core_start, core_claim, core_release, core_pause, core_notify};

/* A display that takes a band's pixels as late as it may: when the next call of flush or frame_begin comes. */
struct late_display {
    struct hal_display display;
    const uint8_t *pixels; /* on their way, or null */
    uint32_t y, bytes;
    uint32_t begun, ended, flushed, row;
    uint32_t fails_at; /* the flush that fails; 0: none */
    uint8_t picture[2 * WIDTH * HEIGHT];
    const uint8_t *expected;
};

static void late_take(struct late_display *d)
{
    if (d->pixels)
        memcpy(d->picture + 2 * WIDTH * d->y, d->pixels, d->bytes);
    d->pixels = NULL;
}

static int late_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    struct late_display *d = (struct late_display *)display;
    (void)index, (void)delay_ms;
    late_take(d);
    if (d->begun++)
        assert_memory_equal(d->picture, d->expected, sizeof d->picture);
    assert_int_equal(d->begun, d->ended + 1);
    d->row = 0;
    return 0;
}

static int late_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    struct late_display *d = (struct late_display *)display;
    late_take(d);
    assert_int_equal(y, d->row); /* in order, without gaps */
    assert_int_equal(stride, 2 * WIDTH);
    d->row += rows;
    d->pixels = pixels;
    d->y = y;
    d->bytes = rows * stride;
    return ++d->flushed == d->fails_at ? HAL_E_IO : 0;
}

static int late_end(struct hal_display *display)
{
    struct late_display *d = (struct late_display *)display;
    assert_int_equal(d->row, HEIGHT);
    d->ended++;
    return 0;
}

static const struct hal_display_ops late_ops = {NULL, late_begin, late_flush, late_end, NULL};

struct share_case {
    struct share share;
    struct late_display display;
    struct frame_case frame;
    void *worker;
    uint8_t *expected;
};

static void open_case(struct share_case *c, unsigned band_rows, unsigned buffers, int two)
{
    *c = (struct share_case){.display.display.ops = &late_ops};
    c->frame = frame_case_small(WIDTH, HEIGHT, GLINT_RGB565);
    c->expected = frame_case_picture(c->frame, scene.scene, 0, NULL);
    c->display.expected = c->expected;
    c->frame.config.band_rows = (uint16_t)band_rows;
    frame_case_open_for(&c->frame, scene.scene);
    size_t bytes = glint_worker_memory_needed(&c->frame.config);
    c->worker = malloc(bytes);
    c->share.core = two ? &core : NULL;
    c->share.display = &c->display.display;
    for (unsigned i = 0; i < buffers; i++)
        c->share.band[i] = malloc(glint_band_bytes(&c->frame.config));
    c->share.frame = c->frame.frame;
    share_ready(&c->share, c->worker, (uint32_t)bytes);
    assert_true(!two || c->share.core);
}

static void close_case(struct share_case *c)
{
    if (c->share.started)
        core_end();
    for (unsigned i = 0; i < SHARE_MOST_BANDS; i++)
        free(c->share.band[i]);
    free(c->worker);
    free(c->expected);
    frame_case_close(&c->frame);
}

/* Pictures that follow one another; each is compared when the next begins, the last one here. */
static void show_pictures(struct share_case *c)
{
    for (unsigned i = 0; i < PICTURES; i++) {
        assert_int_equal(share_begin(&c->share, scene.scene, 0), 0);
        assert_int_equal(share_draw(&c->share), 0);
        assert_int_equal(c->share.frame.stats.drawn[GLINT_X],
                         c->share.frame.stats.triangles - c->share.frame.stats.culled);
    }
    assert_int_equal(share_finish(&c->share), 0);
    assert_int_equal(c->display.ended, PICTURES);
    late_take(&c->display);
    assert_memory_equal(c->display.picture, c->expected, sizeof c->display.picture);
}

static void pictures_arrive_whole_and_in_order(void **state)
{
    (void)state;
    static const uint8_t rows[] = {1, 7, 10, 24, 60};
    for (unsigned i = 0; i < sizeof rows * 4; i++) {
        struct share_case c;
        open_case(&c, rows[i / 4], i & 1 ? 2 : 4, (i & 2) != 0);
        show_pictures(&c);
        close_case(&c);
    }
}

static void the_count_of_bands_goes_round(void **state)
{
    (void)state;
    struct share_case c;
    open_case(&c, 10, 4, 0);
    c.share.next = c.share.end = UINT32_MAX - 7;
    c.share.due = c.share.left = UINT32_MAX - 7;
    show_pictures(&c);
    assert_true(c.share.end < 100);
    close_case(&c);
}

static void a_worker_without_memory_leaves_one_to_draw(void **state)
{
    (void)state;
    struct share_case c;
    open_case(&c, 10, 4, 0);
    c.share.core = &core;
    share_ready(&c.share, c.worker, 16);
    assert_null(c.share.core);
    show_pictures(&c);
    close_case(&c);
}

static void who_finds_a_lock_taken_comes_back(void **state)
{
    (void)state;
    for (unsigned most = 1; most < 60; most++) {
        struct share_case c;
        open_case(&c, 10, 4, 1);
        atomic_store(&refused[HAL_LOCK_SEND], most);
        atomic_store(&refused[HAL_LOCK_TAKE], most);
        show_pictures(&c);
        close_case(&c);
        atomic_store(&refused[HAL_LOCK_SEND], 0);
        atomic_store(&refused[HAL_LOCK_TAKE], 0);
    }
}

static void what_was_not_sent_while_it_was_drawn_is_sent_at_the_end(void **state)
{
    (void)state;
    struct share_case c;
    open_case(&c, 24, 4, 1); /* a buffer a band */
    atomic_store(&refused[HAL_LOCK_SEND], 100000);
    assert_int_equal(share_begin(&c.share, scene.scene, 0), 0);
    assert_int_equal(share_draw(&c.share), 0);
    assert_int_equal(c.display.begun, 0);
    atomic_store(&refused[HAL_LOCK_SEND], 9);
    assert_int_equal(share_finish(&c.share), 0);
    assert_int_equal(c.display.ended, 1);
    atomic_store(&refused[HAL_LOCK_SEND], 0);
    close_case(&c);
}

static void slow_second(void *context, const struct glint_band *band, int assisting)
{
    (void)context, (void)band;
    if (assisting)
        nanosleep(&(struct timespec){.tv_nsec = 2000000}, NULL);
}

static void the_first_cpu_waits_for_a_band_of_the_second(void **state)
{
    (void)state;
    struct share_case c;
    open_case(&c, 1, 4, 1);
    c.share.over = slow_second;
    show_pictures(&c);
    close_case(&c);
}

/* Of another method or scene: the second CPU runs on. */
static void a_renderer_made_anew_keeps_the_second_cpu(void **state)
{
    (void)state;
    struct share_case c;
    open_case(&c, 10, 4, 1);
    show_pictures(&c);
    pthread_t first = second;
    share_ready(&c.share, c.worker, (uint32_t)glint_worker_memory_needed(&c.frame.config));
    assert_true(pthread_equal(first, second));
    c.display.begun = c.display.ended = 0;
    show_pictures(&c);
    close_case(&c);
}

static void three_buffers_are_as_two_and_without_a_display_all_is_drawn(void **state)
{
    (void)state;
    struct share_case c;
    open_case(&c, 10, 3, 1);
    assert_int_equal(c.share.buffers, 2);
    show_pictures(&c);
    c.share.display = NULL;
    assert_int_equal(share_begin(&c.share, scene.scene, 0), 0);
    assert_int_equal(share_draw(&c.share), 0);
    assert_int_equal(share_finish(&c.share), 0);
    assert_int_equal(atomic_load(&c.share.due), c.share.end);
    assert_int_equal(c.display.ended, PICTURES);
    close_case(&c);
}

static void an_error_of_the_display_is_told_once(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 12; i++) {
        struct share_case c;
        int first, then;
        open_case(&c, 10, 4, i & 1);
        c.display.fails_at = 1 + i / 2;
        assert_int_equal(share_begin(&c.share, scene.scene, 0), 0);
        first = share_draw(&c.share);
        then = share_finish(&c.share);
        assert_int_equal(first ? first : then, HAL_E_IO);
        assert_true(!first || !then);
        assert_int_equal(c.display.flushed, c.display.fails_at);
        c.display = (struct late_display){.display.ops = &late_ops, .expected = c.expected}; /* opened anew */
        show_pictures(&c);
        close_case(&c);
    }
}

static void bad_scenes_are_refused_before_anything_is_sent(void **state)
{
    (void)state;
    struct share_case c;
    uint32_t nothing[16] = {0};
    open_case(&c, 10, 4, 1);
    assert_int_equal(share_begin(&c.share, nothing, 0), GLINT_E_SCENE);
    assert_int_equal(share_finish(&c.share), 0);
    assert_int_equal(c.display.begun, 0);
    show_pictures(&c);
    close_case(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_arrive_whole_and_in_order),
        cmocka_unit_test(the_count_of_bands_goes_round),
        cmocka_unit_test(a_worker_without_memory_leaves_one_to_draw),
        cmocka_unit_test(who_finds_a_lock_taken_comes_back),
        cmocka_unit_test(what_was_not_sent_while_it_was_drawn_is_sent_at_the_end),
        cmocka_unit_test(the_first_cpu_waits_for_a_band_of_the_second),
        cmocka_unit_test(a_renderer_made_anew_keeps_the_second_cpu),
        cmocka_unit_test(three_buffers_are_as_two_and_without_a_display_all_is_drawn),
        cmocka_unit_test(an_error_of_the_display_is_told_once),
        cmocka_unit_test(bad_scenes_are_refused_before_anything_is_sent),
    };
    return cmocka_run_group_tests(tests, load, unload);
}

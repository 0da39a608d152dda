/* SPDX-License-Identifier: MIT */
#include "view/playback.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "random.h"

static const uint64_t noon = 5000000000; /* any origin, beyond 32 bits */

static void the_first_picture_is_shown_at_once(void **state)
{
    struct playback p = {0};
    (void)state;
    assert_int_equal(playback_wait(&p, 123456789, noon), 0);
    playback_shown(&p, 123456789, noon);
    assert_int_equal(playback_wait(&p, 123456789 + 20000, noon), 20000);
    assert_int_equal(playback_wait(&p, 123456789 + 20000, noon + 15000), 5000);
    assert_int_equal(playback_wait(&p, 123456789 + 20000, noon + 20000), 0);
    assert_int_equal(playback_wait(&p, 123456789 + 20000, noon + 20001), 0);
}

static void the_devices_clock_runs_over(void **state)
{
    struct playback p = {0};
    (void)state;
    playback_shown(&p, UINT32_MAX - 9999, noon);
    assert_int_equal(playback_wait(&p, 10000, noon), 20000);
    assert_int_equal(playback_gap(UINT32_MAX, 0), 1);
    assert_int_equal(playback_gap(7, 7), 0);
}

static void a_long_gap_is_cut(void **state)
{
    struct playback p = {0};
    (void)state;
    playback_shown(&p, 0, noon);
    assert_int_equal(playback_wait(&p, 1999999, noon), 1999999);
    assert_int_equal(playback_wait(&p, 3600000000u, noon), 2000000);
    assert_int_equal(playback_gap(50, 49), 2000000); /* switched off and on */
}

/* As long as none is later than what is forgiven, the pictures are as far from the first as the device drew them. */
static void small_delays_do_not_add_up(void **state)
{
    struct playback p = {0};
    uint32_t time = 4294000000u;
    uint64_t now = noon, due = noon;
    (void)state;
    random_seed(1);
    playback_shown(&p, time, now);
    for (int i = 0; i < 10000; i++) {
        uint32_t gap = (uint32_t)random_between(0, 60000);
        time += gap;
        due += gap;
        uint32_t wait = playback_wait(&p, time, now);
        assert_int_equal(wait, due > now ? due - now : 0);
        now += wait + (uint32_t)random_between(0, PLAYBACK_SLACK_US / 4);
        if (now > due + PLAYBACK_SLACK_US)
            now = due + PLAYBACK_SLACK_US;
        playback_shown(&p, time, now);
    }
    assert_int_equal(p.clock_us, due);
}

static void a_large_delay_moves_what_follows(void **state)
{
    struct playback p = {0};
    (void)state;
    playback_shown(&p, 0, noon);
    playback_shown(&p, 20000, noon + 20000 + PLAYBACK_SLACK_US); /* forgiven */
    assert_int_equal(playback_wait(&p, 200000, noon + 20000 + PLAYBACK_SLACK_US), 80000);
    playback_shown(&p, 200000, noon + 900000);
    assert_int_equal(playback_wait(&p, 220000, noon + 900000), 20000);
}

static void after_a_pause_the_rest_of_the_wait_is_left(void **state)
{
    struct playback p = {0};
    (void)state;
    playback_shown(&p, 0, noon);
    playback_pause(&p, true, noon + 5000);
    assert_int_equal(playback_wait(&p, 20000, noon + 6000), PLAYBACK_NEVER);
    assert_int_equal(playback_wait(&p, 20000, noon + 9000000), PLAYBACK_NEVER);
    playback_pause(&p, true, noon + 8000000); /* again changes nothing */
    playback_pause(&p, false, noon + 9000000);
    assert_int_equal(playback_wait(&p, 20000, noon + 9000000), 15000);
    playback_pause(&p, false, noon + 9000000);
    assert_int_equal(playback_wait(&p, 20000, noon + 9000000), 15000);
}

static void a_step_lets_one_picture_through(void **state)
{
    struct playback p = {0};
    (void)state;
    playback_shown(&p, 0, noon);
    playback_step(&p); /* means nothing while it runs */
    assert_int_equal(playback_wait(&p, 20000, noon), 20000);
    playback_pause(&p, true, noon + 5000);
    playback_step(&p);
    assert_int_equal(playback_wait(&p, 20000, noon + 6000), 0);
    playback_shown(&p, 20000, noon + 6000);
    assert_int_equal(playback_wait(&p, 40000, noon + 7000), PLAYBACK_NEVER);
    playback_pause(&p, false, noon + 50000);
    assert_int_equal(playback_wait(&p, 40000, noon + 50000), 20000); /* all of it: it was shown for no time */
}

static void a_step_that_no_picture_took_ends_with_the_pause(void **state)
{
    struct playback p = {0};
    (void)state;
    playback_shown(&p, 0, noon);
    playback_pause(&p, true, noon);
    playback_step(&p);
    playback_pause(&p, false, noon + 1000);
    assert_int_equal(playback_wait(&p, 20000, noon + 1000), 20000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_picture_is_shown_at_once),
        cmocka_unit_test(the_devices_clock_runs_over),
        cmocka_unit_test(a_long_gap_is_cut),
        cmocka_unit_test(small_delays_do_not_add_up),
        cmocka_unit_test(a_large_delay_moves_what_follows),
        cmocka_unit_test(after_a_pause_the_rest_of_the_wait_is_left),
        cmocka_unit_test(a_step_lets_one_picture_through),
        cmocka_unit_test(a_step_that_no_picture_took_ends_with_the_pause),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

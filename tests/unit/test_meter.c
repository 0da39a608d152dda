/* SPDX-License-Identifier: MIT */
/* Rates and latency of a stream, on a clock of the test's own. */
#include "view/meter.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static const struct frames_picture picture = {
    .width = 10, .height = 10, .format = STREAM_RGB565, .bytes = 50, .bands = {1, 2, 3}};

/* In tenths, to be compared exactly. */
static int tenths(double value)
{
    return (int)(value * 10. + .5);
}

static void rates_are_of_the_last_period(void **state)
{
    struct meter m = {0};
    (void)state;
    assert_false(meter_turn(&m, 5.));
    assert_int_equal(meter_rate(&m, 7.), 0);
    for (double now = 1000.; now < 1500.; now += 25.) {
        assert_false(meter_turn(&m, now));
        meter_picture(&m, &picture, now);
    }
    assert_true(meter_turn(&m, 1503.)); /* whenever that is */
    assert_int_equal(m.last.pictures, 19);
    assert_int_equal(m.last.bytes, 19 * 50);
    assert_int_equal(m.last.plain, 19 * 200);
    assert_int_equal(m.last.bands[STREAM_CHANGE], 57);
    assert_int_equal(tenths(meter_rate(&m, m.last.pictures)), 400);
    for (double now = 1525.; now < 2003.; now += 50.)
        meter_picture(&m, &picture, now);
    assert_true(meter_turn(&m, 2003.));
    assert_int_equal(m.last.pictures, 10);
    assert_int_equal(tenths(meter_rate(&m, m.last.pictures)), 200);
    assert_true(meter_turn(&m, 2503.)); /* none in between */
    assert_int_equal(m.last.pictures, 10);
    assert_true(meter_turn(&m, 1975. + METER_SILENT_MS));
    assert_int_equal(tenths(meter_rate(&m, m.last.pictures)), 0);
    meter_picture(&m, &picture, 9000.); /* the pause was no picture's time */
    meter_picture(&m, &picture, 9100.);
    assert_true(meter_turn(&m, 9101.));
    assert_int_equal(tenths(meter_rate(&m, m.last.pictures)), 100);
}

static void a_picture_in_more_than_a_period_is_a_rate_too(void **state)
{
    struct meter m = {0};
    (void)state;
    for (double now = 1000.; now < 9000.; now += 10.) {
        if ((int)now % 800 == 200)
            meter_picture(&m, &picture, now);
        if (meter_turn(&m, now) && now > 2000.)
            assert_int_equal(tenths(meter_rate(&m, m.last.pictures)), 13);
    }
}

static void latency_is_from_a_request_to_the_first_picture_that_answers(void **state)
{
    struct meter m = {0};
    struct frames_picture p = picture;
    (void)state;
    meter_sent(&m, 1, 100.);
    meter_sent(&m, 2, 150.);
    meter_shown(&m, &p, 160.); /* it had heard nothing */
    assert_int_equal(tenths(m.latency_ms), 0);
    p.echo = 1;
    meter_shown(&m, &p, 170.);
    assert_int_equal(tenths(m.latency_ms), 700);
    meter_shown(&m, &p, 190.); /* the same echo again says nothing */
    assert_int_equal(tenths(m.latency_ms), 700);
    p.echo = 2;
    meter_shown(&m, &p, 180.);
    assert_int_equal(tenths(m.latency_ms), 300);
    p.echo = 9; /* never sent */
    meter_shown(&m, &p, 500.);
    assert_int_equal(tenths(m.latency_ms), 300);
    p.echo = 0; /* it has begun anew */
    meter_shown(&m, &p, 600.);
    assert_int_equal(tenths(m.latency_ms), 300);
}

static void only_the_last_requests_are_remembered(void **state)
{
    struct meter m = {0};
    struct frames_picture p = picture;
    (void)state;
    for (uint16_t i = 0; i <= METER_REQUESTS; i++)
        meter_sent(&m, (uint16_t)(65530 + i), i);
    p.echo = 65530;
    meter_shown(&m, &p, 100.);
    assert_int_equal(tenths(m.latency_ms), 0);
    p.echo = 65531;
    meter_shown(&m, &p, 100.);
    assert_int_equal(tenths(m.latency_ms), 990);
}

static void another_device_answers_nothing_of_before(void **state)
{
    struct meter m = {0};
    struct frames_picture p = picture;
    (void)state;
    meter_sent(&m, 3, 1.);
    meter_restart(&m);
    p.echo = 3;
    meter_shown(&m, &p, 10.);
    assert_int_equal(tenths(m.latency_ms), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(rates_are_of_the_last_period),
                                       cmocka_unit_test(a_picture_in_more_than_a_period_is_a_rate_too),
                                       cmocka_unit_test(latency_is_from_a_request_to_the_first_picture_that_answers),
                                       cmocka_unit_test(only_the_last_requests_are_remembered),
                                       cmocka_unit_test(another_device_answers_nothing_of_before)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* A device that is unplugged anywhere and comes again, or another in its place: nothing of before is used. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "stream_case.h"

enum { WIDTH = 9, HEIGHT = 6, ROWS = 4, COUNT = 6, KEY = 3, BYTES = WIDTH * HEIGHT };

static uint8_t pictures[2][COUNT][BYTES];
static struct stream_case_bytes sent[2];
static size_t ends[2][COUNT + 1]; /* of pictures, from the first's beginning on */

static int send_both(void **state)
{
    (void)state;
    for (unsigned device = 0; device < 2; device++) {
        struct stream s = stream_case_open(&sent[device], STREAM_GREY8, WIDTH, HEIGHT, ROWS, true);
        for (unsigned i = 0; i < COUNT; i++) {
            for (unsigned j = 0; j < BYTES; j++) /* half of a picture is the last one's */
                pictures[device][i][j] = (uint8_t)(j & 1 ? 40 * device + j : 100 * device + 31 * i + j * j);
            s.key = i % KEY == 0;
            assert_int_equal(stream_case_send(&s, pictures[device][i], ROWS), 0);
            ends[device][i + 1] = sent[device].count;
        }
        free(s.buffer);
        free(s.last);
    }
    return 0;
}

static int forget_both(void **state)
{
    (void)state;
    free(sent[0].bytes);
    free(sent[1].bytes);
    return 0;
}

/* The first `cut` bytes of a device, then another from `from` on: what is shown of that, bit by bit. */
static uint64_t shown(unsigned first, size_t cut, unsigned second, size_t from)
{
    struct stream_case_view view;
    stream_case_watch(&view, &pictures[first][0][0], BYTES, COUNT);
    frames_push(&view.frames, sent[first].bytes, cut);
    frames_restart(&view.frames);
    assert_true(view.frames.want_key);
    view.shown = 0;
    view.pictures = &pictures[second][0][0];
    stream_case_take(&view, sent[second].bytes + from, sent[second].count - from);
    assert_int_equal(view.wrong, 0);
    return view.shown;
}

static void a_device_that_begins_anew_is_shown_whole(void **state)
{
    (void)state;
    for (size_t cut = 0; cut <= sent[0].count; cut++) {
        assert_int_equal(shown(0, cut, 0, 0), (1 << COUNT) - 1);
        assert_int_equal(shown(0, cut, 1, 0), (1 << COUNT) - 1);
    }
}

/* Also where number and sequence go on as if nothing had happened. */
static void another_device_s_changes_are_not_put_on_the_last_picture(void **state)
{
    (void)state;
    for (unsigned i = 0; i <= COUNT; i++)
        for (unsigned j = 0; j <= COUNT; j++)
            assert_int_equal(shown(0, ends[0][i], 1, ends[1][j]), j == 0     ? (1 << COUNT) - 1
                                                                  : j <= KEY ? (1 << COUNT) - (1 << KEY)
                                                                             : 0);
}

static void what_was_under_way_is_lost_and_nothing_else(void **state)
{
    (void)state;
    for (size_t cut = 0; cut <= sent[0].count; cut++) {
        struct stream_case_view view;
        bool whole = false;
        for (unsigned i = 0; i <= COUNT; i++) /* a begin's 48 bytes must be there, or it was not begun */
            whole |= cut >= ends[0][i] && cut < ends[0][i] + 48;
        stream_case_watch(&view, &pictures[0][0][0], BYTES, COUNT);
        frames_push(&view.frames, sent[0].bytes, cut);
        frames_restart(&view.frames);
        assert_int_equal(view.frames.lost, !whole);
        frames_restart(&view.frames);
        assert_int_equal(view.frames.lost, !whole);
        stream_case_take(&view, sent[0].bytes, sent[0].count);
        assert_int_equal(view.frames.lost, !whole);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_device_that_begins_anew_is_shown_whole),
                                       cmocka_unit_test(another_device_s_changes_are_not_put_on_the_last_picture),
                                       cmocka_unit_test(what_was_under_way_is_lost_and_nothing_else)};
    return cmocka_run_group_tests(tests, send_both, forget_both);
}

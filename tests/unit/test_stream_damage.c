/* SPDX-License-Identifier: MIT */
/* A recorded stream of ten pictures, cut, split, flipped, torn and mixed: no wrong picture is ever shown, and every one
 * is that came whole, with all it refers to. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>

#include "random.h"
#include "scene/scene.h"
#include "stream_case.h"

enum { WIDTH = 10, HEIGHT = 6, BYTES = 2 * WIDTH * HEIGHT, COUNT = 10, KEY = 5, ALL = (1 << COUNT) - 1 };

static struct {
    uint8_t pictures[COUNT * BYTES];
    struct stream_case_bytes out;
    size_t end[COUNT + 1]; /* of each frame's bytes; [0]: of hello's */
} tape;

static int record(void **state)
{
    static const char *name = "x";
    const struct stream_names names = {"b", {&name, 1, sizeof name}, {&name, 1, sizeof name}};
    struct stream s = stream_case_open(&tape.out, STREAM_RGB565, WIDTH, HEIGHT, 3, true);
    (void)state;
    random_seed(7);
    for (size_t i = 0; i < sizeof tape.pictures; i++)
        tape.pictures[i] =
            (uint8_t)(i >= BYTES && random_between(0, 9) ? tape.pictures[i - BYTES] : random_between(0, 2));
    stream_hello(&s, &names);
    tape.end[0] = tape.out.count;
    for (unsigned i = 0; i < COUNT; i++) {
        s.key = i == KEY;
        if (stream_case_send(&s, tape.pictures + i * BYTES, HEIGHT) != 0)
            return -1;
        tape.end[i + 1] = tape.out.count;
    }
    free(s.buffer);
    free(s.last);
    return 0;
}

static int forget(void **state)
{
    (void)state;
    free(tape.out.bytes);
    return 0;
}

/* A copy of the tape in a block of its size. */
static uint8_t *copy(void)
{
    uint8_t *bytes = malloc(tape.out.count);
    assert_non_null(bytes);
    memcpy(bytes, tape.out.bytes, tape.out.count);
    return bytes;
}

static void watch(struct stream_case_view *view)
{
    stream_case_watch(view, tape.pictures, BYTES, COUNT);
}

/* What of the tape is shown if the bytes from..to - 1 are lost or spoilt. */
static uint64_t left_over(size_t from, size_t to)
{
    uint64_t shown = 0;
    bool chained = false;
    for (unsigned i = 0; i < COUNT; i++) {
        bool whole = tape.end[i + 1] <= from || tape.end[i] >= to;
        chained = whole && (chained || i == 0 || i == KEY);
        /* a loss in hello, or right before a frame, is one in its number */
        shown |= (uint64_t)chained << i;
    }
    return shown;
}

static void every_split_shows_every_picture(void **state)
{
    (void)state;
    for (size_t at = 0; at <= tape.out.count; at++) {
        struct stream_case_view view;
        uint8_t *first = malloc(at + 1), *second = malloc(tape.out.count - at + 1);
        memcpy(first, tape.out.bytes, at);
        memcpy(second, tape.out.bytes + at, tape.out.count - at);
        watch(&view);
        frames_push(&view.frames, first, at);
        stream_case_take(&view, second, tape.out.count - at);
        assert_int_equal(view.shown, ALL);
        assert_int_equal(view.wrong + view.frames.lost + view.frames.parser.damaged, 0);
        free(first);
        free(second);
    }
}

static void bytes_may_come_in_pieces_of_any_size(void **state)
{
    (void)state;
    for (size_t piece = 1; piece < 80; piece++) {
        struct stream_case_view view;
        watch(&view);
        for (size_t at = 0; at < tape.out.count; at += piece)
            frames_push(&view.frames, tape.out.bytes + at, tape.out.count - at < piece ? tape.out.count - at : piece);
        assert_int_equal(view.shown, ALL);
        assert_int_equal(view.frames.parser.count, 0);
        frames_close(&view.frames);
    }
}

static void every_beginning_shows_the_pictures_in_it(void **state)
{
    (void)state;
    for (size_t size = 0; size <= tape.out.count; size++) {
        struct stream_case_view view;
        uint8_t *bytes = malloc(size + 1);
        memcpy(bytes, tape.out.bytes, size);
        watch(&view);
        stream_case_take(&view, bytes, size);
        assert_int_equal(view.wrong, 0);
        assert_int_equal(view.shown, left_over(size, SIZE_MAX));
        free(bytes);
    }
}

static void every_end_shows_the_pictures_from_its_first_key_frame_on(void **state)
{
    (void)state;
    for (size_t from = 0; from <= tape.out.count; from++) {
        struct stream_case_view view;
        watch(&view);
        stream_case_take(&view, tape.out.bytes + from, tape.out.count - from);
        assert_int_equal(view.wrong, 0);
        assert_int_equal(view.shown, left_over(0, from));
        assert_int_equal(view.frames.want_key, from > tape.end[KEY]);
    }
}

static void a_flipped_bit_costs_what_refers_to_it_alone(void **state)
{
    uint8_t *bytes = copy();
    (void)state;
    for (size_t at = 0; at < tape.out.count; at++)
        for (unsigned bit = 0; bit < 8; bit++) {
            struct stream_case_view view;
            bytes[at] ^= (uint8_t)(1u << bit);
            watch(&view);
            stream_case_take(&view, bytes, tape.out.count);
            bytes[at] ^= (uint8_t)(1u << bit);
            assert_int_equal(view.wrong, 0);
            assert_int_equal(view.shown, left_over(at, at + 1));
        }
    free(bytes);
}

static void a_lost_byte_costs_what_refers_to_it_alone(void **state)
{
    uint8_t *bytes = malloc(tape.out.count);
    (void)state;
    for (size_t at = 0; at < tape.out.count; at++)
        for (size_t gap = 1; gap <= 64; gap *= 8) {
            struct stream_case_view view;
            size_t end = at + gap < tape.out.count ? at + gap : tape.out.count;
            memcpy(bytes, tape.out.bytes, at);
            memcpy(bytes + at, tape.out.bytes + end, tape.out.count - end);
            watch(&view);
            stream_case_take(&view, bytes, at + tape.out.count - end);
            assert_int_equal(view.wrong, 0);
            assert_int_equal(view.shown, left_over(at, end));
        }
    free(bytes);
}

/* Lines of text, noise, and what looks like the beginning of a message. */
static void what_stands_between_messages_is_passed_over(void **state)
{
    static const uint8_t foreign[][8] = {"frame x\n", {0xF6, 0x47, 0x4C, 0x53, 1, 3, 0, 0}, {0xF6, 0xF6, 0x47}, {0}};
    (void)state;
    for (unsigned kind = 0; kind < sizeof foreign / sizeof *foreign; kind++) {
        struct stream_case_view view;
        watch(&view);
        frames_push(&view.frames, foreign[kind], sizeof foreign[kind]);
        for (size_t at = 0; at < tape.out.count;) {
            size_t length = tape.out.bytes[at + STREAM_AT_LENGTH] + 256u * tape.out.bytes[at + STREAM_AT_LENGTH + 1];
            size_t size = STREAM_HEADER + length + STREAM_CHECK;
            frames_push(&view.frames, tape.out.bytes + at, size);
            frames_push(&view.frames, foreign[kind], sizeof foreign[kind]);
            at += size;
        }
        frames_finish(&view.frames);
        frames_close(&view.frames);
        assert_int_equal(view.shown, ALL);
        assert_int_equal(view.wrong + view.frames.lost, 0);
    }
}

/* Pieces of the tape in any order, some twice, some damaged. */
static void a_torn_stream_shows_nothing_wrong(void **state)
{
    uint64_t seen = 0;
    (void)state;
    random_seed(8);
    for (int i = 0; i < 4000; i++) {
        struct stream_case_view view;
        uint8_t *bytes = copy();
        watch(&view);
        for (int piece = 0; piece < 6; piece++) {
            size_t from = (size_t)random_between(0, (int32_t)tape.out.count - 1);
            size_t size = (size_t)random_between(0, (int32_t)(tape.out.count - from));
            if (random_between(0, 3) == 0)
                bytes[from] = (uint8_t)(random_bits() >> 9 & 255);
            frames_push(&view.frames, bytes + from, size);
        }
        stream_case_take(&view, bytes, 0);
        assert_int_equal(view.wrong, 0);
        seen |= view.shown;
        free(bytes);
    }
    assert_int_equal(seen, ALL);
}

static void put_crc(uint8_t *at, uint32_t crc)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(crc >> 8 * i & 255);
}

/* Messages whose checks hold and whose contents do not: pictures may then be any, but nothing is read or written
 * beside. */
static void checked_nonsense_does_no_harm(void **state)
{
    uint32_t shown = 0, lost = 0;
    (void)state;
    random_seed(10);
    for (int i = 0; i < 6000; i++) {
        struct stream_case_view view;
        uint8_t *bytes = copy();
        watch(&view);
        for (size_t at = 0; at < tape.out.count;) {
            uint8_t *head = bytes + at;
            size_t length = parser_get32(head + STREAM_AT_LENGTH);
            at += STREAM_HEADER + length + STREAM_CHECK;
            for (int spoil = random_between(-12, 2); spoil > 0; spoil--)
                head[random_between(STREAM_AT_VERSION, (int32_t)(STREAM_HEADER + length) - 1)] =
                    (uint8_t)(random_between(0, 3) ? random_between(0, 6) : random_between(0, 255));
            uint32_t crc = scene_crc32(0, head, STREAM_AT_CRC);
            put_crc(head + STREAM_AT_CRC, crc);
            put_crc(head + STREAM_HEADER + length, scene_crc32(crc, head + STREAM_HEADER, length));
        }
        stream_case_take(&view, bytes, tape.out.count);
        assert_false(view.frames.parser.out_of_memory);
        shown += view.frames.pictures;
        lost += view.frames.lost;
        free(bytes);
    }
    assert_true(shown > 6000 && lost > 1000);
}

/* Each claims 64 KiB, which are those that follow: to check them all would take the square of their bytes. */
static void headers_that_swallow_one_another_are_soon_given_up(void **state)
{
    enum { HEADERS = 8192, CLAIM = 65536 };
    uint8_t head[STREAM_HEADER] = {0xF6, 'G', 'L', 'S', STREAM_VERSION, 0x40};
    uint8_t *none = calloc(CLAIM, 1);
    struct stream_case_view view;
    (void)state;
    head[STREAM_AT_LENGTH + 2] = CLAIM >> 16;
    put_crc(head + STREAM_AT_CRC, scene_crc32(0, head, STREAM_AT_CRC));
    watch(&view);
    for (unsigned i = 0; i < HEADERS; i++)
        frames_push(&view.frames, head, sizeof head);
    frames_push(&view.frames, none, CLAIM);
    assert_in_range(view.frames.parser.damaged, 1, 17 * (HEADERS * STREAM_HEADER + CLAIM) / CLAIM + 1);
    stream_case_take(&view, tape.out.bytes, tape.out.count);
    assert_int_equal(view.shown, ALL);
    free(none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_split_shows_every_picture),
        cmocka_unit_test(bytes_may_come_in_pieces_of_any_size),
        cmocka_unit_test(every_beginning_shows_the_pictures_in_it),
        cmocka_unit_test(every_end_shows_the_pictures_from_its_first_key_frame_on),
        cmocka_unit_test(a_flipped_bit_costs_what_refers_to_it_alone),
        cmocka_unit_test(a_lost_byte_costs_what_refers_to_it_alone),
        cmocka_unit_test(what_stands_between_messages_is_passed_over),
        cmocka_unit_test(a_torn_stream_shows_nothing_wrong),
        cmocka_unit_test(checked_nonsense_does_no_harm),
        cmocka_unit_test(headers_that_swallow_one_another_are_soon_given_up),
    };
    return cmocka_run_group_tests(tests, record, forget);
}

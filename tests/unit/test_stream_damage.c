/* SPDX-License-Identifier: MIT */
/* A recorded stream of ten pictures, cut, split, flipped, torn and mixed: no wrong picture is ever shown, and every one
 * is that came whole, with all it refers to. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "stream_tape.h"

static struct tape tapes[STREAM_FORMATS];

static int record(void **state)
{
    (void)state;
    random_seed(7);
    for (unsigned format = 0; format < STREAM_FORMATS; format++)
        tape_record(&tapes[format], (enum stream_format)format, 9, 6, TAPE_SEQUENCE, 0);
    return 0;
}

static int forget(void **state)
{
    (void)state;
    for (unsigned format = 0; format < STREAM_FORMATS; format++)
        tape_free(&tapes[format]);
    return 0;
}

/* Bands of every codec are on the tapes. */
static void count_codecs(void *context, const struct frames_picture *p)
{
    uint32_t *bands = context;
    for (unsigned codec = 0; codec < STREAM_CODECS; codec++)
        bands[codec] += p->bands[codec];
}

static void the_tapes_have_bands_of_every_codec(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++) {
        uint32_t bands[STREAM_CODECS] = {0};
        const struct frames_events events = {.picture = count_codecs, .context = bands};
        struct frames frames;
        frames_open(&frames, &events);
        frames_push(&frames, tape->out.bytes, tape->out.count);
        frames_close(&frames);
        for (unsigned codec = 0; codec < STREAM_CODECS; codec++)
            assert_true(bands[codec] > 0);
    }
}

static void every_split_shows_every_picture(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (size_t at = 0; at <= tape->out.count; at++) {
            struct stream_case_view view;
            uint8_t *first = malloc(at + 1), *second = malloc(tape->out.count - at + 1);
            memcpy(first, tape->out.bytes, at);
            memcpy(second, tape->out.bytes + at, tape->out.count - at);
            tape_watch(tape, &view);
            frames_push(&view.frames, first, at);
            stream_case_take(&view, second, tape->out.count - at);
            assert_int_equal(view.shown, TAPE_ALL);
            assert_int_equal(view.wrong + view.frames.lost + view.frames.parser.damaged, 0);
            free(first);
            free(second);
        }
}

static void bytes_may_come_in_pieces_of_any_size(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (size_t piece = 1; piece < 80; piece++) {
            struct stream_case_view view;
            tape_watch(tape, &view);
            for (size_t at = 0; at < tape->out.count; at += piece)
                frames_push(&view.frames, tape->out.bytes + at,
                            tape->out.count - at < piece ? tape->out.count - at : piece);
            assert_int_equal(view.shown, TAPE_ALL);
            assert_int_equal(view.frames.parser.count, 0);
            frames_close(&view.frames);
        }
}

static void every_beginning_shows_the_pictures_in_it(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (size_t size = 0; size <= tape->out.count; size++) {
            struct stream_case_view view;
            uint8_t *bytes = malloc(size + 1);
            memcpy(bytes, tape->out.bytes, size);
            tape_watch(tape, &view);
            stream_case_take(&view, bytes, size);
            assert_int_equal(view.wrong, 0);
            assert_int_equal(view.shown, tape_left_by(tape, size, SIZE_MAX));
            free(bytes);
        }
}

/* A cable pulled at any byte, and all that follows: what was cut off must not take the pictures after it along. */
static void after_every_beginning_the_whole_is_shown(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (size_t size = 0; size <= tape->out.count; size++) {
            struct stream_case_view view;
            tape_watch(tape, &view);
            frames_push(&view.frames, tape->out.bytes, size);
            view.shown = 0;
            stream_case_take(&view, tape->out.bytes, tape->out.count);
            assert_int_equal(view.wrong, 0);
            assert_int_equal(view.shown, TAPE_ALL);
        }
}

static void every_end_shows_the_pictures_from_its_first_key_frame_on(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (size_t from = 0; from <= tape->out.count; from++) {
            struct stream_case_view view;
            tape_watch(tape, &view);
            stream_case_take(&view, tape->out.bytes + from, tape->out.count - from);
            assert_int_equal(view.wrong, 0);
            assert_int_equal(view.shown, tape_left_by(tape, 0, from));
            assert_int_equal(view.frames.want_key, from > tape->begin[TAPE_KEY]);
        }
}

static void a_flipped_bit_costs_what_refers_to_it_alone(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++) {
        uint8_t *bytes = tape_copy(tape);
        for (size_t bit = 0; bit < 8 * tape->out.count; bit++) {
            struct stream_case_view view;
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
            tape_watch(tape, &view);
            stream_case_take(&view, bytes, tape->out.count);
            bytes[bit / 8] ^= (uint8_t)(1u << bit % 8);
            assert_int_equal(view.wrong, 0);
            assert_int_equal(view.shown, tape_left_by(tape, bit / 8, bit / 8 + 1));
        }
        free(bytes);
    }
}

/* What is missing when bytes are lost: those after them, if the first were the same. */
static struct tape_fault lost(const uint8_t *bytes, size_t count, size_t from, size_t to)
{
    for (; to < count && bytes[from] == bytes[to]; to++)
        from++;
    return (struct tape_fault){from, to};
}

static void a_lost_byte_costs_what_refers_to_it_alone(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++) {
        uint8_t *bytes = malloc(tape->out.count);
        for (size_t at = 0; at < tape->out.count; at++)
            for (size_t gap = 1; gap <= 64; gap *= 8) {
                struct stream_case_view view;
                size_t end = at + gap < tape->out.count ? at + gap : tape->out.count;
                memcpy(bytes, tape->out.bytes, at);
                memcpy(bytes + at, tape->out.bytes + end, tape->out.count - end);
                tape_watch(tape, &view);
                stream_case_take(&view, bytes, at + tape->out.count - end);
                assert_int_equal(view.wrong, 0);
                struct tape_fault fault = lost(tape->out.bytes, tape->out.count, at, end);
                assert_int_equal(view.shown, tape_left(tape, &fault, 1));
            }
        free(bytes);
    }
}

/* Spoils a bit or a byte, takes a few away, or puts some there that were not, from one of the first `end` bytes on: how
 * many bytes there are then. */
static size_t spoil(const struct tape *tape, uint8_t *bytes, size_t count, size_t end, struct tape_fault *fault)
{
    size_t from = (size_t)random_between(0, (int32_t)end - 1), size = (size_t)random_between(1, 40);
    size = size < end - from ? size : end - from;
    *fault = (struct tape_fault){from, from + 1};
    switch (random_between(0, 3)) {
    case 0:
        bytes[from] ^= (uint8_t)(1 << random_between(0, 7));
        return count;
    case 1:
        bytes[from] = (uint8_t)((bytes[from] + random_between(1, 255)) & 255);
        return count;
    case 2:
        *fault = lost(bytes, count, from, from + size);
        memmove(bytes + from, bytes + from + size, count - from - size);
        return count - size;
    default:
        memmove(bytes + from + size, bytes + from, count - from);
        memset(bytes + from, 'y', size);
        for (unsigned i = 0; i < tape->messages; i++)
            if (tape->message[i] == from) /* between messages they do no harm */
                *fault = (struct tape_fault){SIZE_MAX, SIZE_MAX};
        return count + size;
    }
}

static void two_faults_cost_what_each_does(void **state)
{
    uint64_t seen = 0;
    (void)state;
    random_seed(11);
    for (int i = 0; i < 20000; i++) {
        const struct tape *tape = &tapes[i % STREAM_FORMATS];
        struct stream_case_view view;
        struct tape_fault faults[2];
        uint8_t *bytes = malloc(tape->out.count + 80);
        memcpy(bytes, tape->out.bytes, tape->out.count);
        /* the later one first: it does not move the other */
        size_t count = spoil(tape, bytes, tape->out.count, tape->out.count, &faults[0]);
        size_t before = faults[0].from < tape->out.count ? faults[0].from : 0;
        faults[1] = faults[0];
        if (before)
            count = spoil(tape, bytes, count, before, &faults[1]);
        tape_watch(tape, &view);
        stream_case_take(&view, bytes, count);
        assert_int_equal(view.wrong, 0);
        assert_int_equal(view.shown, tape_left(tape, faults, 2));
        seen |= view.shown;
        free(bytes);
    }
    assert_int_equal(seen, TAPE_ALL);
}

/* Lines of text, noise, and what looks like the beginning of a message. */
static void what_stands_between_messages_is_passed_over(void **state)
{
    static const uint8_t foreign[][8] = {"frame x\n", {0xF6, 0x47, 0x4C, 0x53, 1, 3, 0, 0}, {0xF6, 0xF6, 0x47}, {0}};
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned kind = 0; kind < sizeof foreign / sizeof *foreign; kind++) {
            struct stream_case_view view;
            tape_watch(tape, &view);
            frames_push(&view.frames, foreign[kind], sizeof foreign[kind]);
            for (unsigned i = 0; i < tape->messages; i++) {
                frames_push(&view.frames, tape->out.bytes + tape->message[i], tape->message[i + 1] - tape->message[i]);
                frames_push(&view.frames, foreign[kind], sizeof foreign[kind]);
            }
            frames_finish(&view.frames);
            frames_close(&view.frames);
            assert_int_equal(view.shown, TAPE_ALL);
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
        const struct tape *tape = &tapes[i % STREAM_FORMATS];
        struct stream_case_view view;
        uint8_t *bytes = tape_copy(tape);
        tape_watch(tape, &view);
        for (int piece = 0; piece < 6; piece++) {
            size_t from = (size_t)random_between(0, (int32_t)tape->out.count - 1);
            size_t size = (size_t)random_between(0, (int32_t)(tape->out.count - from));
            if (random_between(0, 3) == 0)
                bytes[from] = (uint8_t)(random_bits() >> 9 & 255);
            frames_push(&view.frames, bytes + from, size);
        }
        stream_case_take(&view, bytes, 0);
        assert_int_equal(view.wrong, 0);
        seen |= view.shown;
        free(bytes);
    }
    assert_int_equal(seen, TAPE_ALL);
}

/* Messages whose checks hold and whose contents do not: pictures may then be any, but nothing is read or written
 * beside. */
static void checked_nonsense_does_no_harm(void **state)
{
    uint32_t shown = 0, lost = 0;
    (void)state;
    random_seed(10);
    for (int i = 0; i < 6000; i++) {
        const struct tape *tape = &tapes[i % STREAM_FORMATS];
        struct stream_case_view view;
        uint8_t *bytes = tape_copy(tape);
        tape_watch(tape, &view);
        for (unsigned k = 0; k < tape->messages; k++) {
            uint8_t *head = bytes + tape->message[k];
            size_t length = parser_get32(head + STREAM_AT_LENGTH);
            for (int spoil = random_between(-12, 2); spoil > 0; spoil--)
                head[random_between(STREAM_AT_VERSION, (int32_t)(STREAM_HEADER + length) - 1)] =
                    (uint8_t)(random_between(0, 3) ? random_between(0, 6) : random_between(0, 255));
            uint32_t crc = scene_crc32(0, head, STREAM_AT_CRC);
            tape_put(head + STREAM_AT_CRC, 4, crc);
            tape_put(head + STREAM_HEADER + length, 4, scene_crc32(crc, head + STREAM_HEADER, (uint32_t)length));
        }
        stream_case_take(&view, bytes, tape->out.count);
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
    tape_put(head + STREAM_AT_CRC, 4, scene_crc32(0, head, STREAM_AT_CRC));
    tape_watch(tapes, &view);
    for (unsigned i = 0; i < HEADERS; i++)
        frames_push(&view.frames, head, sizeof head);
    frames_push(&view.frames, none, CLAIM);
    assert_in_range(view.frames.parser.damaged, 1, 17 * (HEADERS * STREAM_HEADER + CLAIM) / CLAIM + 1);
    stream_case_take(&view, tapes->out.bytes, tapes->out.count);
    assert_int_equal(view.shown, TAPE_ALL);
    free(none);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_tapes_have_bands_of_every_codec),
        cmocka_unit_test(every_split_shows_every_picture),
        cmocka_unit_test(bytes_may_come_in_pieces_of_any_size),
        cmocka_unit_test(every_beginning_shows_the_pictures_in_it),
        cmocka_unit_test(after_every_beginning_the_whole_is_shown),
        cmocka_unit_test(every_end_shows_the_pictures_from_its_first_key_frame_on),
        cmocka_unit_test(a_flipped_bit_costs_what_refers_to_it_alone),
        cmocka_unit_test(a_lost_byte_costs_what_refers_to_it_alone),
        cmocka_unit_test(two_faults_cost_what_each_does),
        cmocka_unit_test(what_stands_between_messages_is_passed_over),
        cmocka_unit_test(a_torn_stream_shows_nothing_wrong),
        cmocka_unit_test(checked_nonsense_does_no_harm),
        cmocka_unit_test(headers_that_swallow_one_another_are_soon_given_up),
    };
    return cmocka_run_group_tests(tests, record, forget);
}

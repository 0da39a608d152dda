/* SPDX-License-Identifier: MIT */
/* Whole messages in the wrong order, twice, of another stream or of another kind: no wrong picture is ever shown, and
 * every one is that came in order, with all it refers to. */
#include "view/port.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "stream_tape.h"

enum { OTHER_NUMBER = 100, MOST_BYTES = 16384 };

static struct tape tapes[STREAM_FORMATS], others[STREAM_FORMATS];

static int record(void **state)
{
    (void)state;
    random_seed(12);
    for (unsigned format = 0; format < STREAM_FORMATS; format++) {
        tape_record(&tapes[format], (enum stream_format)format, 5, 4, TAPE_SEQUENCE, 0);
        tape_record(&others[format], (enum stream_format)format, 4, 7, 1000, OTHER_NUMBER);
    }
    return 0;
}

static int forget(void **state)
{
    (void)state;
    for (unsigned format = 0; format < STREAM_FORMATS; format++) {
        tape_free(&tapes[format]);
        tape_free(&others[format]);
    }
    return 0;
}

/* What is sent: messages of tapes one after the other. */
struct mix {
    uint8_t bytes[MOST_BYTES];
    size_t count;
};

static uint8_t *add(struct mix *mix, const struct tape *tape, unsigned from, unsigned to)
{
    uint8_t *at = mix->bytes + mix->count;
    size_t bytes = tape->message[to] - tape->message[from];
    assert_true(bytes <= sizeof mix->bytes - mix->count);
    memcpy(at, tape->out.bytes + tape->message[from], bytes);
    mix->count += bytes;
    return at;
}

/* What is shown of the mix: pictures of the tape, and how many of the other. */
struct seen {
    struct stream_case_view view;
    const struct tape *other;
    uint32_t others;
};

static void see(void *context, const struct frames_picture *p)
{
    struct seen *seen = context;
    const struct tape *other = seen->other;
    if (!other || p->number < OTHER_NUMBER) {
        stream_case_shown(&seen->view, p);
        return;
    }
    size_t i = p->number - OTHER_NUMBER;
    assert_true(i < TAPE_COUNT && p->format == other->format && p->width == other->width);
    assert_memory_equal(p->pixels, other->pictures + i * other->bytes, other->bytes);
    seen->others++;
}

static struct seen show(const struct mix *mix, const struct tape *tape, const struct tape *other)
{
    struct seen seen = {.other = other};
    const struct frames_events events = {.picture = see, .context = &seen};
    tape_watch(tape, &seen.view);
    frames_open(&seen.view.frames, &events);
    stream_case_take(&seen.view, mix->bytes, mix->count);
    assert_int_equal(seen.view.wrong, 0);
    return seen;
}

/* The message that begins a frame. */
static unsigned begin_of(const struct tape *tape, unsigned frame)
{
    unsigned i = 0;
    while (tape->message[i] != tape->begin[frame])
        i++;
    return i;
}

/* As if all that is in the mix had been sent so. */
static void renumber(struct mix *mix)
{
    unsigned sequence = TAPE_SEQUENCE;
    for (size_t at = 0; at < mix->count; at += tape_message(mix->bytes + at)) {
        tape_put(mix->bytes + at + STREAM_AT_SEQUENCE, 2, sequence++);
        tape_check(mix->bytes + at);
    }
}

static bool begins_key_frame(const struct tape *tape, unsigned message)
{
    return tape->message[message] == tape->begin[0] || tape->message[message] == tape->begin[TAPE_KEY];
}

/* At once or later. The beginning of a key frame twice begins it anew. */
static void a_message_twice_is_a_gap(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned twice = 0; twice < tape->messages; twice++)
            for (unsigned after = twice; after < tape->messages; after++) {
                struct mix mix = {.count = 0};
                size_t gap = tape->message[after + 1];
                add(&mix, tape, 0, after + 1);
                add(&mix, tape, twice, twice + 1);
                add(&mix, tape, after + 1, tape->messages);
                bool anew = after == twice && begins_key_frame(tape, twice);
                assert_int_equal(show(&mix, tape, NULL).view.shown, anew ? TAPE_ALL : tape_left_by(tape, gap, gap));
            }
}

static void two_messages_that_change_places_are_both_lost(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned i = 0; i + 1 < tape->messages; i++) {
            struct mix mix = {.count = 0};
            add(&mix, tape, 0, i);
            add(&mix, tape, i + 1, i + 2);
            add(&mix, tape, i, i + 1);
            add(&mix, tape, i + 2, tape->messages);
            assert_int_equal(show(&mix, tape, NULL).view.shown,
                             tape_left_by(tape, tape->message[i], tape->message[i + 2]));
        }
}

/* Any message at any place, whether its number in the sequence is the one that is due or not. */
static void a_message_of_another_stream_is_a_gap(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned foreign = 0; foreign < tape->messages; foreign++)
            for (unsigned place = 0; place < 2 * tape->messages; place++) {
                const struct tape *other = &others[(tape->format + 1) % STREAM_FORMATS];
                struct mix mix = {.count = 0};
                unsigned at = place / 2;
                add(&mix, tape, 0, at);
                uint8_t *head = add(&mix, other, foreign, foreign + 1);
                if (place & 1)
                    tape_put(head + STREAM_AT_SEQUENCE, 2, TAPE_SEQUENCE + at);
                tape_check(head);
                add(&mix, tape, at, tape->messages);
                struct seen seen = show(&mix, tape, other);
                assert_int_equal(seen.view.shown, tape_left_by(tape, tape->message[at], tape->message[at]));
                assert_int_equal(seen.others, 0);
            }
}

static void two_streams_in_turns_show_whole_key_frames_alone(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++) {
        const struct tape *other = &others[(tape->format + 1) % STREAM_FORMATS];
        struct mix mix = {.count = 0};
        assert_int_equal(tape->messages, other->messages);
        for (unsigned i = 0; i < tape->messages; i++) {
            add(&mix, tape, i, i + 1);
            add(&mix, other, i, i + 1);
        }
        struct seen seen = show(&mix, tape, other);
        assert_int_equal(seen.view.shown + seen.others, 0);
        /* now a frame of the one, a frame of the other */
        mix.count = 0;
        for (unsigned i = 0; i < TAPE_COUNT; i++) {
            unsigned from = begin_of(tape, i), to = i + 1 < TAPE_COUNT ? begin_of(tape, i + 1) : tape->messages;
            add(&mix, tape, from, to);
            add(&mix, other, from, to);
        }
        seen = show(&mix, tape, other);
        assert_int_equal(seen.view.shown, 1 | 1 << TAPE_KEY);
        assert_int_equal(seen.others, 2);
    }
}

/* A frame of another size or format that says it follows the last one. */
static void a_frame_of_another_kind_is_no_next_one(void **state)
{
    static const struct {
        enum stream_at at;
        unsigned value;
    } kinds[] = {{STREAM_AT_WIDTH, 4}, {STREAM_AT_HEIGHT, 3}, {STREAM_AT_FORMAT, 1}};
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned k = 0; k < sizeof kinds / sizeof *kinds; k++)
            for (unsigned i = 1; i < TAPE_COUNT; i++) {
                struct mix mix = {.count = 0};
                unsigned begin = begin_of(tape, i);
                if (i == TAPE_KEY)
                    continue;
                add(&mix, tape, 0, begin);
                uint8_t *head = add(&mix, tape, begin, begin + 1);
                head[kinds[k].at] = (uint8_t)(head[kinds[k].at] ^ kinds[k].value);
                tape_check(head);
                add(&mix, tape, begin + 1, tape->messages);
                assert_int_equal(show(&mix, tape, NULL).view.shown, tape_left_by(tape, tape->begin[i], tape->end[i]));
            }
}

/* The one before again, or one later, from its beginning to its end. */
static void a_frame_of_another_number_is_no_next_one(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned i = 1; i < TAPE_COUNT; i++)
            for (unsigned later = 0; later <= 2; later += 2) {
                struct mix mix = {.count = 0};
                unsigned begin = begin_of(tape, i), end = begin;
                if (i == TAPE_KEY)
                    continue;
                while (tape->message[end + 1] != tape->end[i])
                    end++;
                add(&mix, tape, 0, tape->messages);
                for (unsigned k = begin; k <= end; k += end - begin) {
                    tape_put(mix.bytes + tape->message[k] + STREAM_HEADER, 4, i - 1 + later);
                    tape_check(mix.bytes + tape->message[k]);
                }
                assert_int_equal(show(&mix, tape, NULL).view.shown, tape_left_by(tape, tape->begin[i], tape->end[i]));
            }
}

/* With a sequence that has no gap. */
static void a_frame_that_lacks_a_message_is_none(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned i = 0; i < tape->messages; i++) {
            struct mix mix = {.count = 0};
            unsigned type = tape->out.bytes[tape->message[i] + STREAM_AT_TYPE];
            add(&mix, tape, 0, i);
            add(&mix, tape, i + 1, tape->messages);
            renumber(&mix);
            assert_int_equal(show(&mix, tape, NULL).view.shown,
                             type == STREAM_HELLO || type == STREAM_LOG
                                 ? TAPE_ALL
                                 : tape_left_by(tape, tape->message[i], tape->message[i + 1]));
        }
}

static void a_band_elsewhere_or_of_another_kind_is_none_of_the_frame(void **state)
{
    static const struct {
        enum stream_at at;
        int more;
    } fields[] = {{STREAM_AT_X, 1},      {STREAM_AT_X + 1, 1},  {STREAM_AT_Y, 1},      {STREAM_AT_Y, -1},
                  {STREAM_AT_WIDTH, 1},  {STREAM_AT_WIDTH, -1}, {STREAM_AT_HEIGHT, 1}, {STREAM_AT_HEIGHT, -1},
                  {STREAM_AT_FORMAT, 1}, {STREAM_AT_FORMAT, -1}};
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned i = 0; i < tape->messages; i++)
            for (unsigned k = 0; k < sizeof fields / sizeof *fields; k++) {
                struct mix mix = {.count = 0};
                uint8_t *head = mix.bytes + tape->message[i];
                add(&mix, tape, 0, tape->messages);
                if (head[STREAM_AT_TYPE] != STREAM_BAND)
                    continue;
                head[fields[k].at] = (uint8_t)((head[fields[k].at] + fields[k].more) & 255);
                tape_check(head);
                assert_int_equal(show(&mix, tape, NULL).view.shown,
                                 tape_left_by(tape, tape->message[i], tape->message[i + 1]));
            }
}

/* As from a line that echoes. */
static void what_a_host_says_is_passed_over(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned at = 0; at <= tape->messages; at++) {
            struct mix mix = {.count = 0};
            uint8_t request[STREAM_HEADER];
            port_message(request, STREAM_KEY_PLEASE, 0, (uint16_t)at);
            add(&mix, tape, 0, at);
            memcpy(mix.bytes + mix.count, request, sizeof request);
            mix.count += sizeof request;
            add(&mix, tape, at, tape->messages);
            assert_int_equal(show(&mix, tape, NULL).view.shown, TAPE_ALL);
        }
}

/* All of its messages are there, and the picture before is too: it must not be called a key frame all the same. */
static void a_key_frame_refers_to_no_other(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned i = 1; i < TAPE_COUNT; i++) {
            struct mix mix = {.count = 0};
            uint8_t *head = mix.bytes + tape->begin[i];
            const uint8_t *band = head + tape_message(tape->out.bytes + tape->begin[i]);
            add(&mix, tape, 0, tape->messages);
            head[STREAM_HEADER + 8] |= STREAM_KEY;
            tape_check(head);
            if (band[STREAM_AT_CODEC] == STREAM_CHANGE)
                assert_int_equal(show(&mix, tape, NULL).view.shown, tape_left_by(tape, tape->begin[i], tape->end[i]));
        }
}

static void size_and_format_change_with_a_key_frame(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned format = 0; format < STREAM_FORMATS; format++)
            for (unsigned first = 0; first < 2; first++) { /* with hello before it, and without */
                struct mix mix = {.count = 0};
                add(&mix, tape, 0, tape->messages);
                size_t at = mix.count;
                add(&mix, &others[format], first, others[format].messages);
                for (unsigned i = tape->messages; at < mix.count; at += tape_message(mix.bytes + at), i++) {
                    tape_put(mix.bytes + at + STREAM_AT_SEQUENCE, 2, TAPE_SEQUENCE + i);
                    tape_check(mix.bytes + at);
                }
                struct seen seen = show(&mix, tape, &others[format]);
                assert_int_equal(seen.view.shown, TAPE_ALL);
                assert_int_equal(seen.others, TAPE_COUNT);
                assert_int_equal(seen.view.frames.lost, 0);
            }
}

/* In order, as far as the sequence goes: only a line, or what is not known, may come between bands. */
static void hello_within_a_frame_spoils_it(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned type = STREAM_HELLO; type <= STREAM_LOG + 1; type += STREAM_LOG)
            for (unsigned at = 0; at <= tape->messages; at++) {
                struct mix mix = {.count = 0};
                add(&mix, tape, 0, at);
                uint8_t *head = add(&mix, tape, 0, 1);
                head[STREAM_AT_TYPE] = (uint8_t)type;
                add(&mix, tape, at, tape->messages);
                renumber(&mix);
                size_t place = tape->message[at];
                bool within = false;
                for (unsigned i = 0; i < TAPE_COUNT; i++)
                    within = within || (tape->begin[i] < place && place < tape->end[i]);
                assert_int_equal(show(&mix, tape, NULL).view.shown,
                                 within && type == STREAM_HELLO ? tape_left_by(tape, place, place) : TAPE_ALL);
            }
}

/* Even if it went on where the one before stopped: nothing is known of what it refers to. */
static void another_sender_begins_with_a_key_frame(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned i = 0; i < tape->messages; i++) {
            struct stream_case_view view;
            tape_watch(tape, &view);
            frames_push(&view.frames, tape->out.bytes, tape->message[i] + 7);
            frames_restart(&view.frames);
            assert_true(view.frames.want_key);
            view.shown = 0;
            stream_case_take(&view, tape->out.bytes + tape->message[i], tape->out.count - tape->message[i]);
            assert_int_equal(view.wrong, 0);
            assert_int_equal(view.shown, tape_left_by(tape, 0, tape->message[i]));
        }
}

/* The sequence passes 65535 at each of the tape's messages. */
static void the_sequence_goes_on_at_zero(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++)
        for (unsigned zero = 0; zero <= tape->messages; zero++) {
            struct mix mix = {.count = 0};
            add(&mix, tape, 0, tape->messages);
            unsigned i = 0;
            for (size_t at = 0; at < mix.count; at += tape_message(mix.bytes + at), i++) {
                tape_put(mix.bytes + at + STREAM_AT_SEQUENCE, 2, 65536 + i - zero);
                tape_check(mix.bytes + at);
            }
            struct seen seen = show(&mix, tape, NULL);
            assert_int_equal(seen.view.shown, TAPE_ALL);
            assert_int_equal(seen.view.frames.lost, 0);
        }
}

static void count_picture(void *context, const struct frames_picture *p)
{
    (void)p;
    ++*(unsigned *)context;
}

static void the_number_of_a_frame_goes_on_at_zero(void **state)
{
    (void)state;
    for (const struct tape *tape = tapes; tape < tapes + STREAM_FORMATS; tape++) {
        unsigned pictures = 0;
        const struct frames_events events = {.picture = count_picture, .context = &pictures};
        struct frames frames;
        struct mix mix = {.count = 0};
        add(&mix, tape, 0, tape->messages);
        for (size_t at = 0; at < mix.count; at += tape_message(mix.bytes + at)) {
            uint8_t *head = mix.bytes + at;
            if (head[STREAM_AT_TYPE] != STREAM_BEGIN && head[STREAM_AT_TYPE] != STREAM_END)
                continue;
            tape_put(head + STREAM_HEADER, 4, (uint32_t)(UINT32_MAX - 2 + (uint64_t)head[STREAM_HEADER]));
            tape_check(head);
        }
        frames_open(&frames, &events);
        frames_push(&frames, mix.bytes, mix.count);
        frames_close(&frames);
        assert_int_equal(pictures, TAPE_COUNT);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_message_twice_is_a_gap),
        cmocka_unit_test(two_messages_that_change_places_are_both_lost),
        cmocka_unit_test(a_message_of_another_stream_is_a_gap),
        cmocka_unit_test(two_streams_in_turns_show_whole_key_frames_alone),
        cmocka_unit_test(a_frame_of_another_kind_is_no_next_one),
        cmocka_unit_test(a_frame_of_another_number_is_no_next_one),
        cmocka_unit_test(a_frame_that_lacks_a_message_is_none),
        cmocka_unit_test(a_band_elsewhere_or_of_another_kind_is_none_of_the_frame),
        cmocka_unit_test(what_a_host_says_is_passed_over),
        cmocka_unit_test(a_key_frame_refers_to_no_other),
        cmocka_unit_test(size_and_format_change_with_a_key_frame),
        cmocka_unit_test(hello_within_a_frame_spoils_it),
        cmocka_unit_test(another_sender_begins_with_a_key_frame),
        cmocka_unit_test(the_sequence_goes_on_at_zero),
        cmocka_unit_test(the_number_of_a_frame_goes_on_at_zero),
    };
    return cmocka_run_group_tests(tests, record, forget);
}

/* SPDX-License-Identifier: MIT */
/* Recorded streams of ten pictures, two of them key frames, in every format; what is left of one after a damage.
 * Include after cmocka.h. */
#ifndef STREAM_TAPE_H
#define STREAM_TAPE_H

#include "random.h"
#include "scene/scene.h"
#include "stream_case.h"

enum {
    TAPE_COUNT = 10,
    TAPE_KEY = 5, /* a key frame, as the first is; hello goes before it */
    TAPE_LOG = 3, /* a line goes before this one, and another between its bands */
    TAPE_MESSAGES = 5 * TAPE_COUNT,
    TAPE_ALL = (1 << TAPE_COUNT) - 1,
    TAPE_SEQUENCE = 65520 /* of the first message: 0 comes in the middle */
};

struct tape {
    enum stream_format format;
    unsigned width, height;
    size_t bytes; /* a picture */
    uint8_t *pictures;
    struct stream_case_bytes out;
    size_t begin[TAPE_COUNT], end[TAPE_COUNT]; /* of each frame's bytes; between are hello and a line */
    size_t message[TAPE_MESSAGES + 1];         /* where each begins, and the end */
    unsigned messages;
};

static inline void tape_put(uint8_t *at, unsigned bytes, uint32_t value)
{
    for (unsigned i = 0; i < bytes; i++)
        at[i] = (uint8_t)(value >> 8 * i & 255);
}

/* The checks of a message that was changed by intent. */
static inline void tape_check(uint8_t *head)
{
    uint32_t crc = scene_crc32(0, head, STREAM_AT_CRC), length = parser_get32(head + STREAM_AT_LENGTH);
    tape_put(head + STREAM_AT_CRC, 4, crc);
    if (length)
        tape_put(head + STREAM_HEADER + length, 4, scene_crc32(crc, head + STREAM_HEADER, length));
}

static inline size_t tape_message(const uint8_t *head)
{
    size_t length = parser_get32(head + STREAM_AT_LENGTH);
    return STREAM_HEADER + (length ? length + STREAM_CHECK : 0);
}

/* A smooth picture, and those after it like the one before but for a few bytes; one is noise, which is sent raw. */
static inline void tape_draw(struct tape *t)
{
    t->pictures = malloc(TAPE_COUNT * t->bytes);
    assert_non_null(t->pictures);
    for (size_t i = 0; i < TAPE_COUNT * t->bytes; i++) {
        uint8_t before = i < t->bytes ? (uint8_t)(i > t->bytes / 2) : t->pictures[i - t->bytes];
        if (i / t->bytes == TAPE_KEY + 1)
            t->pictures[i] = (uint8_t)(random_bits() >> 9 & 255);
        else
            t->pictures[i] = random_between(0, 9) ? before : (uint8_t)random_between(0, 2);
    }
}

/* From a sequence number on; pictures are numbered from `number`. */
static inline void tape_record(struct tape *t, enum stream_format format, unsigned width, unsigned height,
                               unsigned sequence, uint32_t number)
{
    static const char *name = "x";
    const struct stream_names names = {"b", {&name, 1, sizeof name}, {&name, 1, sizeof name}};
    const struct stream_frame frame = {.moment_ms = 40, .budget = 4};
    const struct stream_statistics statistics = {.draw_us = 5};
    unsigned half = (height + 1) / 2;
    *t = (struct tape){.format = format, .width = width, .height = height};
    t->bytes = unpack_row_bytes(format, width) * height;
    tape_draw(t);
    struct stream s = stream_case_open(&t->out, format, width, height, half, true);
    s.sequence = (uint16_t)sequence;
    s.number = number;
    for (unsigned i = 0; i < TAPE_COUNT; i++) {
        const uint8_t *picture = t->pictures + i * t->bytes;
        s.key = i == 0 || i == TAPE_KEY;
        if (s.key)
            stream_hello(&s, &names);
        if (i == TAPE_LOG)
            stream_log(&s, "before");
        t->begin[i] = t->out.count;
        stream_frame_begin(&s, &frame);
        stream_band(&s, picture, 0, (uint16_t)half);
        if (i == TAPE_LOG)
            stream_log(&s, "between");
        stream_band(&s, picture + unpack_row_bytes(format, width) * half, (uint16_t)half, (uint16_t)(height - half));
        assert_int_equal(stream_frame_end(&s, &statistics), 0);
        t->end[i] = t->out.count;
    }
    for (size_t at = 0; at < t->out.count; at += tape_message(t->out.bytes + at))
        t->message[t->messages++] = at;
    t->message[t->messages] = t->out.count;
    free(s.buffer);
    free(s.last);
}

static inline void tape_free(struct tape *t)
{
    free(t->pictures);
    free(t->out.bytes);
}

/* A copy in a block of its size. */
static inline uint8_t *tape_copy(const struct tape *t)
{
    uint8_t *bytes = malloc(t->out.count);
    assert_non_null(bytes);
    memcpy(bytes, t->out.bytes, t->out.count);
    return bytes;
}

static inline void tape_watch(const struct tape *t, struct stream_case_view *view)
{
    stream_case_watch(view, t->pictures, t->bytes, TAPE_COUNT);
}

/* What is spoilt, or was there: from == to says that something foreign came between. */
struct tape_fault {
    size_t from, to;
};

/* The pictures that are shown in spite of faults: bit i for picture i. */
static inline uint64_t tape_left(const struct tape *t, const struct tape_fault *faults, unsigned count)
{
    uint64_t shown = 0;
    bool chained = false;
    for (unsigned i = 0; i < TAPE_COUNT; i++) {
        size_t before = i ? t->end[i - 1] : 0;
        bool whole = true, key = i == 0 || i == TAPE_KEY;
        for (unsigned k = 0; k < count; k++) {
            size_t from = faults[k].from, to = faults[k].to;
            whole = whole && (t->end[i] <= from || t->begin[i] >= to);
            chained =
                chained && (from == to ? from < before || from > t->begin[i] : from >= t->begin[i] || to <= before);
        }
        chained = whole && (chained || key);
        shown |= (uint64_t)chained << i;
    }
    return shown;
}

static inline uint64_t tape_left_by(const struct tape *t, size_t from, size_t to)
{
    return tape_left(t, &(struct tape_fault){from, to}, 1);
}

#endif

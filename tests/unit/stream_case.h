/* SPDX-License-Identifier: MIT */
/* A stream into memory and the pictures that come out of it. Include after cmocka.h. */
#ifndef STREAM_CASE_H
#define STREAM_CASE_H

#include "glint.h"
#include "stream/stream.h"
#include "view/frames.h"
#include "view/unpack.h"

#include <stdlib.h>
#include <string.h>

static const struct pack_format *const stream_case_formats[STREAM_FORMATS] = {&pack_rgb565, &pack_rgb888, &pack_grey8,
                                                                              &pack_grey4};

struct stream_case_bytes {
    uint8_t *bytes;
    size_t count, room;
    size_t stop_at; /* if not 0: a write beyond fails */
};

static inline int stream_case_write(void *context, const void *bytes, size_t size)
{
    struct stream_case_bytes *out = context;
    if (out->stop_at && out->count + size > out->stop_at)
        return -7;
    if (out->count + size > out->room) {
        out->room = 2 * (out->count + size);
        out->bytes = realloc(out->bytes, out->room);
        assert_non_null(out->bytes);
    }
    memcpy(out->bytes + out->count, bytes, size);
    out->count += size;
    return 0;
}

/* A stream whose buffer holds exactly `rows` rows, and with memory of the last picture or none. */
static inline struct stream stream_case_open(struct stream_case_bytes *out, enum stream_format format, unsigned width,
                                             unsigned height, unsigned rows, bool last)
{
    size_t row = unpack_row_bytes(format, width);
    struct stream s = {.write = stream_case_write,
                       .context = out,
                       .pixels = stream_case_formats[format],
                       .width = (uint16_t)width,
                       .height = (uint16_t)height,
                       .buffer = malloc(row * rows),
                       .buffer_bytes = (uint32_t)(row * rows),
                       .last = last ? malloc(row * height) : NULL};
    assert_non_null(s.buffer);
    return s;
}

static inline void stream_case_close(struct stream *s, struct stream_case_bytes *out)
{
    free(s->buffer);
    free(s->last);
    free(out->bytes);
    *out = (struct stream_case_bytes){0};
}

/* A whole picture, in bands of `rows`: the first error. */
static inline int stream_case_send(struct stream *s, const uint8_t *pixels, unsigned rows)
{
    static const struct stream_frame frame = {.moment_ms = 40, .scene = 1, .method = 2, .budget = 4};
    static const struct stream_statistics statistics = {.draw_us = 5, .triangles = 6};
    size_t row = unpack_row_bytes(s->pixels->format, s->width);
    int error = stream_frame_begin(s, &frame);
    for (unsigned y = 0; y < s->height && !error; y += rows)
        error = stream_band(s, pixels + y * row, (uint16_t)y, (uint16_t)(y + rows > s->height ? s->height - y : rows));
    return error ? error : stream_frame_end(s, &statistics);
}

/* What must come out: picture i of the stream is pictures + i * bytes. What is shown is checked off. */
struct stream_case_view {
    struct frames frames;
    const uint8_t *pictures;
    size_t bytes;
    uint32_t count;
    uint64_t shown; /* bit i: picture i */
    uint32_t wrong;
};

static inline void stream_case_shown(void *context, const struct frames_picture *p)
{
    struct stream_case_view *view = context;
    if (p->number >= view->count || unpack_row_bytes(p->format, p->width) * p->height != view->bytes ||
        memcmp(p->pixels, view->pictures + p->number * view->bytes, view->bytes) != 0)
        view->wrong++;
    else
        view->shown |= (uint64_t)1 << p->number;
}

static inline void stream_case_watch(struct stream_case_view *view, const uint8_t *pictures, size_t bytes,
                                     uint32_t count)
{
    const struct frames_events events = {.picture = stream_case_shown, .context = view};
    *view = (struct stream_case_view){.pictures = pictures, .bytes = bytes, .count = count};
    frames_open(&view->frames, &events);
}

/* All of a stream at once. */
static inline void stream_case_take(struct stream_case_view *view, const uint8_t *bytes, size_t count)
{
    frames_push(&view->frames, bytes, count);
    frames_finish(&view->frames);
    frames_close(&view->frames);
}

#endif

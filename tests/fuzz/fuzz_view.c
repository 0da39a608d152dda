/* SPDX-License-Identifier: MIT */
/* The viewer: whatever bytes come, in whatever pieces, and behind another sender's, a picture is shown only if each of
 * its messages came whole, in order, since a key frame; memory stays within what was pushed; and a key frame after all
 * that is always shown. */
#include "fuzz/fuzz.h"
#include "stream/stream.h"
#include "view/frames.h"
#include "view/unpack.h"

#include <zlib.h>

/* Damaged payloads that the parser pays for in any case: it may then pass over what a header claims, and a key frame in
 * it (PROTOCOL.md, "The viewer"). */
#define PAID 16u

/* Allocations up to the one that is refused, as by a machine without memory; 0: none is. */
static uint32_t until_refused;

void *__real_malloc(size_t bytes);
void *__wrap_malloc(size_t bytes);
void *__real_realloc(void *block, size_t bytes);
void *__wrap_realloc(void *block, size_t bytes);

static bool refused(void)
{
    return until_refused && --until_refused == 0;
}

void *__wrap_malloc(size_t bytes)
{
    return refused() ? NULL : __real_malloc(bytes);
}

void *__wrap_realloc(void *block, size_t bytes)
{
    return refused() ? NULL : __real_realloc(block, bytes);
}

/* A viewer and what it should be doing, by a shorter way: without pixels, and told of every message. */
struct watch {
    struct frames frames;
    parser_take *take; /* the viewer's own */
    size_t pushed;
    /* of the frame under way, and since the last key frame */
    bool begun, sound, started;
    bool plain; /* all of its bands are raw and of the right size */
    uint32_t number, rows, bands, width, height, format;
    uint16_t sequence, echo;
    /* what was shown */
    uint32_t shown, sum;
    bool marked; /* the last one is the key frame that was appended */
};

enum { MARK_WIDTH = 3, MARK_HEIGHT = 2, MARK_NUMBER = 0x4D41524B };
static const uint8_t mark[MARK_WIDTH * MARK_HEIGHT] = {9, 9, 200, 9, 30, 31};

static void watch_begin(struct watch *w, const struct parser_message *m)
{
    uint32_t number = parser_get32(m->payload);
    bool key = m->payload[8] & STREAM_KEY;
    bool next = number == (uint32_t)(((uint64_t)w->number + 1) & UINT32_MAX) && m->width == w->width &&
                m->height == w->height && m->format == w->format;
    w->sound = key || (w->sound && !w->begun && next);
    w->begun = w->plain = true;
    w->number = number;
    w->rows = w->bands = 0;
    w->width = m->width;
    w->height = m->height;
    w->format = m->format;
    w->echo = m->x;
}

/* Ahead of the viewer. */
static void watch_take(void *context, const struct parser_message *m)
{
    struct watch *w = (struct watch *)((uint8_t *)context - offsetof(struct watch, frames));
    const uint8_t *from = w->frames.parser.bytes, *head = m->payload - STREAM_HEADER;
    uint32_t check = crc32(0, head, STREAM_AT_CRC);
    FUZZ_CHECK(head >= from && m->payload + m->length + (m->length ? 4 : 0) <= from + w->frames.parser.count);
    FUZZ_CHECK(check == parser_get32(head + STREAM_AT_CRC));
    FUZZ_CHECK(!m->length || crc32(check, m->payload, m->length) == parser_get32(m->payload + m->length));
    if (m->type < STREAM_KEY_PLEASE) {
        w->sound = w->sound && w->started && m->sequence == w->sequence;
        w->begun = w->begun && w->started && m->sequence == w->sequence;
        w->started = true;
        w->sequence = (uint16_t)((m->sequence + 1) & 0xFFFF);
    }
    w->sound = w->sound && !(w->begun && m->type == STREAM_HELLO);
    if (m->type == STREAM_BEGIN)
        watch_begin(w, m);
    if (m->type == STREAM_BAND && w->begun) {
        w->sound = w->sound && m->x == 0 && m->y == w->rows && m->width == w->width && m->format == w->format;
        w->plain = w->plain && m->codec == STREAM_RAW && m->length == unpack_row_bytes(m->format, m->width) * m->height;
        w->rows += m->height;
        w->bands++;
    }
    uint32_t shown = w->shown;
    w->take(context, m);
    FUZZ_CHECK(w->shown == shown || m->type == STREAM_END);
    if (m->type == STREAM_END && w->begun) {
        bool right = w->sound && w->rows == w->height && parser_get32(m->payload) == w->number &&
                     parser_get32(m->payload + 4) == w->bands;
        FUZZ_CHECK(w->shown == shown ? !right || !w->plain || w->frames.parser.out_of_memory : right);
        w->begun = false;
        w->sound = w->shown != shown;
    }
}

static void watch_shown(void *context, const struct frames_picture *p)
{
    struct watch *w = context;
    size_t bytes = unpack_row_bytes(p->format, p->width) * p->height;
    FUZZ_CHECK(w->begun && w->sound && p->number == w->number);
    FUZZ_CHECK(p->width == w->width && p->height == w->height && p->format == w->format && w->rows == p->height);
    FUZZ_CHECK(p->bands[STREAM_RAW] + p->bands[STREAM_QOI] + p->bands[STREAM_CHANGE] == w->bands);
    FUZZ_CHECK(p->echo == w->echo);
    FUZZ_CHECK(!p->key || p->bands[STREAM_CHANGE] == 0);
    w->sum = (uint32_t)crc32(crc32(w->sum, (const uint8_t *)&p->number, sizeof p->number), p->pixels, (uInt)bytes);
    w->shown++;
    w->marked = p->number == MARK_NUMBER && bytes == sizeof mark && memcmp(p->pixels, mark, bytes) == 0;
}

static void watch_text(void *context, const char *text, uint32_t length)
{
    struct watch *w = context;
    FUZZ_CHECK(length > 0);
    w->sum = (uint32_t)crc32(w->sum, (const uint8_t *)text, length);
}

static void watch_hello(void *context, const char *text, uint32_t length)
{
    FUZZ_CHECK(text[length - 1] == 0);
    watch_text(context, text, length);
}

static void watch_open(struct watch *w)
{
    *w = (struct watch){.pushed = 0};
    const struct frames_events events = {watch_shown, watch_hello, watch_text, w};
    frames_open(&w->frames, &events);
    w->take = w->frames.parser.take;
    w->frames.parser.take = watch_take;
}

/* From a block of their size, which is gone afterwards. */
static void watch_push(struct watch *w, const uint8_t *bytes, size_t size)
{
    const struct parser *p = &w->frames.parser;
    uint8_t *block = fuzz_block(size);
    if (size)
        memcpy(block, bytes, size);
    frames_push(&w->frames, block, size);
    free(block);
    w->pushed += size;
    FUZZ_CHECK(p->out_of_memory || (p->count <= p->room && p->room <= 2 * w->pushed && (!size || p->count < p->need)));
    FUZZ_CHECK(p->need <= STREAM_HEADER + 3 * 2048 * 2048 + STREAM_CHECK);
}

/* A part, and another sender: from here on it is as new. */
static void watch_restart(struct watch *w, const uint8_t *data, size_t size)
{
    watch_push(w, data, size);
    frames_restart(&w->frames);
    FUZZ_CHECK(w->frames.parser.count == 0 && w->frames.want_key);
    w->begun = w->sound = w->started = false;
    w->shown = w->sum = w->frames.lost = 0;
}

/* In pieces of sizes that the bytes themselves give: all at once for those of even sums. */
static void watch_pieces(struct watch *w, const uint8_t *data, size_t size)
{
    uint32_t dice = (uint32_t)crc32(0, data, (uInt)size);
    unsigned most = (dice & 15) * (dice & 15) + 1;
    for (size_t piece; size; size -= piece, data += piece) {
        dice = (uint32_t)(((uint64_t)dice * 747796405u + 2891336453u) & UINT32_MAX);
        piece = (dice >> 16) % most + 1;
        piece = piece < size ? piece : size;
        watch_push(w, data, piece);
    }
}

static int mark_write(void *context, const void *bytes, size_t size)
{
    watch_push(context, bytes, size);
    return 0;
}

static void push_mark(struct watch *w, unsigned sequence)
{
    uint8_t buffer[sizeof mark];
    struct stream s = {.write = mark_write,
                       .context = w,
                       .pixels = &pack_grey8,
                       .width = MARK_WIDTH,
                       .height = MARK_HEIGHT,
                       .buffer = buffer,
                       .buffer_bytes = sizeof buffer,
                       .number = MARK_NUMBER,
                       .sequence = (uint16_t)sequence};
    const struct stream_frame frame = {.moment_ms = 0};
    const struct stream_statistics statistics = {.draw_us = 0};
    stream_frame_begin(&s, &frame);
    stream_band(&s, mark, 0, MARK_HEIGHT);
    stream_frame_end(&s, &statistics);
}

/* Without memory it says so, and shows no more. */
static void without_memory(const uint8_t *data, size_t size, uint32_t allocations)
{
    struct watch w;
    watch_open(&w);
    until_refused = allocations;
    frames_push(&w.frames, data, size);
    w.pushed = size;
    bool said = w.frames.parser.out_of_memory;
    FUZZ_CHECK(said == (until_refused == 0));
    until_refused = 0;
    uint32_t shown = w.shown;
    push_mark(&w, 0);
    frames_finish(&w.frames);
    FUZZ_CHECK(!said || w.shown == shown);
    frames_close(&w.frames);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct watch whole, pieces;
    watch_open(&whole);
    watch_push(&whole, data, size);
    watch_open(&pieces);
    watch_restart(&pieces, data, size / 3 * 2);
    watch_pieces(&pieces, data, size);
    if (whole.frames.parser.damaged <= PAID && pieces.frames.parser.damaged <= PAID)
        FUZZ_CHECK(whole.shown == pieces.shown && whole.sum == pieces.sum && whole.frames.lost == pieces.frames.lost &&
                   whole.frames.want_key == pieces.frames.want_key);
    FUZZ_CHECK(!whole.frames.parser.out_of_memory && (whole.frames.want_key || whole.shown));
    /* as the next message, or any other */
    push_mark(&pieces, size & 1 ? pieces.frames.sequence : (unsigned)size);
    frames_finish(&pieces.frames);
    FUZZ_CHECK(pieces.frames.parser.count == 0 && !pieces.frames.begun);
    FUZZ_CHECK(pieces.marked || pieces.frames.parser.damaged > PAID);
    frames_finish(&whole.frames);
    if (size)
        without_memory(data, size, whole.sum % 6 + 1);
    frames_close(&whole.frames);
    frames_close(&pieces.frames);
    return 0;
}

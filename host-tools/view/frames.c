/* SPDX-License-Identifier: MIT */
#include "view/frames.h"

#include "fixed/fixed.h"
#include "view/unpack.h"

#include <stdlib.h>
#include <string.h>

/* A picture cannot be had any more, nor those that refer to it. */
static void frames_lose(struct frames *f)
{
    f->lost += f->begun;
    f->begun = f->chained = false;
    f->want_key = true;
}

static bool frames_room(struct frames *f, const struct parser_message *m)
{
    const struct frames_picture *p = &f->picture;
    if (f->next && p->width == m->width && p->height == m->height && p->format == m->format)
        return true;
    size_t bytes = unpack_row_bytes(m->format, m->width) * m->height;
    free(f->next);
    free(f->last);
    f->next = malloc(bytes);
    f->last = malloc(bytes);
    f->parser.out_of_memory |= !f->next || !f->last;
    return f->next && f->last;
}

/* A frame that refers to the last one must be the next of the same kind; the last number is followed by 0. */
FX_WRAPS static bool frames_follows(const struct frames *f, const struct parser_message *m)
{
    const struct frames_picture *p = &f->picture;
    return f->chained && p->width == m->width && p->height == m->height && p->format == m->format &&
           p->number + 1 == parser_get32(m->payload);
}

static void frames_begin(struct frames *f, const struct parser_message *m)
{
    bool key = m->payload[8] & STREAM_KEY;
    if (f->begun)
        frames_lose(f);
    if ((!key && !frames_follows(f, m)) || !frames_room(f, m)) {
        frames_lose(f);
        return;
    }
    f->picture = (struct frames_picture){.width = m->width,
                                         .height = m->height,
                                         .format = m->format,
                                         .number = parser_get32(m->payload),
                                         .moment_ms = parser_get32(m->payload + 4),
                                         .time_us = m->time_us,
                                         .echo = m->x,
                                         .key = key,
                                         .paused = m->payload[8] & STREAM_PAUSED,
                                         .scene = m->payload[9],
                                         .method = m->payload[10],
                                         .budget = m->payload[11]};
    f->begun = true;
    f->next_row = f->band_count = 0;
}

static bool frames_rows(struct frames *f, const struct parser_message *m)
{
    const struct frames_picture *p = &f->picture;
    if (m->x != 0 || m->width != p->width || m->y != f->next_row || m->height > p->height - m->y ||
        m->format != p->format || (m->codec == STREAM_CHANGE && p->key))
        return false;
    size_t stride = unpack_row_bytes(p->format, p->width), bytes = stride * m->height, offset = stride * m->y;
    struct unpack_rows rows = {.packed = m->payload,
                               .packed_bytes = m->length,
                               .pixels = f->next + offset,
                               .last = m->codec == STREAM_CHANGE ? f->last + offset : NULL,
                               .bytes = bytes,
                               .stride = stride,
                               .format = p->format};
    if (m->codec != STREAM_RAW)
        return unpack_rows(&rows);
    if (m->length == bytes)
        memcpy(rows.pixels, m->payload, bytes);
    return m->length == bytes;
}

static void frames_band(struct frames *f, const struct parser_message *m)
{
    if (!f->begun)
        return;
    if (!frames_rows(f, m)) {
        frames_lose(f);
        return;
    }
    f->next_row += m->height;
    f->band_count++;
    f->picture.bands[m->codec]++;
    f->picture.packed[m->codec] += m->length;
}

static void frames_end(struct frames *f, const struct parser_message *m)
{
    struct frames_picture *p = &f->picture;
    const uint8_t *at = m->payload;
    if (!f->begun)
        return;
    if (f->next_row != p->height || parser_get32(at) != p->number || parser_get32(at + 4) != f->band_count) {
        frames_lose(f);
        return;
    }
    p->draw_us = parser_get32(at + 8);
    p->pack_us = parser_get32(at + 12);
    p->triangles = parser_get32(at + 16);
    p->drawn = parser_get32(at + 20);
    p->dropped = parser_get32(at + 24);
    p->skipped = parser_get32(at + 28);
    p->pixels = f->next;
    f->next = f->last;
    f->last = (uint8_t *)(uintptr_t)p->pixels;
    f->begun = false;
    f->chained = true;
    f->want_key = false;
    f->pictures++;
    if (f->events.picture)
        f->events.picture(f->events.context, p);
}

static void frames_take(void *context, const struct parser_message *m)
{
    struct frames *f = context;
    if (m->type >= STREAM_KEY_PLEASE)
        return;
    if (f->followed && m->sequence != f->sequence)
        frames_lose(f);
    f->followed = true;
    f->sequence = (uint16_t)(m->sequence + 1);
    f->picture.bytes += STREAM_HEADER + (m->length ? m->length + STREAM_CHECK : 0);
    switch (m->type) {
    case STREAM_HELLO:
        if (f->begun) /* which does not go on behind it */
            frames_lose(f);
        if (f->events.hello && m->payload[m->length - 1] == 0)
            f->events.hello(f->events.context, (const char *)m->payload, m->length);
        break;
    case STREAM_BEGIN:
        frames_begin(f, m);
        f->picture.bytes = STREAM_HEADER + STREAM_FRAME_BEGIN + STREAM_CHECK;
        break;
    case STREAM_BAND:
        frames_band(f, m);
        break;
    case STREAM_END:
        frames_end(f, m);
        break;
    case STREAM_LOG:
        if (f->events.log)
            f->events.log(f->events.context, (const char *)m->payload, m->length);
        break;
    default: /* of a later device */
        break;
    }
}

void frames_open(struct frames *f, const struct frames_events *events)
{
    *f = (struct frames){.events = *events, .want_key = true};
    f->parser.take = frames_take;
    f->parser.context = f;
}

void frames_push(struct frames *f, const void *bytes, size_t size)
{
    parser_push(&f->parser, bytes, size);
}

void frames_finish(struct frames *f)
{
    parser_finish(&f->parser);
    if (f->begun)
        frames_lose(f);
}

void frames_restart(struct frames *f)
{
    frames_finish(f);
    f->followed = f->chained = false;
    f->want_key = true;
}

void frames_close(struct frames *f)
{
    parser_close(&f->parser);
    free(f->next);
    free(f->last);
    f->next = f->last = NULL;
}

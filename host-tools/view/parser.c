/* SPDX-License-Identifier: MIT */
#include "view/parser.h"

#include "glint.h"
#include "scene/scene.h"
#include "view/unpack.h"

#include <stdlib.h>
#include <string.h>

#define PARSER_OTHER 65536u /* bytes: the most that a message of a type to come may have */
/* Bytes of damaged payloads that a byte of the stream pays for, and the most that is saved up: bytes that were made to
 * be header in header, each claiming all that follows, would else take the square of their number. */
#define PARSER_SPARE      16u
#define PARSER_SPARE_MOST ((size_t)1 << 28)

uint32_t parser_get16(const uint8_t *at)
{
    return at[0] | (uint32_t)at[1] << 8;
}

uint32_t parser_get32(const uint8_t *at)
{
    return parser_get16(at) | parser_get16(at + 2) << 16;
}

static struct parser_message parser_header(const uint8_t *at)
{
    return (struct parser_message){.type = at[STREAM_AT_TYPE],
                                   .sequence = (uint16_t)parser_get16(at + STREAM_AT_SEQUENCE),
                                   .time_us = parser_get32(at + STREAM_AT_TIME),
                                   .x = (uint16_t)parser_get16(at + STREAM_AT_X),
                                   .y = (uint16_t)parser_get16(at + STREAM_AT_Y),
                                   .width = (uint16_t)parser_get16(at + STREAM_AT_WIDTH),
                                   .height = (uint16_t)parser_get16(at + STREAM_AT_HEIGHT),
                                   .format = at[STREAM_AT_FORMAT],
                                   .codec = at[STREAM_AT_CODEC],
                                   .payload = at + STREAM_HEADER,
                                   .length = parser_get32(at + STREAM_AT_LENGTH)};
}

/* A device sends no such thing: nothing of that length is waited for. */
static bool parser_possible(const struct parser_message *m)
{
    bool sized = m->width >= 1 && m->width <= GLINT_MAX_SIZE && m->height >= 1 && m->height <= GLINT_MAX_SIZE &&
                 m->format < STREAM_FORMATS;
    switch (m->type) {
    case STREAM_HELLO:
        return sized && m->length >= 1 && m->length <= STREAM_MAX_NAMES;
    case STREAM_BEGIN:
        return sized && m->length == STREAM_FRAME_BEGIN;
    case STREAM_BAND:
        return sized && m->codec < STREAM_CODECS && m->length >= 1 &&
               m->length <= unpack_row_bytes(m->format, m->width) * m->height;
    case STREAM_END:
        return m->length == STREAM_FRAME_END;
    case STREAM_LOG:
        return m->length >= 1 && m->length <= STREAM_MAX_LOG;
    default:
        return m->length <= PARSER_OTHER;
    }
}

/* Looks at bytes[0 ..): how many of them are done with; 0 if more are needed. */
static size_t parser_look(struct parser *p, const uint8_t *at, size_t count)
{
    static const uint8_t magic[4] = {STREAM_MAGIC & 255, STREAM_MAGIC >> 8 & 255, STREAM_MAGIC >> 16 & 255,
                                     STREAM_MAGIC >> 24};
    const uint8_t *begin = memchr(at, magic[0], count);
    if (!begin)
        return count;
    if (begin != at)
        return (size_t)(begin - at);
    if (memcmp(at, magic, count < 4 ? count : 4) != 0)
        return 1;
    p->need = STREAM_HEADER;
    if (count < STREAM_HEADER)
        return 0;
    uint32_t crc = scene_crc32(0, at, STREAM_AT_CRC);
    if (crc != parser_get32(at + STREAM_AT_CRC))
        return 1;
    struct parser_message message = parser_header(at);
    if (at[STREAM_AT_VERSION] != STREAM_VERSION || !parser_possible(&message)) {
        p->other_version += at[STREAM_AT_VERSION] != STREAM_VERSION;
        return 1;
    }
    p->need = STREAM_HEADER + (message.length ? message.length + STREAM_CHECK : 0);
    if (count < p->need)
        return 0;
    crc = scene_crc32(crc, message.payload, message.length);
    if (message.length && crc != parser_get32(message.payload + message.length)) {
        p->damaged++;
        if (p->spare < message.length)
            return p->need;
        p->spare -= message.length;
        return 1;
    }
    p->messages++;
    p->take(p->context, &message);
    return p->need;
}

/* `last`: what waits for more will not get it. */
static void parser_run(struct parser *p, bool last)
{
    size_t at = 0;
    /*@ loop invariant at <= p->count && p->spare <= PARSER_SPARE_MOST;
        loop assigns at, p->need, p->spare, p->damaged, p->other_version, p->messages, p->out_of_memory;
        loop variant p->count - at; */
    while (at < p->count && !p->out_of_memory) {
        size_t step = parser_look(p, p->bytes + at, p->count - at);
        if (step == 0 && !last)
            break;
        at += step ? step : 1;
    }
    p->count -= at;
    memmove(p->bytes, p->bytes + at, p->count);
    if (p->count == 0)
        p->need = 1;
}

void parser_push(struct parser *p, const void *bytes, size_t size)
{
    if (p->out_of_memory || size == 0)
        return;
    if (size > p->room - p->count) {
        size_t room = 2 * (p->count + size);
        uint8_t *larger = realloc(p->bytes, room);
        p->out_of_memory = larger == NULL;
        if (!larger)
            return;
        p->bytes = larger;
        p->room = room;
    }
    memcpy(p->bytes + p->count, bytes, size);
    p->count += size;
    p->spare += PARSER_SPARE * size;
    p->spare = p->spare < PARSER_SPARE_MOST ? p->spare : PARSER_SPARE_MOST;
    if (p->count >= p->need)
        parser_run(p, false);
}

void parser_finish(struct parser *p)
{
    if (p->count)
        parser_run(p, true);
}

void parser_close(struct parser *p)
{
    free(p->bytes);
    p->bytes = NULL;
    p->count = p->room = 0;
}

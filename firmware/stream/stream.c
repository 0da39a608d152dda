/* SPDX-License-Identifier: MIT */
#include "stream/stream.h"

#include "scene/scene.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "headers and raw pixels are sent as they lie in memory");

/* A header's members where protocol.h has them. */
struct stream_header {
    uint32_t magic;
    uint8_t version, type;
    uint16_t sequence;
    uint32_t time_us;
    uint16_t x, y, width, height;
    uint8_t format, codec;
    uint16_t zero;
    uint32_t length, crc;
};
_Static_assert(sizeof(struct stream_header) == STREAM_HEADER && offsetof(struct stream_header, crc) == STREAM_AT_CRC &&
                   offsetof(struct stream_header, x) == STREAM_AT_X,
               "without gaps");

static void stream_out(struct stream *s, const void *bytes, uint32_t size)
{
    if (!s->error)
        s->error = s->write(s->context, bytes, size);
}

/* A part of the payload. */
static void stream_add(struct stream *s, const void *bytes, uint32_t size)
{
    s->crc = scene_crc32(s->crc, bytes, size);
    stream_out(s, bytes, size);
}

/* The header of a message; its payload is to be added. */
static void stream_head(struct stream *s, enum stream_type type, uint16_t y, uint16_t rows, enum stream_codec codec,
                        uint32_t length)
{
    struct stream_header head = {.magic = STREAM_MAGIC,
                                 .version = STREAM_VERSION,
                                 .type = (uint8_t)type,
                                 .sequence = s->sequence,
                                 .time_us = s->time_us,
                                 .x = type == STREAM_BEGIN ? s->heard : 0,
                                 .y = y,
                                 .width = s->width,
                                 .height = rows,
                                 .format = s->pixels->format,
                                 .codec = (uint8_t)codec,
                                 .length = length};
    head.crc = s->crc = scene_crc32(0, &head, STREAM_AT_CRC);
    s->sequence = (uint16_t)((s->sequence + 1) & 0xFFFF);
    s->error = 0;
    stream_out(s, &head, STREAM_HEADER);
}

/* What follows a payload. After an error the other end lacks this frame, and what refers to it would be of no use. */
static int stream_tail(struct stream *s)
{
    const uint32_t crc = s->crc;
    stream_out(s, &crc, STREAM_CHECK);
    if (s->error)
        s->key = 1;
    return s->error;
}

static uint32_t stream_length(const char *text)
{
    uint32_t length = 0;
    while (text[length])
        length++;
    return length;
}

static const char *stream_name(const struct stream_list *list, uint32_t index)
{
    return *(const char *const *)(const void *)((const uint8_t *)list->first + index * list->size);
}

/* The names of a list, a zero after each; or their bytes alone, if not to be sent. */
static uint32_t stream_names(struct stream *s, const struct stream_list *list, int send)
{
    uint32_t bytes = 0;
    for (uint32_t i = 0; i < list->count; i++) {
        const char *name = stream_name(list, i);
        uint32_t length = stream_length(name) + 1;
        if (send)
            stream_add(s, name, length);
        bytes += length;
    }
    return bytes;
}

int stream_hello(struct stream *s, const struct stream_names *names)
{
    uint32_t board = stream_length(names->board) + 1;
    uint32_t length = board + stream_names(s, &names->scenes, 0) + 1 + stream_names(s, &names->methods, 0);
    stream_head(s, STREAM_HELLO, 0, s->height, STREAM_RAW, length);
    stream_add(s, names->board, board);
    stream_names(s, &names->scenes, 1);
    stream_add(s, "", 1);
    stream_names(s, &names->methods, 1);
    return stream_tail(s);
}

int stream_log(struct stream *s, const char *text)
{
    uint32_t length = stream_length(text);
    length = length < STREAM_MAX_LOG ? length : STREAM_MAX_LOG;
    if (length == 0)
        return 0;
    stream_head(s, STREAM_LOG, 0, 0, STREAM_RAW, length);
    stream_add(s, text, length);
    return stream_tail(s);
}

static uint32_t stream_row_bytes(const struct stream *s)
{
    return ((uint32_t)s->width * s->pixels->bits + 7) / 8;
}

uint32_t stream_rows(const struct stream *s)
{
    return s->buffer_bytes / stream_row_bytes(s);
}

int stream_frame_begin(struct stream *s, const struct stream_frame *frame)
{
    s->chained = s->last && s->number && !s->key;
    s->key = 0;
    s->bands = 0;
    const uint32_t flags = (s->chained ? 0 : STREAM_KEY) | (frame->paused ? STREAM_PAUSED : 0);
    const uint32_t begin[STREAM_FRAME_BEGIN / 4] = {s->number, frame->moment_ms,
                                                    flags | (uint32_t)frame->scene << 8 |
                                                        (uint32_t)frame->method << 16 | (uint32_t)frame->budget << 24};
    stream_head(s, STREAM_BEGIN, 0, s->height, STREAM_RAW, sizeof begin);
    stream_add(s, begin, sizeof begin);
    return stream_tail(s);
}

/* Rows that the buffer has room for. */
static int stream_part(struct stream *s, const uint8_t *pixels, uint16_t y, uint16_t rows)
{
    uint32_t stride = stream_row_bytes(s), bytes = rows * stride;
    uint8_t *last = s->last ? s->last + y * stride : 0;
    struct pack_rows part = {pixels, s->chained ? last : 0, bytes, stride, s->buffer, bytes - 1};
    uint32_t packed = s->pixels->pack(&part);
    enum stream_codec codec = packed == 0 ? STREAM_RAW : part.last ? STREAM_CHANGE : STREAM_QOI;
    stream_head(s, STREAM_BAND, y, rows, codec, packed ? packed : bytes);
    stream_add(s, packed ? s->buffer : pixels, packed ? packed : bytes);
    s->bands++;
    if (last)
        __builtin_memcpy(last, pixels, bytes);
    return stream_tail(s);
}

int stream_band(struct stream *s, const void *pixels, uint16_t y, uint16_t rows)
{
    uint32_t stride = stream_row_bytes(s), most = stream_rows(s), end = (uint32_t)y + rows;
    const uint8_t *at = pixels;
    int error = 0;
    for (uint32_t row = y; row < end && !error; row += most, at += most * stride)
        error = stream_part(s, at, (uint16_t)row, (uint16_t)(end - row < most ? end - row : most));
    return error;
}

int stream_frame_end(struct stream *s, const struct stream_statistics *statistics)
{
    const uint32_t end[STREAM_FRAME_END / 4] = {s->number,
                                                s->bands,
                                                statistics->draw_us,
                                                statistics->pack_us,
                                                statistics->triangles,
                                                statistics->drawn,
                                                statistics->dropped,
                                                statistics->skipped};
    s->number++;
    stream_head(s, STREAM_END, 0, 0, STREAM_RAW, sizeof end);
    stream_add(s, end, sizeof end);
    return stream_tail(s);
}

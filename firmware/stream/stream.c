/* SPDX-License-Identifier: MIT */
#include "stream/stream.h"

#include "scene/scene.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "raw pixels are sent as they lie in memory");

static void stream_put16(uint8_t *at, uint32_t value)
{
    at[0] = (uint8_t)value;
    at[1] = (uint8_t)(value >> 8);
}

static void stream_put32(uint8_t *at, uint32_t value)
{
    stream_put16(at, value);
    stream_put16(at + 2, value >> 16);
}

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
    uint8_t head[STREAM_HEADER] = {0};
    stream_put32(head + STREAM_AT_MAGIC, STREAM_MAGIC);
    head[STREAM_AT_VERSION] = STREAM_VERSION;
    head[STREAM_AT_TYPE] = (uint8_t)type;
    stream_put16(head + STREAM_AT_SEQUENCE, s->sequence);
    s->sequence = (uint16_t)((s->sequence + 1) & 0xFFFF);
    stream_put32(head + STREAM_AT_TIME, s->time_us);
    stream_put16(head + STREAM_AT_X, type == STREAM_BEGIN ? s->heard : 0);
    stream_put16(head + STREAM_AT_Y, y);
    stream_put16(head + STREAM_AT_WIDTH, s->width);
    stream_put16(head + STREAM_AT_HEIGHT, rows);
    head[STREAM_AT_FORMAT] = s->pixels->format;
    head[STREAM_AT_CODEC] = (uint8_t)codec;
    stream_put32(head + STREAM_AT_LENGTH, length);
    s->crc = scene_crc32(0, head, STREAM_AT_CRC);
    stream_put32(head + STREAM_AT_CRC, s->crc);
    s->error = 0;
    stream_out(s, head, STREAM_HEADER);
}

/* What follows a payload. After an error the other end lacks this frame, and what refers to it would be of no use. */
static int stream_tail(struct stream *s)
{
    uint8_t crc[STREAM_CHECK];
    stream_put32(crc, s->crc);
    stream_out(s, crc, STREAM_CHECK);
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
    uint8_t begin[STREAM_FRAME_BEGIN];
    s->chained = s->last && s->number && !s->key;
    s->key = 0;
    s->bands = 0;
    stream_put32(begin, s->number);
    stream_put32(begin + 4, frame->moment_ms);
    begin[8] = (uint8_t)((s->chained ? 0 : STREAM_KEY) | (frame->paused ? STREAM_PAUSED : 0));
    begin[9] = frame->scene;
    begin[10] = frame->method;
    begin[11] = frame->budget;
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
    uint8_t end[STREAM_FRAME_END];
    const uint32_t words[STREAM_FRAME_END / 4] = {s->number,
                                                  s->bands,
                                                  statistics->draw_us,
                                                  statistics->pack_us,
                                                  statistics->triangles,
                                                  statistics->drawn,
                                                  statistics->dropped,
                                                  statistics->skipped};
    for (uint32_t i = 0; i < STREAM_FRAME_END / 4; i++)
        stream_put32(end + 4 * i, words[i]);
    s->number++;
    stream_head(s, STREAM_END, 0, 0, STREAM_RAW, sizeof end);
    stream_add(s, end, sizeof end);
    return stream_tail(s);
}

/* SPDX-License-Identifier: MIT */
/*
 * Messages of any picture: what is written lies in the caller's memory and is initialised, whether writing fails or
 * not; a frame takes the bytes that stream.h says at most. Packing (proven by pack.c) leaves any bytes of its room.
 *
 *   proves: stream_out stream_add stream_head stream_tail stream_length stream_name stream_names stream_hello
 *           stream_log stream_row_bytes stream_rows stream_frame_begin stream_part stream_band stream_frame_end
 *   assumes: scene_crc32
 *   options: -eva-precision 3 -eva-slevel 500 -eva-slevel-function stream_length:2000
 */
#include "bytes.h"
#include "proof.h"

#include <string.h>

#define __builtin_memcpy memcpy

#include "firmware/stream/stream.c"

#define WIDTH 5u
#define ROWS  3u
#define BYTES (WIDTH * ROWS * 3)

static uint32_t sent;

static int taken(void *context, const void *bytes, size_t size)
{
    (void)context;
    //@ assert \valid_read((const uint8_t *)bytes + (0 .. size - 1));
    //@ assert \initialized((const uint8_t *)bytes + (0 .. size - 1));
    sent += size;
    return any_s32(-1, 0);
}

static uint32_t packed(const struct pack_rows *rows)
{
    //@ assert \valid_read(rows->pixels + (0 .. rows->bytes - 1));
    //@ assert \initialized(rows->pixels + (0 .. rows->bytes - 1));
    //@ assert rows->last == \null || \valid_read(rows->last + (0 .. rows->bytes - 1));
    //@ assert \valid(rows->out + (0 .. rows->room - 1)) && rows->stride <= rows->bytes;
    any_bytes(rows->out, rows->room);
    return any_u32(0, rows->room);
}

static struct stream any_stream(const struct pack_format *format, uint8_t *buffer, uint32_t room, uint8_t *last)
{
    struct stream s = {.write = taken,
                       .pixels = format,
                       .width = WIDTH,
                       .height = ROWS,
                       .buffer = buffer,
                       .buffer_bytes = room,
                       .last = last};
    any_bytes(&s.time_us, sizeof s - offsetof(struct stream, time_us));
    sent = 0;
    return s;
}

/* Any part of a picture, into a buffer of one to three rows. */
static void bands(uint8_t bits)
{
    const struct pack_format format = {packed, (uint8_t)any_u32(0, 3), bits};
    const uint32_t stride = (WIDTH * bits + 7) / 8;
    uint8_t buffer[BYTES], pixels[BYTES], last[BYTES];
    any_bytes(pixels, sizeof pixels);
    any_bytes(last, sizeof last);
    for (uint16_t most = 1; most <= ROWS; most++)
        for (uint16_t y = 0; y <= ROWS; y++)
            for (uint16_t rows = 0; rows <= ROWS - y; rows++)
                for (int changes = 0; changes < 2; changes++) {
                    struct stream s = any_stream(&format, buffer + BYTES - most * stride, most * stride,
                                                 changes ? last + BYTES - ROWS * stride : 0);
                    s.chained = changes ? any_flag() : 0;
                    stream_band(&s, pixels + BYTES - rows * stride, y, rows);
                    //@ assert sent <= rows * stride + 36 * ((rows + most - 1) / most);
                }
}

static void others(void)
{
    static const struct pack_format format = {packed, 0, 16};
    uint8_t last[2 * WIDTH * ROWS];
    struct stream s = any_stream(&format, 0, 0, any_flag() ? last : 0);
    struct stream_frame frame;
    struct stream_statistics statistics;
    any_bytes(&frame, sizeof frame);
    any_bytes(&statistics, sizeof statistics);
    stream_frame_begin(&s, &frame);
    stream_frame_end(&s, &statistics);
    //@ assert sent <= 116;

    char text[STREAM_MAX_LOG + 8];
    any_bytes(text, sizeof text - 1);
    text[sizeof text - 1] = 0;
    sent = 0;
    stream_log(&s, text);
    //@ assert sent <= STREAM_MAX_LOG + 36;
    char name[4];
    any_bytes(name, sizeof name - 1);
    name[sizeof name - 1] = 0;
    const struct {
        const char *name;
        uint32_t more;
    } list[2] = {{name, 1}, {name, 2}};
    const struct stream_names names = {name, {list, 2, sizeof *list}, {list, (uint16_t)any_u32(0, 2), sizeof *list}};
    stream_hello(&s, &names);
}

void prove(void)
{
    bands(16);
    bands(24);
    bands(4);
    others();
}

/* SPDX-License-Identifier: MIT */
/*
 * Pictures from messages, by induction: from any state between two messages, any message that the parser lets through
 * (parser.c) is taken within the pictures' memory, had or not, and such a state again is left. Packed bytes are
 * unpack.c's. Pictures are up to two pixels by two, which is all that sizes there depend on.
 *
 *   proves: frames_lose frames_room frames_follows frames_begin frames_rows frames_band frames_end frames_take
 *           frames_open frames_push frames_finish frames_restart frames_close
 *   assumes: unpack_rows parser_push parser_finish parser_close
 *   options: -machdep gcc_x86_64 -eva-precision 2 -eva-slevel 500 -eva-split-return auto
 *            -eva-slevel-function prove:0
 */
#include "proof.h"

#include "bytes.h"
#include "view/parser.h"
#include "view/unpack.h"

#include <stdlib.h>

/*@ requires packed: \valid_read(rows) && \valid_read(rows->packed + (0 .. rows->packed_bytes - 1));
    requires whole: 1 <= rows->stride <= rows->bytes && rows->format < STREAM_FORMATS;
    requires pixels: \valid(rows->pixels + (0 .. rows->bytes - 1));
    requires last: rows->last == \null || \valid_read(rows->last + (0 .. rows->bytes - 1));
    requires shown: rows->last == \null || \initialized(rows->last + (0 .. rows->bytes - 1));
    assigns \result, rows->pixels[0 .. rows->bytes - 1] \from rows->packed[0 .. rows->packed_bytes - 1];
    ensures \result == 0 || \result == 1; */
bool unpack_rows(const struct unpack_rows *rows);

/* What they take is here one message at a time; the rest is the parser's own (wp/parser.c). */
/*@ requires \valid(parser);
    assigns parser->count \from *parser; */
void parser_push(struct parser *parser, const void *bytes, size_t size);
/*@ requires \valid(parser);
    assigns parser->count \from *parser; */
void parser_finish(struct parser *parser);
/*@ requires \valid(parser);
    assigns parser->count \from *parser; */
void parser_close(struct parser *parser);

#include "host-tools/view/unpack.c"

#include "host-tools/view/parser.c"

/* Memory, or none: a block that nobody has written, and which ends where it is asked to. */
#define MOST 2                 /* pixels across, and down */
#define LONG (MOST * MOST * 3) /* bytes of a picture */
static uint8_t *blocks[2];
static unsigned taken, there;
static void *had(size_t size)
{
    //@ assert 1 <= size <= LONG && taken < 2;
    uint8_t *block = blocks[taken] + LONG - size;
    return taken++ < there ? block : 0;
}
#define malloc   had
#define free(at) (void)(at)
#include "host-tools/view/frames.c"

static size_t picture_bytes(const struct frames_picture *p)
{
    return unpack_row_bytes(p->format, p->width) * p->height;
}

static void allowed(const struct frames *f)
{
    const size_t bytes = f->next ? picture_bytes(&f->picture) : 0;
    //@ assert !f->begun && !f->chained || f->next != \null;
    if (f->next && !f->parser.out_of_memory) {
        const size_t written = bytes / f->picture.height * f->next_row;
        //@ assert \valid(f->next + (0 .. bytes - 1)) && \valid(f->last + (0 .. bytes - 1)) && f->next != f->last;
        //@ assert f->next_row <= f->picture.height || !f->begun;
        //@ assert !f->chained || f->begun || \initialized(f->last + (0 .. bytes - 1));
        //@ assert !f->begun || f->picture.key || \initialized(f->last + (0 .. bytes - 1));
        //@ assert !f->begun || written == 0 || \initialized(f->next + (0 .. written - 1));
        (void)written;
    }
    (void)bytes;
}

static void shown(void *context, const struct frames_picture *p)
{
    const size_t bytes = picture_bytes(p);
    (void)context;
    //@ assert \initialized(p->pixels + (0 .. bytes - 1));
    (void)bytes;
}

static void told(void *context, const char *text, uint32_t length)
{
    (void)context;
    //@ assert 1 <= length && \valid_read(text + (0 .. length - 1));
}

/* States and messages are told apart where what is left depends on it: Eva joins what a function leaves. Of numbers
 * that are but compared there are two. */
#define NUMBER   0x04030201u
#define SEQUENCE 7u
enum state { NOTHING, WAITING, SHOWN, BEGUN, CHANGES };

static struct frames any_frames(enum state state, enum stream_format format, uint16_t width, uint16_t height,
                                uint16_t rows)
{
    struct frames f;
    const struct frames_events events = {any_flag() ? shown : 0, any_flag() ? told : 0, any_flag() ? told : 0, 0};
    frames_open(&f, &events);
    any_bytes(&f.picture, sizeof f.picture);
    f.pictures = ANY_U32, f.lost = ANY_U32, f.band_count = NUMBER, f.next_row = rows;
    f.sequence = SEQUENCE, f.followed = 1, f.want_key = any_flag();
    f.picture.width = width, f.picture.height = height, f.picture.format = format;
    f.picture.number = NUMBER;
    f.picture.key = state == BEGUN, f.picture.paused = any_flag();
    f.begun = state >= BEGUN;
    f.chained = state == SHOWN || state == CHANGES;
    if (state != NOTHING) {
        const size_t bytes = picture_bytes(&f.picture);
        f.next = blocks[0] + LONG - bytes, f.last = blocks[1] + LONG - bytes;
        any_bytes(f.next, bytes / height * rows);
        if (f.chained)
            any_bytes(f.last, bytes);
    }
    allowed(&f);
    return f;
}

/* A payload of so many bytes, nothing behind them. */
static struct parser_message any_message(enum stream_type type, uint8_t *room, uint32_t size, uint32_t length)
{
    struct parser_message m;
    any_bytes(&m, sizeof m);
    any_bytes(room, size);
    m.type = type;
    m.payload = room + size - length;
    m.length = length;
    m.sequence = SEQUENCE;
    return m;
}

/* The message, as the next, as the first of all, and behind others that were lost. */
static void take(const struct frames *before, struct parser_message *m)
{
    struct frames f = *before;
    frames_take(&f, m);
    allowed(&f);
    f = *before;
    f.followed = 0;
    f.sequence = (uint16_t)any_u32(0, 65535);
    frames_take(&f, m);
    allowed(&f);
    f = *before;
    f.sequence = (uint16_t)any_u32(SEQUENCE + 1, 65535);
    frames_take(&f, m);
    allowed(&f);
}

static void put32(uint8_t *at, uint32_t value)
{
    at[0] = value & 255, at[1] = value >> 8 & 255, at[2] = value >> 16 & 255, at[3] = value >> 24;
}

static void ends(const struct frames *f)
{
    uint8_t room[STREAM_FRAME_END];
    struct parser_message m = any_message(STREAM_END, room, sizeof room, sizeof room);
    //@ loop unroll 4;
    for (unsigned i = 0; i < 4; i++) {
        put32(room, NUMBER + (i & 1));
        put32(room + 4, NUMBER + (i >> 1));
        take(f, &m);
    }
}

static void others(const struct frames *before)
{
    uint8_t room[STREAM_FRAME_END];
    //@ loop unroll 4;
    for (uint32_t length = 1; length < 4; length++) {
        struct parser_message m = any_message(any_flag() ? STREAM_HELLO : STREAM_LOG, room, sizeof room, length);
        take(before, &m);
    }
    struct parser_message m = any_message(any_u32(STREAM_LOG + 1, 255), room, sizeof room, any_u32(0, sizeof room));
    take(before, &m);
    struct frames f = *before;
    frames_push(&f, room, sizeof room);
    frames_restart(&f);
    allowed(&f);
    frames_close(&f);
}

/* With memory for none, one or both of the pictures. */
static void begins(const struct frames *f, enum stream_format format, uint16_t width, uint16_t height)
{
    uint8_t room[STREAM_FRAME_BEGIN];
    //@ loop unroll 4;
    for (unsigned i = 0; i < 4; i++) {
        struct parser_message m = any_message(STREAM_BEGIN, room, sizeof room, sizeof room);
        m.format = format, m.width = width, m.height = height;
        put32(room, NUMBER + (i & 1));
        room[8] = (uint8_t)((room[8] & ~STREAM_KEY) | (i >> 1));
        //@ loop unroll 3;
        for (there = 0; there <= 2; there++) {
            uint8_t next[LONG], last[LONG];
            blocks[0] = next, blocks[1] = last, taken = 0;
            struct frames g = *f;
            frames_take(&g, &m);
            allowed(&g);
        }
        there = 0;
        blocks[0] = blocks[1] = room;
    }
}

static void lost(const struct frames *before, const struct parser_message *m)
{
    struct frames f = *before;
    frames_take(&f, m);
    allowed(&f);
}

/* A band that may be the next, and others: one that is not where it should be, or not of this picture. */
static void bands(const struct frames *f, uint32_t codec, uint16_t height, uint32_t length)
{
    uint8_t room[LONG];
    const struct parser_message any = any_message(STREAM_BAND, room, sizeof room, length);
    struct parser_message m = any;
    m.format = f->picture.format, m.width = f->picture.width, m.height = height, m.codec = codec;
    m.x = 0, m.y = (uint16_t)f->next_row;
    take(f, &m);
    m.x = (uint16_t)any_u32(1, 65535);
    lost(f, &m);
    m.x = 0, m.y = (uint16_t)any_u32(f->next_row + 1, 65535);
    lost(f, &m);
    m.y = (uint16_t)f->next_row, m.width = (uint16_t)any_u32(MOST + 1, 2048);
    lost(f, &m);
    m.width = f->picture.width, m.height = (uint16_t)any_u32(MOST + 1, 2048);
    lost(f, &m);
    m.height = height, m.format = (f->picture.format + any_u32(1, 3)) % STREAM_FORMATS;
    lost(f, &m);
}

static void from(enum state state, enum stream_format format, uint16_t width, uint16_t height, uint16_t rows)
{
    uint8_t next[LONG], last[LONG];
    blocks[0] = next, blocks[1] = last;
    const struct frames f = any_frames(state, format, width, height, rows);
    ends(&f);
    others(&f);
    //@ loop unroll 3;
    for (uint32_t codec = 0; codec < STREAM_CODECS && state >= BEGUN; codec++)
        //@ loop unroll 2;
        for (uint16_t h = 1; h <= MOST; h++) {
            const uint32_t bytes = (uint32_t)unpack_row_bytes(format, width) * h;
            bands(&f, codec, h, bytes);
            bands(&f, codec, h, bytes - 1 ? bytes - 1 : LONG);
        }
    if (rows == 0) {
        begins(&f, format, width, height);
        begins(&f, STREAM_RGB888, MOST, MOST);
        begins(&f, STREAM_GREY4, 1, MOST);
        begins(&f, STREAM_RGB565, MOST, 1);
    }
}

static void pictures(enum stream_format format, uint16_t width, uint16_t height)
{
    //@ loop unroll 3;
    for (uint16_t rows = 0; rows <= height; rows++)
        //@ loop unroll 5;
        for (enum state state = NOTHING; state <= CHANGES; state++)
            from(state, format, width, height, rows);
}

void prove(void)
{
    pictures(STREAM_RGB565, 1, MOST);
    pictures(STREAM_RGB565, MOST, 1);
    pictures(STREAM_RGB888, MOST, MOST);
    pictures(STREAM_GREY8, MOST, MOST);
    pictures(STREAM_GREY4, MOST, MOST);
}

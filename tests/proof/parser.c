/* SPDX-License-Identifier: MIT */
/*
 * The viewer's messages, from bytes of any kind: what a header claims is read after it has come, and the message that
 * is given on lies in those bytes and has the length and the kind that its type must have. Each type is tried with
 * each length that it may have and with every longer one; nothing lies behind the bytes that have come.
 *
 *   proves: parser_get16 parser_get32 parser_header parser_possible parser_look parser_close
 *   assumes: scene_crc32
 *   options: -machdep gcc_x86_64 -eva-precision 3 -eva-slevel 300 -eva-split-return full
 *            -eva-slevel-function looks:0,prove:0
 */
#include "look.h"
#include "proof.h"

#include "host-tools/view/parser.c"

#include "host-tools/view/unpack.c"

#define LONGEST (STREAM_FRAME_END + 1) /* bytes of payload */
#define MOST    (STREAM_HEADER + LONGEST + STREAM_CHECK)

static uint8_t held[1];

static void taken(void *context, const struct parser_message *m)
{
    (void)context;
    //@ assert m->length == 0 || \valid_read(m->payload + (0 .. m->length - 1));
    //@ assert m->type != STREAM_BEGIN || m->length == STREAM_FRAME_BEGIN;
    //@ assert m->type != STREAM_END || m->length == STREAM_FRAME_END;
    //@ assert m->type != STREAM_BAND || m->codec < STREAM_CODECS;
    //@ assert !(STREAM_HELLO <= m->type <= STREAM_BAND) || m->format < STREAM_FORMATS;
    //@ assert !(STREAM_HELLO <= m->type <= STREAM_BAND) || (1 <= m->width && 1 <= m->height);
    //@ assert !(m->type == STREAM_HELLO || m->type == STREAM_LOG) || m->length >= 1;
}

/* `count` bytes, whose header claims a type and a length: byte `place` of it is one of `low` .. `high`, those below it
 * any, those above it 0. */
static void look(struct parser *p, uint32_t type, size_t count, int place, uint32_t low, uint32_t high)
{
    uint8_t bytes[MOST];
    uint8_t *at = bytes + MOST - count;
    any_bytes(bytes, sizeof bytes);
    at[STREAM_AT_TYPE] = (uint8_t)type;
    //@ loop unroll 4;
    for (int i = 3; i >= place; i--)
        at[STREAM_AT_LENGTH + i] = (uint8_t)(i > place ? 0 : any_u32(low, high));
    size_t done = parser_look(p, at, count);
    //@ assert done <= count && p->bytes == held && p->count == 7 && p->room == 9;
}

/* Whole headers: payloads that have come, and those of which a byte is missing. */
static void looks(struct parser *p, uint32_t type)
{
    static const uint8_t lengths[] = {0, 1, STREAM_FRAME_BEGIN, STREAM_FRAME_END, LONGEST};
    //@ loop unroll 5;
    for (unsigned i = 0; i < sizeof lengths; i++) {
        const size_t count = STREAM_HEADER + lengths[i] + STREAM_CHECK;
        look(p, type, count, 0, lengths[i], lengths[i]);
        look(p, type, count, 0, lengths[i] + 1u, 255);
        //@ loop unroll 4;
        for (int place = 1; place < 4; place++)
            look(p, type, count, place, 1, 255);
    }
}

void prove(void)
{
    struct parser p = {.take = taken, .bytes = held, .count = 7, .room = 9}; /* which a look leaves alone */
    p.spare = any_u32(0, PARSER_SPARE_MOST);
    //@ loop unroll 32;
    for (size_t count = 1; count < STREAM_HEADER; count++) {
        uint8_t bytes[STREAM_HEADER];
        any_bytes(bytes, sizeof bytes);
        size_t done = parser_look(&p, bytes + STREAM_HEADER - count, count);
        //@ assert done <= count && p.bytes == held && p.count == 7 && p.room == 9;
    }
    looks(&p, any_u32(0, STREAM_HELLO - 1));
    //@ loop unroll 6;
    for (uint32_t type = STREAM_HELLO; type <= STREAM_LOG; type++)
        looks(&p, type);
    looks(&p, any_u32(STREAM_LOG + 1, 255));
    p.bytes = any_flag() ? malloc(9) : 0;
    parser_close(&p);
}

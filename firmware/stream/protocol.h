/* SPDX-License-Identifier: MIT */
/* The numbers of PROTOCOL.md, version 1, for both ends. */
#ifndef STREAM_PROTOCOL_H
#define STREAM_PROTOCOL_H

#include <stdint.h>

#define STREAM_MAGIC       0x534C47F6u /* the bytes F6 'G' 'L' 'S'; F6 stands in no text, ASCII or UTF-8 */
#define STREAM_VERSION     1u
#define STREAM_HEADER      32u /* bytes */
#define STREAM_CHECK       4u  /* bytes: of the CRC-32 behind a payload */
#define STREAM_FRAME_BEGIN 12u /* bytes of payload */
#define STREAM_FRAME_END   32u
#define STREAM_MAX_NAMES   16384u /* bytes of payload: hello */
#define STREAM_MAX_LOG     1024u

/* Where a header's members stand. */
enum stream_at {
    STREAM_AT_MAGIC = 0,
    STREAM_AT_VERSION = 4,
    STREAM_AT_TYPE = 5,
    STREAM_AT_SEQUENCE = 6,
    STREAM_AT_TIME = 8,
    STREAM_AT_X = 12, /* frame begin: the last request's sequence; host to device: the value, 32 bits */
    STREAM_AT_Y = 14,
    STREAM_AT_WIDTH = 16,
    STREAM_AT_HEIGHT = 18,
    STREAM_AT_FORMAT = 20,
    STREAM_AT_CODEC = 21,
    STREAM_AT_ZERO = 22,
    STREAM_AT_LENGTH = 24,
    STREAM_AT_CRC = 28,
};

enum stream_type {
    STREAM_HELLO = 1,
    STREAM_BEGIN = 2,
    STREAM_BAND = 3,
    STREAM_END = 4,
    STREAM_LOG = 5,
    /* host to device */
    STREAM_KEY_PLEASE = 0x81,
    STREAM_BUTTONS = 0x82, /* the set held: 1 up, 2 down, 4 left, 8 right, 16 A, 32 B, 64 X, 128 Y */
    STREAM_METHOD = 0x83,  /* index of hello's list */
    STREAM_BUDGET = 0x84,  /* 1..255 */
    STREAM_SCENE = 0x85,   /* index of hello's list */
    STREAM_PAUSE = 0x86,   /* 1: stop, 0: go on */
};

enum stream_format { STREAM_RGB565, STREAM_RGB888, STREAM_GREY8, STREAM_GREY4, STREAM_FORMATS }; /* as in glint.h */

enum stream_codec { STREAM_RAW, STREAM_QOI, STREAM_CHANGE, STREAM_CODECS };

/* Flags of a frame. */
#define STREAM_KEY    1u /* needs no picture before it */
#define STREAM_PAUSED 2u /* the animation is stopped */

/* The bytes of packed pixels, PROTOCOL.md's table. */
#define PACK_STEPS   24u   /* 0kksssss: a small difference, then one pixel copied by kk; kk 0: none */
#define PACK_LITERAL 0x18u /* and the pixel */
#define PACK_COPY    0x18u /* 0kk11nnn: n + 1 pixels copied by kk */
#define PACK_WIDE    0x80u /* 10dddddd: a larger difference */
#define PACK_MORE    0xC0u /* 11nnnnnn: 8 (n + 1) pixels more by the copy before */
enum pack_kind { PACK_LEFT = 1, PACK_ABOVE = 2, PACK_LAST = 3 };

#endif

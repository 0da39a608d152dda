/* SPDX-License-Identifier: MIT */
/*
 * Messages of a stream (firmware/stream/PROTOCOL.md) from bytes that come in pieces of any size. What is not a message
 * is passed over, as is a damaged one: after it every byte is looked at again, unless there was far more of that than a
 * line does.
 */
#ifndef VIEW_PARSER_H
#define VIEW_PARSER_H

#include "stream/protocol.h"

#include <stdbool.h>
#include <stddef.h>

/* A message whose checks hold. */
struct parser_message {
    enum stream_type type;
    uint16_t sequence;
    uint32_t time_us;
    uint16_t x, y, width, height;
    enum stream_format format;
    enum stream_codec codec;
    const uint8_t *payload; /* until the function that was given it returns */
    uint32_t length;
};

typedef void parser_take(void *context, const struct parser_message *message);

struct parser {
    parser_take *take; /* set by the caller; all else is zero at first */
    void *context;
    uint32_t messages;      /* good ones */
    uint32_t damaged;       /* messages with a good header and a bad payload */
    uint32_t other_version; /* headers of another version */
    bool out_of_memory;     /* nothing is taken any more */

    uint8_t *bytes; /* from the first that may begin a message */
    size_t count, room;
    size_t need;  /* bytes, before it is worth looking again */
    size_t spare; /* bytes of damaged payloads that may yet be looked at again */
};

void parser_push(struct parser *parser, const void *bytes, size_t size);

/* Nothing will follow: looks at what waited for more. */
void parser_finish(struct parser *parser);

void parser_close(struct parser *parser);

/* The little-endian numbers at `at`. */
uint32_t parser_get16(const uint8_t *at);
uint32_t parser_get32(const uint8_t *at);

#endif

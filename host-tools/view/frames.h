/* SPDX-License-Identifier: MIT */
/*
 * Pictures from the messages of a stream. A picture is given out when its last message has come and every message
 * since the key frame before it was there, whole and in order; after a loss nothing is, up to the next key frame.
 */
#ifndef VIEW_FRAMES_H
#define VIEW_FRAMES_H

#include "view/parser.h"

struct frames_picture {
    const uint8_t *pixels; /* rows without gaps, as drawn by the device; until the function returns */
    uint16_t width, height;
    enum stream_format format;
    uint32_t number, moment_ms, time_us; /* the device's, of its beginning */
    uint16_t echo;                       /* the sequence of the last request that the device had heard; 0: none */
    bool key, paused;
    uint8_t scene, method, budget;
    uint32_t bytes;                                                /* that it took, headers and all */
    uint32_t bands[STREAM_CODECS], packed[STREAM_CODECS];          /* bands by codec, and the bytes of their payloads */
    uint32_t draw_us, pack_us, triangles, drawn, dropped, skipped; /* as the device says */
};

struct frames_events {
    void (*picture)(void *context, const struct frames_picture *picture);
    /* Names in hello's form: `text` is the board's, zero-terminated as every name after it. */
    void (*hello)(void *context, const char *text, uint32_t length);
    void (*log)(void *context, const char *text, uint32_t length);
    void *context;
};

/* Stays where it is while open. */
struct frames {
    struct frames_events events; /* set by the caller, each or null; all else is zero at first */
    struct parser parser;
    uint32_t pictures, lost; /* given out; begun but not given out */
    bool want_key;           /* nothing will be shown before a key frame: ask for one. Set by frames_open() */

    struct frames_picture picture; /* under way */
    uint8_t *next, *last;          /* a picture's bytes each */
    uint32_t next_row, band_count;
    uint16_t sequence; /* of the next message */
    bool begun, chained, followed;
};

void frames_open(struct frames *frames, const struct frames_events *events);
void frames_push(struct frames *frames, const void *bytes, size_t size);
void frames_finish(struct frames *frames); /* nothing will follow */

/* Another sender, or the same from its beginning on: what is under way is lost, and a key frame wanted. */
void frames_restart(struct frames *frames);

void frames_close(struct frames *frames);

#endif

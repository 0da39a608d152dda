/* SPDX-License-Identifier: MIT */
/*
 * Sends pictures as a stream of messages (PROTOCOL.md), a band at a time, over anything that takes bytes.
 *
 *     struct stream s = {.write = uart_write, .pixels = &pack_rgb565, .width = 240, .height = 240,
 *                        .buffer = buffer, .buffer_bytes = sizeof buffer};
 *     stream_hello(&s, &names);
 *     for (;;) {
 *         s.time_us = clock_us();
 *         stream_frame_begin(&s, &frame);
 *         while (glint_frame_next_band(&f, &band))
 *             stream_band(&s, band.pixels, band.y, band.rows);
 *         stream_frame_end(&s, &statistics);
 *     }
 *
 * Nothing is allocated and nothing kept outside the struct. A function returns 0 or what `write` did first; after an
 * error the frame is given up, and the next one is a key frame by itself.
 *
 * A frame takes at most the bytes of its pixels, 36 for each of its messages (a band, or stream_rows() of it), and 116.
 */
#ifndef STREAM_H
#define STREAM_H

#include "stream/pack.h"

#include <stddef.h>

/* Takes all of the bytes: 0, or a negative number for an error. They are the caller's again on return. */
typedef int stream_write(void *context, const void *bytes, size_t size);

struct stream {
    /* the caller's, before the first call */
    stream_write *write;
    void *context;                    /* given to write */
    const struct pack_format *pixels; /* pack_rgb565 ... */
    uint16_t width, height;           /* of the picture, 1..2048 */
    uint8_t *buffer;                  /* what is packed of a band; at least a row */
    uint32_t buffer_bytes;            /* a band's bytes: it goes as one message */
    uint8_t *last; /* null, or room for a picture, aligned as its pixels: then only what changes is sent */
    /* at any time */
    uint32_t time_us; /* the device's time, for the messages to come */
    uint32_t heard;   /* sequence of the last request from the other end; 0: none yet */
    uint32_t key;     /* 1: the next frame is to be a key frame, as after an error; 0 again when it has begun */

    /* its own, zero at first */
    uint32_t number; /* of the frame */
    uint32_t bands;  /* messages of it */
    uint32_t crc;    /* of the message under way */
    int error;       /* the first of write in this message */
    uint16_t sequence;
    uint32_t chained; /* the frame under way refers to `last` */
};

/* `count` structs of `size` bytes, each beginning with its name, a `const char *`. */
struct stream_list {
    const void *first;
    uint16_t count, size;
};

struct stream_names {
    const char *board;
    struct stream_list scenes, methods;
};

struct stream_frame {
    uint32_t moment_ms;    /* of the animation */
    uint8_t scene, method; /* indices of hello's lists */
    uint8_t budget;
    uint8_t paused; /* 1: the animation is stopped */
};

struct stream_statistics {
    uint32_t draw_us; /* to draw the picture */
    uint32_t pack_us; /* to pack and send it */
    uint32_t triangles, drawn, dropped /* for lack of memory */;
    uint32_t skipped; /* frames that were not sent, since the start */
};

/* Rows a message: as many as have room in the buffer; 0 if it does not hold a row. */
uint32_t stream_rows(const struct stream *s);

/* Who is there and what it offers: at most STREAM_MAX_NAMES bytes of names, a zero after each included. */
int stream_hello(struct stream *s, const struct stream_names *names);

int stream_frame_begin(struct stream *s, const struct stream_frame *frame);

/* Rows y .. y + rows - 1, without gaps between them, aligned as their pixels; top to bottom, all of the picture. */
int stream_band(struct stream *s, const void *pixels, uint16_t y, uint16_t rows);

int stream_frame_end(struct stream *s, const struct stream_statistics *statistics);

/* A line of text, UTF-8, without its end; from STREAM_MAX_LOG bytes on it is cut off. */
int stream_log(struct stream *s, const char *text);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Packs the rows of a band: codecs 1 and 2 of PROTOCOL.md. Pixels are taken in order, row by row; what repeats the one
 * before, the one above or the one of the last picture is copied, the longest way first, and the rest are differences
 * to the pixel before.
 */
#ifndef STREAM_PACK_H
#define STREAM_PACK_H

#include "stream/protocol.h"

struct pack_rows {
    const uint8_t *pixels; /* rows without gaps, aligned as the format's pixel */
    const uint8_t *last;   /* the same rows of the last picture, or null: codec 1 */
    uint32_t bytes;        /* of all rows, at least one pixel */
    uint32_t stride;       /* bytes a row, a multiple of a pixel */
    uint8_t *out;
    uint32_t room; /* bytes */
};

/* Writes at most `room` bytes to out and returns how many, or 0 if they would be more. */
typedef uint32_t pack_rows_function(const struct pack_rows *rows);

/* A pixel format; only the one that a program names is linked. GREY4 is packed in pairs: its pixel is a byte. */
struct pack_format {
    pack_rows_function *pack;
    uint8_t format; /* enum stream_format */
    uint8_t bits;   /* a pixel */
};
extern const struct pack_format pack_rgb565, pack_rgb888, pack_grey8, pack_grey4;

#endif

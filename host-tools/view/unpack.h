/* SPDX-License-Identifier: MIT */
/* The rows of a band back from codecs 1 and 2 of firmware/stream/PROTOCOL.md. */
#ifndef UNPACK_H
#define UNPACK_H

#include "stream/protocol.h"

#include <stdbool.h>
#include <stddef.h>

struct unpack_rows {
    const uint8_t *packed;
    size_t packed_bytes;
    uint8_t *pixels;     /* rows without gaps: all of them, or a part, is written */
    const uint8_t *last; /* the same rows of the last picture, or null: codec 1 */
    size_t bytes;        /* of all rows */
    size_t stride;       /* bytes a row */
    enum stream_format format;
};

/* True if what is packed is exactly these rows. Reads and writes nothing outside whatever the bytes are. */
bool unpack_rows(const struct unpack_rows *rows);

/* Bytes a row of a picture. */
size_t unpack_row_bytes(enum stream_format format, uint32_t width);

#endif

/* SPDX-License-Identifier: MIT */
/* What the fuzz targets share. Each is one function that is given bytes, by libFuzzer or by replay.c. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Stops the program, with NDEBUG too: what is promised of any bytes does not hold. */
#define FUZZ_CHECK(promise)                                                       \
    do                                                                            \
        if (!(promise)) {                                                         \
            fprintf(stderr, "%s:%d: broken: %s\n", __FILE__, __LINE__, #promise); \
            abort();                                                              \
        }                                                                         \
    while (0)

/* Takes any bytes, which are in a block of exactly their size: 0, or it does not return. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* A block of exactly so many bytes, so that a sanitizer sees what is read or written beside it; the caller's to free.
 */
static inline uint8_t *fuzz_block(size_t bytes)
{
    uint8_t *block = malloc(bytes ? bytes : 1);
    FUZZ_CHECK(block);
    return block;
}

/* Bytes to begin with: how many of them, and the rest. */
struct fuzz_bytes {
    const uint8_t *at, *end;
};

/* The next byte, 0 when there is none. */
static inline unsigned fuzz_take(struct fuzz_bytes *bytes)
{
    return bytes->at != bytes->end ? *bytes->at++ : 0;
}

#endif

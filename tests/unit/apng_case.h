/* SPDX-License-Identifier: MIT */
/* An animated PNG of 8-bit samples back into pictures, each as a viewer shows it. Include after cmocka.h. */
#ifndef APNG_CASE_H
#define APNG_CASE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

struct apng_case {
    uint8_t *bytes; /* of the file */
    size_t size, at;
    uint32_t width, height, samples, frames, sequence;
    /* of the picture that apng_case_next() showed */
    uint32_t x, y, part_width, part_height, delay_ms;
    uint8_t *shown;
};

static inline uint32_t apng_case_get32(const uint8_t *bytes)
{
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* The next chunk's data, behind which `at` is then; its CRC must hold. */
static inline const uint8_t *apng_case_chunk(struct apng_case *a, const char *type, uint32_t *length)
{
    assert_true(a->at + 12 <= a->size);
    const uint8_t *data = a->bytes + a->at + 8;
    *length = apng_case_get32(data - 8);
    assert_true(*length <= a->size - a->at - 12);
    assert_memory_equal(data - 4, type, 4);
    assert_int_equal(apng_case_get32(data + *length), crc32(0, data - 4, *length + 4));
    a->at += 12 + *length;
    return data;
}

static inline bool apng_case_is(const struct apng_case *a, const char *type)
{
    return a->at + 12 <= a->size && memcmp(a->bytes + a->at + 4, type, 4) == 0;
}

static inline void apng_case_open(struct apng_case *a, const char *path)
{
    static const uint8_t signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    FILE *file = fopen(path, "rb");
    uint32_t length;
    assert_non_null(file);
    *a = (struct apng_case){.bytes = malloc(1 << 20), .at = 8};
    a->size = fread(a->bytes, 1, 1 << 20, file);
    assert_true(a->size > 8 && a->size < 1 << 20);
    fclose(file);
    assert_memory_equal(a->bytes, signature, 8);
    const uint8_t *head = apng_case_chunk(a, "IHDR", &length);
    assert_int_equal(length, 13);
    a->width = apng_case_get32(head);
    a->height = apng_case_get32(head + 4);
    assert_true(head[8] == 8 && (head[9] == 0 || head[9] == 2) && !head[10] && !head[11] && !head[12]);
    a->samples = head[9] ? 3 : 1;
    a->shown = calloc(a->height, (size_t)a->width * a->samples);
    const uint8_t *control = apng_case_chunk(a, "acTL", &length);
    assert_int_equal(length, 8);
    a->frames = apng_case_get32(control);
    assert_int_equal(apng_case_get32(control + 4), 0); /* for ever */
}

/* Undoes a row's filter; what is left of or above the picture is 0. */
static inline void apng_case_unfilter(unsigned filter, uint8_t *row, const uint8_t *above, size_t bytes, size_t samples)
{
    for (size_t i = 0; i < bytes; i++) {
        int left = i < samples ? 0 : row[i - samples], up = above ? above[i] : 0;
        int corner = above && i >= samples ? above[i - samples] : 0, guess = left + up - corner;
        int to_left = abs(guess - left), to_up = abs(guess - up), to_corner = abs(guess - corner);
        const int paeth = to_left <= to_up && to_left <= to_corner ? left : to_up <= to_corner ? up : corner;
        const int guesses[5] = {0, left, up, (left + up) / 2, paeth};
        assert_true(filter < 5);
        row[i] = (uint8_t)((row[i] + guesses[filter]) & 255);
    }
}

static inline void apng_case_compose(struct apng_case *a, uint8_t *packed, size_t packed_bytes)
{
    size_t row = (size_t)a->part_width * a->samples, all = (row + 1) * a->part_height;
    uint8_t *rows = malloc(all), *above = NULL;
    uLongf size = all;
    assert_int_equal(uncompress(rows, &size, packed, packed_bytes), Z_OK);
    assert_int_equal(size, all);
    for (uint32_t y = 0; y < a->part_height; y++) {
        uint8_t *now = rows + y * (row + 1) + 1;
        apng_case_unfilter(now[-1], now, above, row, a->samples);
        memcpy(a->shown + ((size_t)(a->y + y) * a->width + a->x) * a->samples, now, row);
        above = now;
    }
    free(rows);
}

/* Shows the next picture; false behind the last, where the file must end. */
static inline bool apng_case_next(struct apng_case *a)
{
    uint32_t length, sequence = a->sequence;
    size_t count = 0;
    if (!apng_case_is(a, "fcTL")) {
        apng_case_chunk(a, "IEND", &length);
        assert_int_equal(a->at, a->size);
        return false;
    }
    const uint8_t *control = apng_case_chunk(a, "fcTL", &length);
    assert_int_equal(length, 26);
    assert_int_equal(apng_case_get32(control), a->sequence++);
    a->part_width = apng_case_get32(control + 4);
    a->part_height = apng_case_get32(control + 8);
    a->x = apng_case_get32(control + 12);
    a->y = apng_case_get32(control + 16);
    assert_true(a->part_width && a->part_height && a->x + a->part_width <= a->width &&
                a->y + a->part_height <= a->height);
    assert_true(sequence || (a->part_width == a->width && a->part_height == a->height));
    a->delay_ms = (uint32_t)control[20] << 8 | control[21];
    assert_int_equal(control[22] << 8 | control[23], 1000);
    assert_true(control[24] == 0 && control[25] == 0); /* it stays, and replaces what was there */
    uint8_t *packed = malloc(a->size);
    while (apng_case_is(a, sequence ? "fdAT" : "IDAT")) {
        const uint8_t *data = apng_case_chunk(a, sequence ? "fdAT" : "IDAT", &length);
        uint32_t skip = sequence ? 4 : 0;
        assert_true(length >= skip);
        if (skip)
            assert_int_equal(apng_case_get32(data), a->sequence++);
        memcpy(packed + count, data + skip, length - skip);
        count += length - skip;
    }
    apng_case_compose(a, packed, count);
    free(packed);
    return true;
}

static inline void apng_case_close(struct apng_case *a)
{
    free(a->bytes);
    free(a->shown);
}

#endif

/* SPDX-License-Identifier: MIT */
/* Mutations of a PNG file whose chunks keep their checksums right. */
#include "fuzz/fuzz.h"

#include <zlib.h>

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t most);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed);

enum { SIGNATURE = 8, AROUND = 12 };

static uint32_t get(const uint8_t *at)
{
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    static const uint8_t signature[SIGNATURE] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    size = LLVMFuzzerMutate(data, size, most);
    if (seed % 8 == 0 || size < SIGNATURE)
        return size;
    memcpy(data, signature, SIGNATURE);
    for (size_t at = SIGNATURE; at + AROUND <= size;) {
        const uint32_t length = get(data + at);
        if (length > size - at - AROUND)
            return size;
        const uint32_t sum = (uint32_t)crc32(0, data + at + 4, length + 4);
        for (int i = 0; i < 4; i++)
            data[at + 8 + length + (size_t)i] = (uint8_t)(sum >> (24 - 8 * i) & 255);
        at += AROUND + length;
    }
    return size;
}

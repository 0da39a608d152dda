/* SPDX-License-Identifier: MIT */
#include "panels/changes.h"

#define MULTIPLIER 0x9E3779B1u /* odd, its bits well mixed: 2^32 over the golden ratio, a prime near it */

/* A step is one-to-one in the sum and in the word: rows that differ in one word never have the same sum. The rotation
 * brings the upper bits down, which a product alone never does; a product of the upper bits alone would let two changes
 * of a pixel's top bit cancel. The 64-bit forms say that what leaves at the top is meant to; 32 bits are computed. */
static inline uint32_t changes_mix(uint32_t sum, uint32_t word)
{
    sum ^= word;
    sum = (uint32_t)((uint64_t)sum << 15) | sum >> 17;
    return (uint32_t)((uint64_t)sum * MULTIPLIER);
}

uint32_t changes_sum(const void *row, uint32_t bytes)
{
    const uint8_t *at = row;
    uint32_t sum = MULTIPLIER, word, rest = bytes & 3, words = bytes / 4;
    if (((uintptr_t)at & 3) == 0)
        for (; words; words--, at += 4) {
            __builtin_memcpy(&word, __builtin_assume_aligned(at, 4), 4);
            sum = changes_mix(sum, word);
        }
    else
        for (; words; words--, at += 4) {
            __builtin_memcpy(&word, at, 4);
            sum = changes_mix(sum, word);
        }
    for (; rest; rest--)
        sum = changes_mix(sum, *at++);
    return sum;
}

/* memcmp() of a machine without a libc goes byte by byte. */
static int changes_same(const void *before, const void *row, uint32_t bytes)
{
    const uint8_t *a = before, *b = row;
    if (((uintptr_t)a | (uintptr_t)b) & 3)
        return __builtin_memcmp(a, b, bytes) == 0;
    for (; bytes >= 4; bytes -= 4, a += 4, b += 4) {
        uint32_t word, other;
        __builtin_memcpy(&word, __builtin_assume_aligned(a, 4), 4);
        __builtin_memcpy(&other, __builtin_assume_aligned(b, 4), 4);
        if (word != other)
            return 0;
    }
    return __builtin_memcmp(a, b, bytes) == 0;
}

int changes_row(struct panel *panel, const void *row, uint32_t y)
{
    uint32_t bytes = panel->row_bytes;
    if (panel->memory_size >= bytes * panel->down) {
        uint8_t *before = (uint8_t *)panel->memory + y * bytes;
        if (!panel->all && changes_same(before, row, bytes))
            return 0;
        __builtin_memcpy(before, row, bytes);
        return 1;
    }
    if (panel->memory_size < 4u * panel->down)
        return 1;
    uint32_t *before = (uint32_t *)panel->memory + y, sum = changes_sum(row, bytes);
    int changed = panel->all || *before != sum;
    *before = sum;
    return changed;
}

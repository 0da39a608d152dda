/* SPDX-License-Identifier: MIT */
#include "panels/changes.h"

#define MULTIPLIER 0x9E3779B1u /* odd, its bits well mixed: 2^32 over the golden ratio, a prime near it */

typedef uint32_t __attribute__((may_alias)) aligned_word; /* of pixels of any size */

/* A step is one-to-one in the sum and in the word: rows that differ in one word never have the same sum. The rotation
 * brings the upper bits down, which a product alone never does: two changes of a pixel's top bit would cancel. The
 * 64-bit forms say that what leaves at the top is meant to; 32 bits are computed. */
static inline uint32_t changes_mix(uint32_t sum, uint32_t word, uint32_t multiplier)
{
    sum ^= word;
    sum = (uint32_t)((uint64_t)sum << 15) | sum >> 17;
    return (uint32_t)((uint64_t)sum * multiplier);
}

uint32_t changes_sum(const void *row, uint32_t bytes)
{
    const uint8_t *at = row;
    uint32_t sum = MULTIPLIER, multiplier = MULTIPLIER, rest = bytes & 3, words = bytes / 4;
    /* Hides the constant: GCC takes eleven shifts and additions for it on a Cortex-M0+, which multiplies in a cycle. */
    __asm__("" : "+r"(multiplier));
    if (((uintptr_t)at & 3) == 0)
        for (; words >= 4; words -= 4, at += 16) {
            const aligned_word *word = (const aligned_word *)(const void *)at;
            sum = changes_mix(sum, word[0], multiplier);
            sum = changes_mix(sum, word[1], multiplier);
            sum = changes_mix(sum, word[2], multiplier);
            sum = changes_mix(sum, word[3], multiplier);
        }
    for (; words; words--, at += 4) {
        uint32_t one = at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
        sum = changes_mix(sum, one, multiplier);
    }
    for (; rest; rest--)
        sum = changes_mix(sum, *at++, multiplier);
    return sum;
}

/* memcmp() of a machine without a libc goes byte by byte. */
static int changes_same(const void *before, const void *row, uint32_t bytes)
{
    if (((uintptr_t)before | (uintptr_t)row) & 3)
        return __builtin_memcmp(before, row, bytes) == 0;
    const aligned_word *word = before, *other = row;
    for (; bytes >= 4; bytes -= 4)
        if (*word++ != *other++)
            return 0;
    return __builtin_memcmp(word, other, bytes) == 0;
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

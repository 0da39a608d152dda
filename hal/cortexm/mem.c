/* SPDX-License-Identifier: MIT */
/*
 * The four functions that a compiler may call although no source does. By words where both ends allow it; compiled
 * with -fno-tree-loop-distribute-patterns, or each would be compiled into a call of itself.
 */
#include <stddef.h>
#include <stdint.h>

typedef uint32_t __attribute__((may_alias)) word_t;

void *memcpy(void *restrict to, const void *restrict from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int value, size_t size);
int memcmp(const void *a, const void *b, size_t size);

static int mem_aligned(const void *a, const void *b)
{
    return (((uintptr_t)a | (uintptr_t)b) & 3) == 0;
}

/* Upwards, so also for overlapping memory whose target lies below: a whole number of words below where both ends are
 * aligned. */
static void *mem_forward(void *to, const void *from, size_t size)
{
    unsigned char *d = to;
    const unsigned char *s = from;
    if (mem_aligned(d, s)) {
        for (; size >= 4; size -= 4, d += 4, s += 4)
            *(word_t *)(void *)d = *(const word_t *)(const void *)s;
    }
    while (size--)
        *d++ = *s++;
    return to;
}

void *memcpy(void *restrict to, const void *restrict from, size_t size)
{
    return mem_forward(to, from, size);
}

void *memmove(void *to, const void *from, size_t size)
{
    unsigned char *d = to;
    const unsigned char *s = from;
    if ((uintptr_t)d - (uintptr_t)s >= size)
        return mem_forward(to, from, size);
    while (size--)
        d[size] = s[size];
    return to;
}

void *memset(void *to, int value, size_t size)
{
    unsigned char *d = to;
    word_t word = (unsigned char)value * 0x01010101u;
    if (mem_aligned(d, d)) {
        for (; size >= 4; size -= 4, d += 4)
            *(word_t *)(void *)d = word;
    }
    while (size--)
        *d++ = (unsigned char)value;
    return to;
}

int memcmp(const void *a, const void *b, size_t size)
{
    const unsigned char *x = a, *y = b;
    for (; size; size--, x++, y++)
        if (*x != *y)
            return *x < *y ? -1 : 1;
    return 0;
}

/* SPDX-License-Identifier: MIT */
/*
 * A span's pixels from a colour table: RGB565 under one light. A template: always called with a constant `kind`.
 *
 * Depth, N.L and N.H are stepped by differences; where a pixel is the nearest, its depth is kept and its colour is the
 * table's entry for (N.H, N.L), both clamped, as the first and last entries stand for all beyond.
 */
#ifndef GLINT_PIXELS_H
#define GLINT_PIXELS_H

#include "raster/raster.h"

enum pixels_kind { PIXELS_DIFFUSE = 1, PIXELS_HIGHLIGHT = 2, PIXELS_QUADRATIC = 4 };

/* Values at the first pixel, first differences, and second ones (0 where linear). */
struct pixels_values {
    uint32_t z, l, h, dz, dl, dh, al, ah;
};

/* The shape compilers know as a saturation. */
static inline int32_t pixels_clamped(int32_t x, int32_t top)
{
    int32_t y = x < 0 ? 0 : x;
    return y > top ? top : y;
}

/*
 * From `depth` to before `end`; `to_pixels` bytes lie between a pixel's depth and its colour: one pointer for both
 * stores, which have the same shape. N.L counts in Q30 from half a step before 0, N.H from the foot of the power in Q30
 * / 2^octave, where down = 23 - octave. *hidden counts those that are not the nearest.
 */
FX_WRAPS static inline __attribute__((always_inline)) void pixels_plain(struct pixels_values v, uint16_t *depth,
                                                                        const uint16_t *end, uintptr_t to_pixels,
                                                                        const uint16_t *colours, int down,
                                                                        volatile uint32_t *hidden, unsigned kind)
{
    do {
        uint32_t nearer = v.z >> 16;
        if (nearer > *depth) {
            const uint16_t *entry = colours;
            *depth = (uint16_t)nearer;
            if (kind & PIXELS_HIGHLIGHT)
                entry += pixels_clamped((int32_t)v.h >> down, TABLE_HIGHLIGHT - 1) * TABLE_DIFFUSE;
            if (kind & PIXELS_DIFFUSE)
                entry += pixels_clamped((int32_t)v.l >> 24, TABLE_DIFFUSE - 1);
            *(uint16_t *)((uintptr_t)depth + to_pixels) = *entry;
        } else {
            *hidden = *hidden + 1;
        }
        fx_step(&v.z, v.dz);
        if (kind & PIXELS_DIFFUSE) {
            v.l += v.dl;
            if (kind & PIXELS_QUADRATIC)
                fx_step(&v.dl, v.al);
        }
        if (kind & PIXELS_HIGHLIGHT) {
            v.h += v.dh;
            if (kind & PIXELS_QUADRATIC)
                fx_step(&v.dh, v.ah);
        }
    } while (++depth != end);
}

#if FX_NARROW && defined(__thumb__) && !defined(__clang__)
#define PIXELS_BY_HAND 1
/*
 * The same for ARMv6-M, whose compilers keep four of the loop's words in memory: with every register in use and the
 * clamps' rare cases apart, a pixel takes 29 cycles instead of 45 on a Cortex-M0+. N.H counts in Q30 itself here (down
 * = 23: an immediate), within [-2, 2) for the clamp to know what is above from what is below.
 */
#define PIXELS_TEST          \
    ".syntax unified\n"      \
    "1: ldrh %[t], [%[p]]\n" \
    "lsrs %[u], %[z], #16\n" \
    "cmp %[u], %[t]\n"       \
    "bls 7f\n"               \
    "strh %[u], [%[p]]\n"
#define PIXELS_INDEX_L       \
    "lsrs %[t], %[l], #24\n" \
    "cmp %[t], #63\n"        \
    "bhi 5f\n"               \
    "2: "
#define PIXELS_INDEX_H         \
    "lsrs %[u], %[h], #23\n"   \
    "cmp %[u], #127\n"         \
    "bhi 6f\n"                 \
    "3: lsls %[u], %[u], #6\n" \
    "adds %[t], %[t], %[u]\n"
#define PIXELS_STORE                  \
    "lsls %[t], %[t], #1\n"           \
    "ldrh %[t], [%[t], %[colours]]\n" \
    "strh %[t], [%[p], %[to]]\n"      \
    "4: add %[z], %[dz]\n"
#define PIXELS_NEXT      \
    "adds %[p], #2\n"    \
    "cmp %[p], %[end]\n" \
    "bne 1b\n"           \
    "b 8f\n"
#define PIXELS_CLAMP_L          \
    "5: asrs %[t], %[l], #31\n" \
    "mvns %[t], %[t]\n"         \
    "lsrs %[t], %[t], #26\n"    \
    "b 2b\n"
#define PIXELS_CLAMP_H          \
    "6: asrs %[u], %[h], #31\n" \
    "mvns %[u], %[u]\n"         \
    "lsrs %[u], %[u], #25\n"    \
    "b 3b\n"
#define PIXELS_HIDDEN          \
    "7: ldr %[t], %[hidden]\n" \
    "adds %[t], #1\n"          \
    "str %[t], %[hidden]\n"    \
    "b 4b\n"                   \
    "8:\n"
#define PIXELS_COMMON [p] "+l"(depth), [z] "+l"(v.z), [t] "=&l"(t), [hidden] "+m"(*hidden)
#define PIXELS_GIVEN  [to] "l"(to_pixels), [colours] "l"(colours), [end] "h"(end), [dz] "h"(v.dz)

FX_WRAPS static inline __attribute__((always_inline)) void pixels_by_hand(struct pixels_values v, uint16_t *depth,
                                                                          const uint16_t *end, uintptr_t to_pixels,
                                                                          const uint16_t *colours,
                                                                          volatile uint32_t *hidden, unsigned kind)
{
    uint32_t t, u;
    if (kind == (PIXELS_DIFFUSE | PIXELS_HIGHLIGHT | PIXELS_QUADRATIC)) {
        register uint32_t ah __asm__("lr") = v.ah; /* the fourteenth: left alone, compilers do not offer it */
        __asm__ volatile(PIXELS_TEST PIXELS_INDEX_L PIXELS_INDEX_H PIXELS_STORE
                         "add %[l], %[dl]\n"
                         "add %[dl], %[al]\n"
                         "add %[h], %[dh]\n"
                         "add %[dh], %[ah]\n" PIXELS_NEXT PIXELS_CLAMP_L PIXELS_CLAMP_H PIXELS_HIDDEN
                         : PIXELS_COMMON, [u] "=&l"(u), [l] "+l"(v.l), [h] "+l"(v.h), [dl] "+h"(v.dl), [dh] "+h"(v.dh)
                         : PIXELS_GIVEN, [al] "h"(v.al), [ah] "h"(ah)
                         : "memory", "cc");
    } else if (kind == (PIXELS_DIFFUSE | PIXELS_HIGHLIGHT)) {
        __asm__ volatile(PIXELS_TEST PIXELS_INDEX_L PIXELS_INDEX_H PIXELS_STORE
                         "add %[l], %[dl]\n"
                         "add %[h], %[dh]\n" PIXELS_NEXT PIXELS_CLAMP_L PIXELS_CLAMP_H PIXELS_HIDDEN
                         : PIXELS_COMMON, [u] "=&l"(u), [l] "+l"(v.l), [h] "+l"(v.h)
                         : PIXELS_GIVEN, [dl] "h"(v.dl), [dh] "h"(v.dh)
                         : "memory", "cc");
    } else if (kind == (PIXELS_DIFFUSE | PIXELS_QUADRATIC)) {
        __asm__ volatile(PIXELS_TEST PIXELS_INDEX_L PIXELS_STORE
                         "add %[l], %[dl]\n"
                         "add %[dl], %[al]\n" PIXELS_NEXT PIXELS_CLAMP_L PIXELS_HIDDEN
                         : PIXELS_COMMON, [u] "=&l"(u), [l] "+l"(v.l), [dl] "+h"(v.dl)
                         : PIXELS_GIVEN, [al] "h"(v.al)
                         : "memory", "cc");
    } else {
        __asm__ volatile(PIXELS_TEST PIXELS_INDEX_L PIXELS_STORE
                         "add %[l], %[dl]\n" PIXELS_NEXT PIXELS_CLAMP_L PIXELS_HIDDEN
                         : PIXELS_COMMON, [u] "=&l"(u), [l] "+l"(v.l)
                         : PIXELS_GIVEN, [dl] "h"(v.dl)
                         : "memory", "cc");
    }
}
#else
#define PIXELS_BY_HAND 0
void pixels_by_hand(struct pixels_values v, uint16_t *depth, const uint16_t *end, uintptr_t to_pixels,
                    const uint16_t *colours, volatile uint32_t *hidden, unsigned kind); /* never called */
#endif

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Grey loops of spans.h and the start values of their spans, in Thumb instructions of ARMv7-M: compilers spill what
 * fits, and load a polynomial's coefficients one by one. The bits are those of the C, which the goldens of Cortex-M3
 * and M4 show.
 *
 * Registers: r0 the pixel's address, r1 depth's less twice that, r2, r3 depth and its difference, r4, r5 N.L, r6, r7
 * N.H, r10 where the span ends, r11, r12, lr spare; at a span's start r11 = i and r12 = j from the origin, lr the
 * channels.
 */
#include "raster/spans_hand.h"

#include <stddef.h>

#if SPANS_BY_HAND == 2
_Static_assert(sizeof(struct channel) == 28 && offsetof(struct channel, p) == 4 && sizeof(struct span) == 4 &&
                   offsetof(struct shade_setup, channel) == offsetof(struct shade_setup, depth) + 28 &&
                   SHADE_SQUARE == 16,
               "what is read by address: channel c's polynomial stands 28 c + 32 from the depth's");
_Static_assert(offsetof(struct spans_hand, hidden) == 40 && offsetof(struct spans_hand, foot) == 56,
               "the words of struct spans_hand");
_Static_assert(TABLE_BITS == 10 && SPANS_LENGTH_BITS == 10, "the saturations");

/* On the stack: the rows, a second difference, spans_length, down and foot, table, to_pixels. Then a row: the next span
 * that holds pixels. */
#define ENTER                     \
    ".syntax unified\n"           \
    "push {r4-r11, lr}\n"         \
    "sub sp, #28\n"               \
    "add r12, r0, #44\n"          \
    "ldm r12, {r1-r4}\n"          \
    "ldrd r5, r6, [r0, #28]\n"    \
    "stm sp, {r0-r6}\n"           \
    "b 11f\n"                     \
    "12: add sp, #28\n"           \
    "pop {r4-r11, pc}\n"          \
    "10: ldr r0, [sp]\n"          \
    "11: ldrd r1, r2, [r0, #4]\n" \
    "cmp r1, r2\n"                \
    "beq 12b\n"                   \
    "ldr r3, [r1], #4\n"          \
    "str r1, [r0, #4]\n"          \
    "ldrd r4, r5, [r0, #12]\n"    \
    "ldrd r12, r11, [r0, #20]\n"  \
    "adds r5, r5, r4\n"           \
    "add r6, r12, #1\n"           \
    "str r5, [r0, #12]\n"         \
    "str r6, [r0, #20]\n"         \
    "sxth r2, r3\n"               \
    "asrs r3, r3, #16\n"          \
    "subs r6, r3, r2\n"           \
    "ble 11b\n"                   \
    "ldr r1, [r0, #36]\n"         \
    "ldr lr, [r0]\n"              \
    "sub r11, r2, r11\n"          \
    "add r10, r4, r3\n"           \
    "adds r1, r1, r6\n"           \
    "str r1, [r0, #36]\n"         \
    "adds r0, r4, r2\n" LINEAR("r2", "r3", "4", "8", "12")

/* value = f + d i + e j, the difference d: offsets from the depth's channel. */
#define LINEAR(value, step, f, d, e)            \
    "ldrd " value ", " step ", [lr, #" f "]\n"  \
    "ldr r1, [lr, #" e "]\n"                    \
    "mla " value ", " step ", r11, " value "\n" \
    "mla " value ", r1, r12, " value "\n"

/* value = f + (e + b j) j + (d + c j + a i) i, step = d + c j + a (2 i + 1), twice a in `second`; r1 spare. */
#define QUADRATIC(value, step, second, f, e, a, b, c) \
    "ldrd " value ", " step ", [lr, #" f "]\n"        \
    "ldrd r1, " second ", [lr, #" b "]\n"             \
    "mla " step ", " second ", r12, " step "\n"       \
    "mul r1, r1, r12\n"                               \
    "ldr " second ", [lr, #" e "]\n"                  \
    "add r1, " second "\n"                            \
    "mla " value ", r1, r12, " value "\n"             \
    "ldr " second ", [lr, #" a "]\n"                  \
    "mul r1, " second ", r11\n"                       \
    "mla " value ", " step ", r11, " value "\n"       \
    "mla " value ", r1, r11, " value "\n"             \
    "add " step ", " step ", r1, lsl #1\n"            \
    "add " step ", " second "\n"                      \
    "lsl " second ", #1\n"

#define TEST                          \
    "1: ldrh r12, [r1, r0, lsl #1]\n" \
    "lsr lr, r2, #16\n"               \
    "cmp lr, r12\n"                   \
    "bls 7f\n"                        \
    "strh lr, [r1, r0, lsl #1]\n"
#define NEXT_PIXEL         \
    "cmp r0, r10\n"        \
    "bne 1b\n"             \
    "b 10b\n"              \
    "7: ldr r12, [sp]\n"   \
    "ldr lr, [r12, #40]\n" \
    "adds r0, #1\n"        \
    "add lr, #1\n"         \
    "str lr, [r12, #40]\n" \
    "b 4b\n"

/* The sum of N.L and of N.H's entry, of the table at r11. */
#define BOTH                       \
    "usat lr, #10, r6, asr #20\n"  \
    "usat r12, #16, r4, asr #15\n" \
    "ldrh lr, [r11, lr, lsl #1]\n" \
    "add lr, r12\n"                \
    "usat lr, #8, lr, asr #7\n"    \
    "strb lr, [r0], #1\n"          \
    "4: add r2, r3\n"              \
    "add r4, r5\n"                 \
    "add r6, r7\n"

__attribute__((naked)) void spans_hand_grey(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER LINEAR("r4", "r5", "32", "36", "40")
                LINEAR("r6", "r7", "60", "64", "68") "ldrd r11, r1, [sp, #20]\n" TEST BOTH NEXT_PIXEL);
}

__attribute__((naked)) void spans_hand_grey_quadratic(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER QUADRATIC("r4", "r5", "r8", "32", "40", "44", "48", "52")
                QUADRATIC("r6", "r7", "r9", "60", "68", "72", "76", "80") "ldrd r11, r1, [sp, #20]\n" TEST BOTH
                                                                          "add r5, r8\n"
                                                                          "add r7, r9\n" NEXT_PIXEL);
}

/* Both over the length of the normal, 1 - |N|^2 in r8 and its difference in r9. */
__attribute__((naked)) void spans_hand_grey_lengths(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER QUADRATIC("r8", "r9", "r4", "480", "488", "492", "496", "500") LINEAR("r4", "r5", "32", "36", "40")
                LINEAR("r6", "r7", "60", "64", "68") "ldr r1, [sp, #24]\n" TEST "usat r11, #10, r8, asr #18\n"
                                                     "ldr lr, [sp, #8]\n"
                                                     "ldrh r11, [lr, r11, lsl #1]\n" /* 1 / |N| */
                                                     "ldrd r12, lr, [sp, #12]\n"
                                                     "asr r12, r6, r12\n"
                                                     "mla r12, r12, r11, lr\n"
                                                     "ldr lr, [sp, #20]\n"
                                                     "usat r12, #10, r12, asr #20\n"
                                                     "ldrh r12, [lr, r12, lsl #1]\n"
                                                     "usat lr, #15, r4, asr #15\n"
                                                     "mul lr, lr, r11\n"
                                                     "add r12, r12, lr, lsr #15\n"
                                                     "usat r12, #8, r12, asr #7\n"
                                                     "strb r12, [r0], #1\n"
                                                     "4: ldr r11, [sp, #4]\n"
                                                     "add r2, r3\n"
                                                     "add r4, r5\n"
                                                     "add r6, r7\n"
                                                     "add r8, r9\n"
                                                     "add r9, r11\n" NEXT_PIXEL);
}
#endif

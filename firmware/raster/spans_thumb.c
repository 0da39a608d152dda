/* SPDX-License-Identifier: MIT */
/*
 * The loops of spans.h and the start values of their spans, in Thumb instructions of ARMv6-M. One text, of which each
 * case takes its part; the bits are those of the C in spans.h, which the goldens of a Cortex-M0+ show.
 */
#include "raster/spans_hand.h"

#include <stddef.h>

#if SPANS_BY_HAND == 1
_Static_assert(TABLE_BITS == 10, "the shifts of GREY()");
_Static_assert(sizeof(struct channel) == 28 && offsetof(struct channel, p) == 4 && sizeof(struct span) == 4,
               "what is read by address");
_Static_assert(offsetof(struct shade_setup, channel) == offsetof(struct shade_setup, depth) + 28, "channels in a row");
_Static_assert(offsetof(struct spans_hand, hidden) == 40, "the words of struct spans_hand");

/* On the stack: the rows; N.L, its first and its second difference, while N.H is made. */
#define ENTER            \
    ".syntax unified\n"  \
    "push {r4-r7, lr}\n" \
    "mov r4, r8\n"       \
    "mov r5, r9\n"       \
    "mov r6, r10\n"      \
    "mov r7, r11\n"      \
    "push {r4-r7}\n"     \
    "sub sp, #16\n"      \
    "str r0, [sp]\n"     \
    "b 11f\n"

#define LEAVE           \
    "12: add sp, #16\n" \
    "pop {r4-r7}\n"     \
    "mov r8, r4\n"      \
    "mov r9, r5\n"      \
    "mov r10, r6\n"     \
    "mov r11, r7\n"     \
    "pop {r4-r7, pc}\n"

/* The next span: r12 its depth, r9 its end, r10 = i, r11 = j; lr depth's value, r8 its step; r0 N.L's polynomial. */
#define NEXT_ROW                        \
    "10: ldr r0, [sp]\n"                \
    "11: ldr r1, [r0, #4]\n" /* span */ \
    "ldr r2, [r0, #8]\n"     /* last */ \
    "cmp r1, r2\n"                      \
    "beq 12b\n"                         \
    "ldr r3, [r1]\n"                    \
    "adds r1, #4\n"                     \
    "str r1, [r0, #4]\n"                \
    "ldr r4, [r0, #12]\n" /* row */     \
    "ldr r5, [r0, #16]\n" /* stride */  \
    "adds r5, r5, r4\n"                 \
    "str r5, [r0, #12]\n"               \
    "ldr r5, [r0, #20]\n" /* j */       \
    "adds r6, r5, #1\n"                 \
    "str r6, [r0, #20]\n"               \
    "sxth r2, r3\n"                     \
    "asrs r3, r3, #16\n"                \
    "subs r6, r3, r2\n"                 \
    "ble 10b\n"                         \
    "ldr r7, [r0, #36]\n" /* covered */ \
    "adds r7, r7, r6\n"                 \
    "str r7, [r0, #36]\n"               \
    "adds r3, r3, r3\n"                 \
    "adds r3, r3, r4\n"                 \
    "mov r9, r3\n"                      \
    "lsls r6, r2, #1\n"                 \
    "adds r6, r6, r4\n"                 \
    "mov r12, r6\n"                     \
    "ldr r4, [r0, #24]\n" /* ox */      \
    "subs r2, r2, r4\n"                 \
    "mov r10, r2\n"                     \
    "mov r11, r5\n"                     \
    "ldr r0, [r0]\n"                    \
    "adds r0, #4\n"                     \
    "ldmia r0!, {r1, r3, r4}\n"         \
    "mov r8, r3\n"                      \
    "muls r3, r2\n"                     \
    "muls r4, r5\n"                     \
    "adds r1, r1, r3\n"                 \
    "adds r1, r1, r4\n"                 \
    "mov lr, r1\n"                      \
    "adds r0, #16\n"

/* A channel's value in r1, first difference in r6, second in r4, of the polynomial at r0, which goes to its end. */
#define QUADRATIC                             \
    "ldmia r0!, {r1-r6}\n" /* f d e a b c */  \
    "mov r7, r11\n"                           \
    "muls r5, r7\n"                           \
    "adds r5, r5, r3\n"                       \
    "muls r5, r7\n"                           \
    "adds r1, r1, r5\n" /* f + (e + b j) j */ \
    "muls r6, r7\n"                           \
    "adds r2, r2, r6\n" /* d + c j */         \
    "mov r7, r10\n"                           \
    "movs r5, r4\n"                           \
    "muls r5, r7\n"                           \
    "adds r6, r2, r5\n"                       \
    "muls r7, r6\n"                           \
    "adds r1, r1, r7\n"                       \
    "adds r6, r6, r5\n"                       \
    "adds r6, r6, r4\n"                       \
    "adds r4, r4, r4\n"
#define LINEAR                  \
    "ldmia r0!, {r1, r3, r4}\n" \
    "movs r6, r3\n"             \
    "mov r7, r10\n"             \
    "muls r3, r7\n"             \
    "mov r7, r11\n"             \
    "muls r4, r7\n"             \
    "adds r1, r1, r3\n"         \
    "adds r1, r1, r4\n"         \
    "adds r0, #12\n"
#define KEEP              \
    "str r1, [sp, #4]\n"  \
    "str r6, [sp, #8]\n"  \
    "str r4, [sp, #12]\n" \
    "adds r0, #4\n"

/* To where the loop has them: r0 depth's address, r1 N.H, r2 N.L, r3 depth, r6 table, r7 to_pixels; r8, r10, r11 their
 * first differences in the order depth, N.L, N.H; r12, lr the second ones of N.L and N.H; r9 the end. */
#define ARRANGE_BOTH      \
    "mov r11, r6\n"       \
    "mov r3, lr\n"        \
    "mov lr, r4\n"        \
    "mov r0, r12\n"       \
    "ldr r2, [sp, #12]\n" \
    "mov r12, r2\n"       \
    "ldr r2, [sp, #8]\n"  \
    "mov r10, r2\n"       \
    "ldr r2, [sp, #4]\n"
#define ARRANGE_DIFFUSE \
    "mov r10, r6\n"     \
    "mov r3, lr\n"      \
    "mov r0, r12\n"     \
    "mov r12, r4\n"     \
    "movs r2, r1\n"

#define TEST                              \
    "ldr r7, [sp]\n"                      \
    "ldr r6, [r7, #28]\n" /* table */     \
    "ldr r7, [r7, #32]\n" /* to_pixels */ \
    "1: ldrh r4, [r0]\n"                  \
    "lsrs r5, r3, #16\n"                  \
    "cmp r5, r4\n"                        \
    "bls 7f\n"                            \
    "strh r5, [r0]\n"                     \
    "lsrs r4, r2, #24\n"                  \
    "cmp r4, #63\n"                       \
    "bhi 5f\n"                            \
    "2: "
#define HIGHLIGHT          \
    "lsrs r5, r1, #23\n"   \
    "cmp r5, #127\n"       \
    "bhi 6f\n"             \
    "3: lsls r5, r5, #6\n" \
    "adds r4, r4, r5\n"
#define STORE             \
    "lsls r4, r4, #1\n"   \
    "ldrh r4, [r4, r6]\n" \
    "strh r4, [r0, r7]\n" \
    "4: add r3, r8\n"     \
    "add r2, r10\n"
#define NEXT_PIXEL          \
    "adds r0, #2\n"         \
    "cmp r0, r9\n"          \
    "bne 1b\n"              \
    "b 10b\n"               \
    "5: asrs r4, r2, #31\n" \
    "mvns r4, r4\n"         \
    "lsrs r4, r4, #26\n"    \
    "b 2b\n"                \
    "7: ldr r4, [sp]\n"     \
    "ldr r5, [r4, #40]\n"   \
    "adds r5, #1\n"         \
    "str r5, [r4, #40]\n"   \
    "b 4b\n"
#define CLAMP_HIGHLIGHT     \
    "6: asrs r5, r1, #31\n" \
    "mvns r5, r5\n"         \
    "lsrs r5, r5, #25\n"    \
    "b 3b\n"

__attribute__((naked)) void spans_hand_diffuse(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER LEAVE NEXT_ROW LINEAR ARRANGE_DIFFUSE TEST STORE NEXT_PIXEL);
}

__attribute__((naked)) void spans_hand_both(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER LEAVE NEXT_ROW LINEAR KEEP LINEAR ARRANGE_BOTH TEST HIGHLIGHT STORE
            "add r1, r11\n" NEXT_PIXEL CLAMP_HIGHLIGHT);
}

__attribute__((naked)) void spans_hand_diffuse_quadratic(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER LEAVE NEXT_ROW QUADRATIC ARRANGE_DIFFUSE TEST STORE "add r10, r12\n" NEXT_PIXEL);
}

__attribute__((naked)) void spans_hand_both_quadratic(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER LEAVE NEXT_ROW QUADRATIC KEEP QUADRATIC ARRANGE_BOTH TEST HIGHLIGHT STORE
            "add r10, r12\n"
            "add r1, r11\n"
            "add r11, lr\n" NEXT_PIXEL CLAMP_HIGHLIGHT);
}

/* 8-bit grey: N.H by 2^TABLE_BITS steps, and clamped sums. */
#define GREY(second_l, second_h)                                      \
    "ldr r7, [sp]\n"                                                  \
    "ldr r6, [r7, #28]\n"                                             \
    "ldr r7, [r7, #32]\n"                                             \
    "1: ldrh r4, [r0]\n"                                              \
    "lsrs r5, r3, #16\n"                                              \
    "cmp r5, r4\n"                                                    \
    "bls 7f\n"                                                        \
    "strh r5, [r0]\n"                                                 \
    "lsrs r4, r1, #30\n"                                              \
    "bne 6f\n"                                                        \
    "lsrs r4, r1, #20\n"                                              \
    "3: lsls r4, r4, #1\n"                                            \
    "ldrh r4, [r4, r6]\n"                                             \
    "asrs r5, r2, #15\n"                                              \
    "bmi 5f\n"                                                        \
    "adds r4, r4, r5\n"                                               \
    "5: lsrs r4, r4, #7\n"                                            \
    "cmp r4, #255\n"                                                  \
    "bhi 8f\n"                                                        \
    "2: lsrs r5, r0, #1\n"                                            \
    "strb r4, [r5, r7]\n"                                             \
    "4: add r3, r8\n"                                                 \
    "add r2, r10\n" second_l "add r1, r11\n" second_h "adds r0, #2\n" \
    "cmp r0, r9\n"                                                    \
    "bne 1b\n"                                                        \
    "b 10b\n"                                                         \
    "6: asrs r4, r1, #31\n"                                           \
    "mvns r4, r4\n"                                                   \
    "lsrs r4, r4, #22\n"                                              \
    "b 3b\n"                                                          \
    "8: movs r4, #255\n"                                              \
    "b 2b\n"                                                          \
    "7: ldr r4, [sp]\n"                                               \
    "ldr r5, [r4, #40]\n"                                             \
    "adds r5, #1\n"                                                   \
    "str r5, [r4, #40]\n"                                             \
    "b 4b\n"

__attribute__((naked)) void spans_hand_grey(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER LEAVE NEXT_ROW LINEAR KEEP LINEAR ARRANGE_BOTH GREY("", ""));
}

__attribute__((naked)) void spans_hand_grey_quadratic(struct spans_hand *rows)
{
    (void)rows;
    __asm__(ENTER LEAVE NEXT_ROW QUADRATIC KEEP QUADRATIC ARRANGE_BOTH GREY("add r10, r12\n", "add r11, lr\n"));
}
#endif

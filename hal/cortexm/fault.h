/* SPDX-License-Identifier: MIT */
/*
 * A program that cannot go on. Nothing of its state can be trusted, neither stack nor variables nor what its
 * peripherals are doing, so a fault is told on the serial line and the machine starts anew; a record in RAM that
 * start-up leaves alone says then what happened, for the display. A fault before that was asked for ends the program:
 * no endless starting.
 */
#ifndef HAL_CORTEXM_FAULT_H
#define HAL_CORTEXM_FAULT_H

#include <stdint.h>

struct fault {
    uint32_t number;   /* of the exception: 3 HardFault, others by the architecture's manual; 0: stack_check() */
    uint32_t at, from; /* program counter and link register; 0 where they are not known */
    uint32_t overflow; /* 1: the stack's end was written */
};

/* The fault after which the machine has started anew: 1, and it is forgotten. Else 0. */
int fault_last(struct fault *fault);

#define FAULT_TEXT 64
/* "fault 3, at 00001234, from 00005678" or "fault, stack overflow, at 00001234", zero-terminated: clauses for the lines
 * of a small screen. */
void fault_text(const struct fault *fault, char text[FAULT_TEXT]);

/* Does not return. */
_Noreturn void fault_end(const struct fault *fault);

#endif

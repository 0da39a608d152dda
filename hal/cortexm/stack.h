/* SPDX-License-Identifier: MIT */
/* The stack: a region of its own at RAM's end (boards/cortexm.ld), painted by start-up; a second CPU's lies below. */
#ifndef HAL_CORTEXM_STACK_H
#define HAL_CORTEXM_STACK_H

#include <stdint.h>

#define STACK_PAINT  0x57AC57ACu
#define STACK_CANARY 4 /* words at its end that a program must never reach */

/* Its bytes, and how many of them were ever written: interrupts included, what was reserved but never written not. */
uint32_t stack_size(void);
uint32_t stack_used(void);

/* 1 if the words at its end were written, or at the end of a second CPU's. */
int stack_broken(void);

/* Ends the program by a fault if they were. */
void stack_check(void);

#endif

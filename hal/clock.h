/* SPDX-License-Identifier: MIT */
/* Time. One implementation is linked: the machine's. */
#ifndef HAL_CLOCK_H
#define HAL_CLOCK_H

#include <stdint.h>

/* Microseconds since start, modulo 2^32. */
uint32_t clock_us(void);

/* Returns after at least so many. */
void clock_wait_us(uint32_t us);

/* Sleeps until an interrupt, at most some milliseconds. */
void clock_idle(void);

#endif

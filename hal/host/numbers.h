/* SPDX-License-Identifier: MIT */
/* Numbers from a command line, read strictly: decimal digits, no sign, no spaces. */
#ifndef HAL_HOST_NUMBERS_H
#define HAL_HOST_NUMBERS_H

#include <stdint.h>

/* The number that `text` begins with: what stands after it, or null if it has no digit or says more than 32 bits. */
const char *numbers_digits(const char *text, uint32_t *value);

/* 1, and the value; 0 with nothing changed if `text` is no whole number in low..high. */
int numbers_whole(const char *text, uint32_t low, uint32_t high, uint32_t *value);

/* The same of a size, WIDTHxHEIGHT, both in 1..most; most is at most 65535. */
int numbers_size(const char *text, uint32_t most, uint16_t *width, uint16_t *height);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * What a Cortex-M program asks of whatever runs it: semihost.c answers for emulators and debuggers, serial.c with a
 * machine's uart.c for boards; link exactly one.
 */
#ifndef HAL_CORTEXM_MACHINE_H
#define HAL_CORTEXM_MACHINE_H

#include <stdint.h>

/* Shows a zero-terminated text. */
void machine_write(const char *text);

/* Copies the command line, zero-terminated, into line[size]: 0, or -1 if there is none or no room. */
int machine_command_line(char *line, uint32_t size);

/* Ends the program; does not return. */
_Noreturn void machine_exit(int code);

/* Starts the machine anew as after power-up, but that RAM keeps what it holds; under an emulator's semihosting it ends
 * with code 3 instead. Does not return. */
_Noreturn void machine_reset(void);

/* The CPU's own 24-bit timer as a stopwatch: ticks of the CPU's clock since systick_start(), less than 2^24. */
void systick_start(void);
uint32_t systick_elapsed(void);

#endif

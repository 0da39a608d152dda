/* SPDX-License-Identifier: MIT */
/* serial.h and machine.h on Arm's PL011, as LM3S and RP2040 have it; the machine gives clock, pins and interrupt. */
#ifndef HAL_CORTEXM_UART_H
#define HAL_CORTEXM_UART_H

#include <stdint.h>

/* The machine's: where its PL011 is. A constant, so that a fault can be told whatever became of RAM. */
extern const uint32_t uart_base;

/* The machine's: 1 if the block can be touched; may start it. */
int uart_awake(void);

/* 8 bits, no parity; the divisor is the clock over 16 times the baud rate, in 1/64. Its interrupt has to be enabled. */
void uart_start(uint32_t divisor);

/* The block's interrupt. */
void uart_interrupt(void);

#endif

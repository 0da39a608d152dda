/* SPDX-License-Identifier: MIT */
/* The interrupts, behind the system's vectors at the flash's 0x100, where the second stage has pointed the core. */
#include "cortexm/uart.h"
#include "rp2040/rp2040.h"

#define VECTORS_TIMER 0
#define VECTORS_UART  20
#define VECTORS       26

void start_fault(void);

__attribute__((section(".vectors.interrupts"), used)) static const void *const vectors[VECTORS] = {
    [VECTORS_TIMER] = (const void *)rp2040_timer_alarm,
    [VECTORS_TIMER + 1 ... VECTORS_UART - 1] = (const void *)start_fault,
    [VECTORS_UART] = (const void *)uart_interrupt,
    [VECTORS_UART + 1 ... VECTORS - 1] = (const void *)start_fault,
};

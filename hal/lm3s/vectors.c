/* SPDX-License-Identifier: MIT */
/* The interrupts (data sheet 4, table 4-9), behind the system's vectors. */
#include "cortexm/uart.h"
#include "lm3s/lm3s.h"

#define VECTORS 44

void start_fault(void);

__attribute__((section(".vectors.interrupts"), used)) static const void *const vectors[VECTORS] = {
    [0 ... LM3S_IRQ_UART0 - 1] = (const void *)start_fault,
    [LM3S_IRQ_UART0] = (const void *)uart_interrupt,
    [LM3S_IRQ_UART0 + 1 ... LM3S_IRQ_SSI0 - 1] = (const void *)start_fault,
    [LM3S_IRQ_SSI0] = (const void *)lm3s_ssi_interrupt,
    [LM3S_IRQ_SSI0 + 1 ... VECTORS - 1] = (const void *)start_fault,
};

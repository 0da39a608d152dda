/* SPDX-License-Identifier: MIT */
/* UART0 (data sheet 12, Arm's PL011) for cortexm/uart.c, and the way to begin anew. */
#include "cortexm/uart.h"
#include "cortexm/machine.h"
#include "lm3s/lm3s.h"

#define UART_RCGC1 LM3S_REGISTER(LM3S_SYSTEM, 0x104)
#define UART_RCGC2 LM3S_REGISTER(LM3S_SYSTEM, 0x108)

#define RCGC1_UART0  (1u << 0)
#define RCGC2_PORT_A (1u << 0)

#define UART_BAUD 115200u
/* LM3S_HZ / (16 baud) in 1/64, rounded: 27 8/64 */
#define UART_DIVISOR ((LM3S_HZ * 8u / UART_BAUD + 1) / 2)

#define SCB_AIRCR     (*(volatile uint32_t *)0xE000ED0Cu)
#define AIRCR_REQUEST 0x05FA0004u

const uint32_t uart_base = LM3S_UART0;

void lm3s_uart_start(void)
{
    UART_RCGC1 |= RCGC1_UART0;
    UART_RCGC2 |= RCGC2_PORT_A;
    (void)UART_RCGC2; /* three cycles until a block may be touched */
    (void)UART_RCGC2;
    lm3s_pins_alternate((struct lm3s_pins){LM3S_GPIOA, 3});
    uart_start(UART_DIVISOR);
    lm3s_interrupt_enable(LM3S_IRQ_UART0);
}

/* Starts itself, so that an early fault is told. */
int uart_awake(void)
{
    if (!(UART_RCGC1 & RCGC1_UART0))
        lm3s_uart_start();
    return 1;
}

_Noreturn void machine_reset(void)
{
    SCB_AIRCR = AIRCR_REQUEST;
    for (;;)
        ;
}

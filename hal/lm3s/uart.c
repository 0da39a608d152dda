/* SPDX-License-Identifier: MIT */
/* UART0 (data sheet 12): where the program's messages and a fault's go. Polled, so that it also works in a fault. */
#include "cortexm/machine.h"
#include "lm3s/lm3s.h"

#define UART_DATA     LM3S_REGISTER(LM3S_UART0, 0x000)
#define UART_FLAGS    LM3S_REGISTER(LM3S_UART0, 0x018)
#define UART_INTEGER  LM3S_REGISTER(LM3S_UART0, 0x024)
#define UART_FRACTION LM3S_REGISTER(LM3S_UART0, 0x028)
#define UART_LINE     LM3S_REGISTER(LM3S_UART0, 0x02C)
#define UART_CONTROL  LM3S_REGISTER(LM3S_UART0, 0x030)

#define UART_RCGC1 LM3S_REGISTER(LM3S_SYSTEM, 0x104)
#define UART_RCGC2 LM3S_REGISTER(LM3S_SYSTEM, 0x108)

#define RCGC1_UART0   (1u << 0)
#define RCGC2_PORT_A  (1u << 0)
#define FLAG_BUSY     (1u << 3)
#define FLAG_FULL     (1u << 5)
#define LINE_8N1_FIFO 0x70u
#define CONTROL_ON    0x301u /* the block, its transmitter and its receiver */

#define UART_BAUD 115200u
/* LM3S_HZ / (16 baud) in 1/64, rounded: 27 8/64 */
#define UART_DIVISOR ((LM3S_HZ * 8u / UART_BAUD + 1) / 2)

void lm3s_uart_start(void)
{
    UART_RCGC1 |= RCGC1_UART0;
    UART_RCGC2 |= RCGC2_PORT_A;
    (void)UART_RCGC2; /* three cycles until a block may be touched */
    (void)UART_RCGC2;
    lm3s_pins_alternate((struct lm3s_pins){LM3S_GPIOA, 3});
    UART_CONTROL = 0;
    UART_INTEGER = UART_DIVISOR / 64;
    UART_FRACTION = UART_DIVISOR % 64;
    UART_LINE = LINE_8N1_FIFO;
    UART_CONTROL = CONTROL_ON;
}

void machine_write(const char *text)
{
    if (!(UART_RCGC1 & RCGC1_UART0))
        lm3s_uart_start();
    for (; *text; text++) {
        while (UART_FLAGS & FLAG_FULL)
            ;
        UART_DATA = (unsigned char)*text;
    }
}

/* There is nowhere to go: stays until reset. */
_Noreturn void machine_exit(int code)
{
    (void)code;
    while (UART_FLAGS & FLAG_BUSY)
        ;
    __asm volatile("cpsid i");
    for (;;)
        __asm volatile("wfi");
}

/* SPDX-License-Identifier: MIT */
/* UART0 at 115,200 baud for cortexm/uart.c; the interrupts' vectors, and the way to begin anew. */
#include "cortexm/uart.h"
#include "cortexm/machine.h"
#include "rp2040/registers.h"
#include "rp2040/rp2040.h"

#define UART_DIVISOR (67u * 64u + 52u) /* 125 MHz / 16 / 115200 */
#define UART_IRQ     20u               /* 2.3.2 */

/* 2.13.5 and 4.7: the watchdog begins the power-on sequence again, except the oscillators; without a word in its fourth
 * scratch register the ROM boots from flash. */
#define PSM_WDSEL        0x40010008u
#define PSM_ALL          0x1FFFCu
#define WATCHDOG_CTRL    0x40058000u
#define WATCHDOG_TRIGGER (1u << 31)
#define WATCHDOG_SCRATCH 0x4005801Cu

const uint32_t uart_base = UART_DR;

int uart_awake(void)
{
    return !(REG(RESETS_RESET) & RESET_UART0);
}

void rp2040_uart_start(void)
{
    rp2040_reset(RESET_UART0);
    rp2040_pin(rp2040_board.uart_tx, PIN_UART, PAD_INPUT | PAD_DRIVE_4MA);
    rp2040_pin(rp2040_board.uart_rx, PIN_UART, PAD_INPUT | PAD_PULL_UP | PAD_SCHMITT);
    uart_start(UART_DIVISOR);
    REG(NVIC_ENABLE) = 1u << UART_IRQ;
}

_Noreturn void machine_reset(void)
{
    REG(PSM_WDSEL) = PSM_ALL;
    REG(WATCHDOG_SCRATCH) = 0;
    REG(WATCHDOG_CTRL) = WATCHDOG_TRIGGER;
    for (;;)
        ;
}

/* SPDX-License-Identifier: MIT */
/* machine.h on UART0, 115,200 baud, 8N1. */
#include "cortexm/machine.h"
#include "rp2040/registers.h"
#include "rp2040/rp2040.h"

#define BAUD_WHOLE    67u /* 125 MHz / 16 / 115200 = 67 + 52/64 */
#define BAUD_FRACTION 52u
#define LCR_8N1_FIFO  0x70u
#define CR_ENABLE     0x301u

void rp2040_uart_start(void)
{
    rp2040_reset(RESET_UART0);
    rp2040_pin(rp2040_board.uart_tx, PIN_UART, PAD_INPUT | PAD_DRIVE_4MA);
    rp2040_pin(rp2040_board.uart_rx, PIN_UART, PAD_INPUT | PAD_PULL_UP | PAD_SCHMITT);
    REG(UART_IBRD) = BAUD_WHOLE;
    REG(UART_FBRD) = BAUD_FRACTION;
    REG(UART_LCR) = LCR_8N1_FIFO; /* after the divisors, which it makes valid */
    REG(UART_CR) = CR_ENABLE;
}

void machine_write(const char *text)
{
    for (; *text; text++) {
        while (REG(UART_FR) & UART_FR_TXFF)
            ;
        REG(UART_DR) = (unsigned char)*text;
    }
}

/* The line that stands in the receiver's 32 bytes. */
int machine_command_line(char *line, uint32_t size)
{
    uint32_t length = 0;
    while (length < size && !(REG(UART_FR) & UART_FR_RXFE)) {
        line[length] = (char)REG(UART_DR);
        if (line[length] == '\n') {
            line[length] = 0;
            return 0;
        }
        length++;
    }
    return -1;
}

/* There is nothing to return to: says how it ended, and sleeps. */
_Noreturn void machine_exit(int code)
{
    char text[] = "exit 0\n";
    text[5] = (char)('0' + (code & 7));
    machine_write(text);
    for (;;)
        __asm volatile("wfi");
}

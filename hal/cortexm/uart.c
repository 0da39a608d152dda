/* SPDX-License-Identifier: MIT */
/* PL011 (Arm DDI 0183). Sending is polled, so that it also works in a fault; what comes is collected by interrupt. */
#include "cortexm/uart.h"
#include "cortexm/machine.h"
#include "serial.h"

#define UART(offset)  (*(volatile uint32_t *)(uintptr_t)(uart_base + (offset)))
#define UART_DATA     UART(0x00)
#define UART_FLAGS    UART(0x18)
#define UART_INTEGER  UART(0x24)
#define UART_FRACTION UART(0x28)
#define UART_LINE     UART(0x2C)
#define UART_CONTROL  UART(0x30)
#define UART_MASK     UART(0x38)
#define UART_CLEAR    UART(0x44)

#define DATA_DAMAGED  0x700u /* break, parity, framing */
#define DATA_OVERRUN  0x800u
#define FLAG_BUSY     (1u << 3)
#define FLAG_EMPTY    (1u << 4) /* nothing has come */
#define FLAG_FULL     (1u << 5)
#define LINE_8N1_FIFO 0x70u
#define CONTROL_ON    0x301u                /* the block, its transmitter and its receiver */
#define RECEIVED      ((1u << 4) | 1u << 6) /* half of the FIFO, or some and then a pause of 32 bits */

/* Written by the interrupt alone: `come`, `lost`; by the reader alone: `gone`. Both counts are modulo 2^32. */
static struct {
    volatile uint32_t come, gone, lost;
    uint8_t bytes[SERIAL_WAITING];
} uart_ring;

void uart_start(uint32_t divisor)
{
    UART_CONTROL = 0;
    UART_INTEGER = divisor / 64;
    UART_FRACTION = divisor % 64;
    UART_LINE = LINE_8N1_FIFO; /* after the divisors, which it makes valid */
    UART_MASK = RECEIVED;
    UART_CONTROL = CONTROL_ON;
}

void uart_interrupt(void)
{
    UART_CLEAR = RECEIVED;
    while (!(UART_FLAGS & FLAG_EMPTY)) {
        uint32_t data = UART_DATA, come = uart_ring.come;
        if (data & (DATA_DAMAGED | DATA_OVERRUN)) /* with an overrun comes a good byte, and one is missing */
            uart_ring.lost++;
        if (data & DATA_DAMAGED)
            continue;
        if (come - uart_ring.gone == SERIAL_WAITING) {
            uart_ring.lost++;
            continue;
        }
        uart_ring.bytes[come % SERIAL_WAITING] = (uint8_t)data;
        uart_ring.come = come + 1;
    }
}

uint32_t serial_read(void *bytes, uint32_t size)
{
    uint8_t *to = bytes;
    uint32_t gone = uart_ring.gone, waiting = uart_ring.come - gone, count = waiting < size ? waiting : size;
    for (uint32_t i = 0; i < count; i++)
        to[i] = uart_ring.bytes[(gone + i) % SERIAL_WAITING];
    __asm volatile("" ::: "memory"); /* the room is given back when it was read */
    uart_ring.gone = gone + count;
    return count;
}

uint32_t serial_lost(void)
{
    return uart_ring.lost;
}

void serial_write(const void *bytes, uint32_t count)
{
    if (!uart_awake())
        return;
    for (const uint8_t *byte = bytes; count; count--) {
        while (UART_FLAGS & FLAG_FULL)
            ;
        UART_DATA = *byte++;
    }
}

void machine_write(const char *text)
{
    uint32_t length = 0;
    while (text[length])
        length++;
    serial_write(text, length);
}

/* The line that has come, if its end has. */
int machine_command_line(char *line, uint32_t size)
{
    for (uint32_t length = 0; length < size && serial_read(line + length, 1); length++)
        if (line[length] == '\n') {
            line[length] = 0;
            return 0;
        }
    return -1;
}

/* There is nothing to return to: says how it ended, and stays until reset. */
_Noreturn void machine_exit(int code)
{
    char text[] = "exit 0\n";
    text[5] = (char)('0' + (code & 7));
    machine_write(text);
    while (uart_awake() && UART_FLAGS & FLAG_BUSY)
        ;
    __asm volatile("cpsid i");
    for (;;)
        __asm volatile("wfi");
}

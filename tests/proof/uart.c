/* SPDX-License-Identifier: MIT */
/*
 * The line of a Cortex-M: whatever its registers give at any time, and wherever the interrupt and the reader stand
 * (the ring's counts are volatile: any values), bytes go into the ring alone and out of it into the room given.
 * Rooms of up to 9 bytes, one by one: nothing lies behind them.
 *
 *   proves: uart_start uart_interrupt serial_read serial_lost serial_write uart_drain machine_write
 *           machine_command_line
 *   options: -eva-precision 1 -eva-slevel 200 -eva-slevel-function prove:0
 *            -absolute-valid-range 0x40000000-0x40000fff
 */
#include "proof.h"

#include "hal/cortexm/uart.c"

#define MOST 9

const uint32_t uart_base = 0x40000000;

int uart_awake(void)
{
    return any_flag();
}

static void use(uint32_t room)
{
    char bytes[MOST];
    char *at = bytes + MOST - room;
    uart_interrupt();
    uint32_t count = serial_read(at, room);
    //@ assert count <= room;
    any_bytes(bytes, sizeof bytes);
    serial_write(at, room);
    machine_command_line(at, room);
    any_bytes(bytes, sizeof bytes);
    bytes[MOST - 1] = 0;
    if (room)
        machine_write(at);
}

void prove(void)
{
    uart_start(ANY_U32);
    //@ loop unroll 10;
    for (uint32_t room = 0; room <= MOST; room++)
        use(room);
    uart_drain();
    serial_lost();
}

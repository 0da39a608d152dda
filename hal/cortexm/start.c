/* SPDX-License-Identifier: MIT */
/* Start-up of any Cortex-M: the linker script gives the bounds, machine_exit() is the board's. */
#include "cortexm/machine.h"

#include <stdint.h>

extern uint32_t link_stack_top[], link_data_load[], link_data[], link_data_end[], link_bss[], link_bss_end[];

int main(void);
void start_reset(void);
void start_fault(void);
void start_systick(void);
_Noreturn void start_report(const uint32_t *frame);

void start_reset(void)
{
    /* the linker's symbols are separate objects to the compiler: compared as addresses */
    const uint32_t *from = link_data_load;
    for (uint32_t *to = link_data; (uintptr_t)to != (uintptr_t)link_data_end; to++)
        *to = *from++;
    for (uint32_t *to = link_bss; (uintptr_t)to != (uintptr_t)link_bss_end; to++)
        *to = 0;
    machine_exit(main());
}

static void start_hex(uint32_t value)
{
    char text[9];
    for (int i = 0; i < 8; i++)
        text[i] = "0123456789abcdef"[value >> (28 - 4 * i) & 15];
    text[8] = 0;
    machine_write(text);
}

/* `frame` is what the exception stacked: r0-r3, r12, lr, pc, psr. */
_Noreturn void start_report(const uint32_t *frame)
{
    uint32_t exception;
    __asm volatile("mrs %0, ipsr" : "=r"(exception));
    machine_write("fault ");
    start_hex(exception);
    machine_write(" at ");
    start_hex(frame[6]);
    machine_write(" from ");
    start_hex(frame[5]);
    machine_write("\n");
    machine_exit(3);
}

__attribute__((naked)) void start_fault(void)
{
    __asm volatile("mrs r0, msp\n\tbl start_report");
}

/* The stack, then the system exceptions; no board here enables an interrupt of a block. */
__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    link_stack_top,
    (const void *)start_reset,
    (const void *)start_fault,
    (const void *)start_fault,
    (const void *)start_fault,
    (const void *)start_fault,
    (const void *)start_fault,
    [15] = (const void *)start_systick,
};

/* SPDX-License-Identifier: MIT */
/* Start-up of any Cortex-M: the linker script gives the bounds, machine_exit() is the board's. */
#include "cortexm/machine.h"

#include <stdint.h>

extern uint32_t link_stack_top[], link_data_load[], link_data[], link_data_end[], link_bss[], link_bss_end[];

int main(void);
void start_reset(void);
void start_fault(void);

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

void start_fault(void)
{
    machine_write("fault\n");
    machine_exit(3);
}

/* The stack, then the system exceptions; no board here enables an interrupt. */
__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    link_stack_top,
    (const void *)start_reset,
    (const void *)start_fault,
    (const void *)start_fault,
    (const void *)start_fault,
    (const void *)start_fault,
    (const void *)start_fault,
};

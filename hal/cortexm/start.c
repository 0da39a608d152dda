/* SPDX-License-Identifier: MIT */
/* Start-up of any Cortex-M: the linker script gives the bounds, machine_exit() is the board's. */
#include "cortexm/machine.h"
#include "cortexm/stack.h"

#include <stdint.h>

extern uint32_t link_stacks[], link_stack_top[], link_data_load[], link_data[], link_data_end[], link_bss[],
    link_bss_end[];

int main(void);
void start_reset(void);
void start_fault(void);
void start_systick(void);
void start_stack(void);

void start_reset(void)
{
    const uint32_t *from = link_data_load, *used;
    /* the linker's symbols are separate objects to the compiler: compared as addresses */
    for (uint32_t *to = link_data; (uintptr_t)to != (uintptr_t)link_data_end; to++)
        *to = *from++;
    for (uint32_t *to = link_bss; (uintptr_t)to != (uintptr_t)link_bss_end; to++)
        *to = 0;
    __asm volatile("mov %0, sp" : "=r"(used));
    for (uint32_t *to = link_stacks; (uintptr_t)to < (uintptr_t)used; to++)
        *to = STACK_PAINT;
    machine_exit(main());
}

/* In r3 where the stack begins of the CPU that calls; touches nothing else. A machine with a second CPU has its own:
 * the other one may still use its stack. */
__attribute__((naked, weak)) void start_stack(void)
{
    __asm volatile("ldr r3, =link_stack_top\n"
                   "bx lr\n"
                   ".ltorg");
}

/* Every exception that nobody serves. What it stacked (r0-r3, r12, lr, pc, psr) is read if it lies in RAM, and then the
 * stack is begun anew: it may be what failed. */
__attribute__((naked)) void start_fault(void)
{
    __asm volatile("mrs r2, msp\n"
                   "ldr r3, =link_kept\n"
                   "cmp r2, r3\n"
                   "blo 1f\n"
                   "ldr r3, =link_stack_top - 32\n"
                   "cmp r2, r3\n"
                   "bhi 1f\n"
                   "ldr r0, [r2, #24]\n"
                   "ldr r1, [r2, #20]\n"
                   "b 2f\n"
                   "1: movs r0, #0\n"
                   "movs r1, #0\n"
                   "2: bl start_stack\n"
                   "mov sp, r3\n"
                   "bl fault_exception\n"
                   ".ltorg");
}

/* The stack, then the system exceptions; a machine's interrupts follow from a section of its own, .vectors.interrupts.
 */
__attribute__((section(".vectors"), used)) static const void *const vectors[16] = {
    [0] = link_stack_top,
    [1] = (const void *)start_reset,
    [2 ... 14] = (const void *)start_fault,
    [15] = (const void *)start_systick,
};

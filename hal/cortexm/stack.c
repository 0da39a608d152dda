/* SPDX-License-Identifier: MIT */
#include "cortexm/stack.h"
#include "cortexm/fault.h"

extern const uint32_t link_stacks[], link_stack[], link_stack_top[];

uint32_t stack_size(void)
{
    return (uint32_t)((uintptr_t)link_stack_top - (uintptr_t)link_stack);
}

uint32_t stack_used(void)
{
    const uint32_t *word = link_stack;
    while (*word == STACK_PAINT)
        word++;
    return (uint32_t)((uintptr_t)link_stack_top - (uintptr_t)word);
}

int stack_broken(void)
{
    for (int i = 0; i < STACK_CANARY; i++)
        if (link_stack[i] != STACK_PAINT || link_stacks[i] != STACK_PAINT)
            return 1;
    return 0;
}

void stack_check(void)
{
    if (stack_broken())
        fault_end(&(struct fault){.at = (uint32_t)(uintptr_t)__builtin_return_address(0), .overflow = 1});
}

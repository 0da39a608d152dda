/* SPDX-License-Identifier: MIT */
#include "cortexm/machine.h"

#define SYSTICK_CONTROL ((volatile uint32_t *)0xE000E010u)
#define SYSTICK_RELOAD  ((volatile uint32_t *)0xE000E014u)
#define SYSTICK_VALUE   ((volatile uint32_t *)0xE000E018u)
#define SYSTICK_TOP     0xFFFFFFu

void systick_start(void)
{
    *SYSTICK_CONTROL = 0;
    *SYSTICK_RELOAD = SYSTICK_TOP;
    *SYSTICK_VALUE = 0;
    *SYSTICK_CONTROL = 5; /* on, the CPU's clock, no interrupt */
}

uint32_t systick_elapsed(void)
{
    return (SYSTICK_TOP - *SYSTICK_VALUE) & SYSTICK_TOP;
}

/* SPDX-License-Identifier: MIT */
/* What the handheld's program asks of a machine. Its serial line is standard output; faults and the stack are the
 * kernel's affair. */
#include "cortexm/machine.h"
#include "cortexm/fault.h"
#include "cortexm/stack.h"

#include <stdio.h>

void machine_write(const char *text)
{
    fputs(text, stdout);
    fflush(stdout);
}

int fault_last(struct fault *fault)
{
    (void)fault;
    return 0;
}

void fault_text(const struct fault *fault, char text[FAULT_TEXT])
{
    (void)fault;
    text[0] = 0;
}

uint32_t stack_used(void)
{
    return 0;
}

void stack_check(void) {}

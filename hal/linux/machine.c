/* SPDX-License-Identifier: MIT */
/* What the handheld's program asks of a machine. Its serial line is standard output and, where that is no terminal,
 * standard input; faults and the stack are the kernel's affair. */
#include "cortexm/machine.h"
#include "cortexm/fault.h"
#include "cortexm/stack.h"
#include "serial.h"

#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

void serial_write(const void *bytes, uint32_t count)
{
    fwrite(bytes, 1, count, stdout);
    fflush(stdout);
}

void machine_write(const char *text)
{
    serial_write(text, (uint32_t)strlen(text));
}

/* Never from a terminal: what is typed there is no request, and who reads in the background is stopped. */
uint32_t serial_read(void *bytes, uint32_t size)
{
    struct pollfd input = {.fd = STDIN_FILENO, .events = POLLIN};
    if (isatty(STDIN_FILENO) || poll(&input, 1, 0) != 1 || !(input.revents & POLLIN))
        return 0;
    ssize_t count = read(STDIN_FILENO, bytes, size);
    return count > 0 ? (uint32_t)count : 0;
}

uint32_t serial_lost(void)
{
    return 0;
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

/* SPDX-License-Identifier: MIT */
/* The Arm semihosting calls (ARM document 100863) that a test image needs. */
#include "cortexm/machine.h"

enum semihost_call { SYS_WRITE0 = 0x04, SYS_GET_CMDLINE = 0x15, SYS_EXIT_EXTENDED = 0x20 };
#define ADP_STOPPED_APPLICATION_EXIT 0x20026u

static uint32_t semihost(enum semihost_call call, const void *argument)
{
    register uint32_t r0 __asm("r0") = call;
    register const void *r1 __asm("r1") = argument;
    __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void machine_write(const char *text)
{
    semihost(SYS_WRITE0, text);
}

int machine_command_line(char *line, uint32_t size)
{
    struct {
        char *line;
        uint32_t size;
    } block = {line, size};
    return semihost(SYS_GET_CMDLINE, &block) == 0 ? 0 : -1;
}

_Noreturn void machine_exit(int code)
{
    const uint32_t block[2] = {ADP_STOPPED_APPLICATION_EXIT, (uint32_t)code};
    for (;;)
        semihost(SYS_EXIT_EXTENDED, block);
}

_Noreturn void machine_reset(void)
{
    machine_exit(3);
}

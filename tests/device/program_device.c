/* SPDX-License-Identifier: MIT */
#include "tests/device/program.h"

#include "cortexm/machine.h"

/* Under `-icount shift=0` an instruction takes 1 ns, and the CPU's clock on the mps2 boards is 25 MHz. */
#define INSTRUCTIONS_PER_TICK 40u

int main(void);

void program_write(const char *text)
{
    machine_write(text);
}

#ifdef PROGRAM_COUNTS
void program_count_start(void)
{
    systick_start();
}
uint32_t program_count(void)
{
    return systick_elapsed() * INSTRUCTIONS_PER_TICK;
}
#else
void program_count_start(void) {}
uint32_t program_count(void)
{
    return 0;
}
#endif

int main(void)
{
    static char line[128];
    char *argv[PROGRAM_ARGUMENTS + 1] = {line};
    int argc = 0;
    if (machine_command_line(line, sizeof line) != 0)
        line[0] = 0;
    for (char *c = line; *c && argc < PROGRAM_ARGUMENTS;) {
        argv[argc++] = c;
        while (*c && *c != ' ')
            c++;
        if (*c)
            *c++ = 0;
    }
    argv[argc] = 0;
    return program_main(argc, argv);
}

/* SPDX-License-Identifier: MIT */
#include "tests/device/program.h"

#include <stdio.h>

void program_write(const char *text)
{
    fputs(text, stdout);
}
void program_count_start(void) {}
uint32_t program_count(void)
{
    return 0;
}

int main(int argc, char **argv)
{
    int code = program_main(argc, argv);
    return fflush(stdout) == 0 ? code : 3;
}

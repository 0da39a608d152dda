/* SPDX-License-Identifier: MIT */
/* The handheld's serial line is standard output here. */
#include "cortexm/machine.h"

#include <stdio.h>

void machine_write(const char *text)
{
    fputs(text, stdout);
    fflush(stdout);
}

/* SPDX-License-Identifier: MIT */
#include "linux/problem.h"
#include "display.h"

#include <stdarg.h>
#include <stdio.h>

int problem_set(struct problem *problem, const char *format, ...)
{
    va_list arguments;
    if (problem->text[0])
        return HAL_E_IO;
    va_start(arguments, format);
    vsnprintf(problem->text, sizeof problem->text, format, arguments);
    va_end(arguments);
    fprintf(stderr, "glint-device: %s\n", problem->text);
    return HAL_E_IO;
}

/* SPDX-License-Identifier: MIT */
/* The program as a WebAssembly module: wasm.mjs calls program_start() and gets its lines by write_text(). */
#include "tests/device/program.h"

#include <stddef.h>

__attribute__((import_module("env"), import_name("write_text"))) void write_text(const char *text, size_t length);
int program_start(void);

void program_write(const char *text)
{
    size_t length = 0;
    while (text[length])
        length++;
    write_text(text, length);
}
void program_count_start(void) {}
uint32_t program_count(void)
{
    return 0;
}

int program_start(void)
{
    char name[] = "golden", *argv[] = {name, NULL};
    return program_main(1, argv);
}

/* SPDX-License-Identifier: MIT */
/* Scene files: any text becomes a scene that passes the check and is drawn, or one message and exit code 1; nothing is
 * leaked, and no file is written. */
#define _GNU_SOURCE
#include "fuzz/load.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char path[LOAD_PATH];
    int file = load_file("a.json", data, size, path);
    struct load load = load_path(path);
    load_close(file, path);
    const char *end = strchr(load.told, '\n');
    if (load.code == 0) {
        FUZZ_CHECK(load.told_size == 0);
        load_draw(&load);
    } else {
        FUZZ_CHECK(load.code == 1 && end && !end[1] && strncmp(load.told, path, strlen(path)) == 0);
    }
    load_free(&load);
    return 0;
}

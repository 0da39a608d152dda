/* SPDX-License-Identifier: MIT */
/*
 * A file that is there whole or not at all: written under a temporary name beside its target, which takes the target's
 * place when it is complete. Devices, pipes and standard output ("-") are written directly.
 */
#ifndef HOST_SINK_H
#define HOST_SINK_H

#include <stddef.h>
#include <stdio.h>

struct sink {
    FILE *stream;
    char *target;    /* null: nothing to rename */
    char *temporary; /* null: written directly */
};

/* All return 0 or HAL_E_IO with the reason in errno. */
int sink_open(struct sink *sink, const char *path);
int sink_write(struct sink *sink, const void *bytes, size_t size);
/* keep == 0 removes what was written. Harmless on a sink that is all zeros. */
int sink_close(struct sink *sink, int keep);

#endif

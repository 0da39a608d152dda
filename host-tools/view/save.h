/* SPDX-License-Identifier: MIT */
/* A stream's bytes as they came, for `file:` to be shown again. */
#ifndef VIEW_SAVE_H
#define VIEW_SAVE_H

#include "host/sink.h"

#include <stdbool.h>

struct save {
    const char *path; /* or null: nothing is saved. Set by the caller, all else is zero at first */
    struct sink sink; /* open from the first bytes on */
    bool open;
};

/* Exit codes, with a message; after any but CLI_DONE there is no file and nothing more is saved. */
int save_bytes(struct save *save, const void *bytes, size_t size);

/* The file appears, if there was anything. */
int save_close(struct save *save);

#endif

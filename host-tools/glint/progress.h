/* SPDX-License-Identifier: MIT */
/* A bar on stderr for work that takes more than a moment. */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdbool.h>
#include <stdint.h>

struct progress {
    bool wanted, shown;
    double start, last; /* cli_clock() */
};

/* The bar appears only on a terminal, unless `always`. */
void progress_begin(struct progress *progress, bool always);
void progress_step(struct progress *progress, uint32_t done, uint32_t total);
/* Removes it. */
void progress_end(struct progress *progress);

#endif

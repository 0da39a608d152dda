/* SPDX-License-Identifier: MIT */
#include "glint/progress.h"

#include "glint/cli.h"

#include <stdio.h>
#include <unistd.h>

#define PROGRESS_DELAY 500. /* ms: shorter work shows nothing */
#define PROGRESS_PAUSE 100. /* ms between two looks of the bar */
#define PROGRESS_WIDTH 40

void progress_begin(struct progress *progress, bool always)
{
    double now = cli_clock();
    *progress = (struct progress){.wanted = always || isatty(STDERR_FILENO), .start = now, .last = now};
}

void progress_step(struct progress *progress, uint32_t done, uint32_t total)
{
    static const char full[] = "########################################";
    double now = cli_clock();
    if (!progress->wanted || now - progress->start < PROGRESS_DELAY || now - progress->last < PROGRESS_PAUSE)
        return;
    int filled = (int)((uint64_t)done * PROGRESS_WIDTH / total);
    fprintf(stderr, "\r[%-*.*s] %u/%u", PROGRESS_WIDTH, filled, full, (unsigned)done, (unsigned)total);
    fflush(stderr);
    progress->last = now;
    progress->shown = true;
}

void progress_end(struct progress *progress)
{
    if (progress->shown)
        fprintf(stderr, "\r%*s\r", PROGRESS_WIDTH + 24, "");
    progress->shown = false;
}

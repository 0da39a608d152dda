/* SPDX-License-Identifier: MIT */
/*
 * The calls that a program makes of what is not its own, counted, of which chosen ones fail: the k-th, or the k-th and
 * the l-th, or all from the k-th on. Every model of a machine and every wrapped library asks seam_fails() once a call.
 */
#ifndef SEAM_H
#define SEAM_H

#include <errno.h>
#include <stdbool.h>

struct seam {
    int calls;             /* so far, by all threads and processes that share this */
    int fails_at, then_at; /* numbers of calls, from 1; 0: none */
    int fails_on;          /* 1: so do all after fails_at */
    int reason;            /* what errno says then */
};

/* Whether this call fails; errno says why. */
static inline bool seam_fails(struct seam *seam)
{
    int call = __atomic_add_fetch(&seam->calls, 1, __ATOMIC_SEQ_CST);
    if (!seam->fails_at ||
        (call != seam->fails_at && call != seam->then_at && !(seam->fails_on && call > seam->fails_at)))
        return false;
    errno = seam->reason;
    return true;
}

#endif

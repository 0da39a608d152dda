/* SPDX-License-Identifier: MIT */
/* Pairs of calls that fail, as many as there is time for, spread evenly over all of them. */
#ifndef PAIRS_H
#define PAIRS_H

#include "tests/faults/seam.h"

#include <stdlib.h>

struct pairs {
    unsigned long calls, all, step, at; /* at: the next of all pairs, (1, 2) (1, 3) ... (2, 3) ... */
    unsigned long first, before;        /* pairs whose first call is less than `first` */
    unsigned tried;
};

/* FAULTS_PAIRS, an environment variable, is how many: `make test-faults-pairs` sets it. */
static inline unsigned pairs_most(unsigned usual)
{
    const char *most = getenv("FAULTS_PAIRS");
    return most ? (unsigned)atoi(most) : usual;
}

static inline struct pairs pairs_of(int calls, unsigned most)
{
    const unsigned long count = (unsigned long)calls, all = count * (count - 1) / 2, step = all / most + 1;
    return (struct pairs){.calls = count, .all = all, .step = step, .at = step / 2, .first = 1};
}

/* False after the last. */
static inline bool pairs_next(struct pairs *p, struct seam *seam)
{
    static const int reasons[] = {EIO, ENOMEM, EAGAIN, EBUSY, EINTR};
    if (p->at >= p->all)
        return false;
    for (; p->at >= p->before + p->calls - p->first; p->first++)
        p->before += p->calls - p->first;
    *seam = (struct seam){.fails_at = (int)p->first,
                          .then_at = (int)(p->first + 1 + p->at - p->before),
                          .reason = reasons[p->tried++ % 5]};
    p->at += p->step;
    return true;
}

#endif

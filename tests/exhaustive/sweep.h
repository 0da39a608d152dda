/* SPDX-License-Identifier: MIT */
/* Walks a function's arguments on two threads, and prints the largest and the mean error. */
#ifndef SWEEP_H
#define SWEEP_H

#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>

#define SWEEP_THREADS 2

struct sweep {
    const char *name, *unit;
    double (*error)(uint32_t argument); /* infinite where the result is none of those documented */
    uint64_t first, end, quick;         /* quick: the end in `make test`; 0: too long for it */
    double bound;
};

struct sweep_slice {
    const struct sweep *sweep;
    uint64_t first, end;
    double least, most, sum; /* of the error; sum of its absolute value */
    uint32_t least_at, most_at;
};

static void *sweep_slice_run(void *argument)
{
    struct sweep_slice *slice = argument;
    for (uint64_t i = slice->first; i < slice->end; i += SWEEP_THREADS) {
        double e = slice->sweep->error((uint32_t)i);
        slice->sum += fabs(e);
        if (e < slice->least) {
            slice->least = e;
            slice->least_at = (uint32_t)i;
        }
        if (e > slice->most) {
            slice->most = e;
            slice->most_at = (uint32_t)i;
        }
    }
    return NULL;
}

/* 0 if no error passes the bound, and all arguments below `end` were walked. */
static int sweep_run(const struct sweep *sweep, uint64_t end)
{
    struct sweep_slice slice[SWEEP_THREADS], all = {0};
    pthread_t thread[SWEEP_THREADS];
    for (int i = 0; i < SWEEP_THREADS; i++) {
        slice[i] = (struct sweep_slice){.sweep = sweep, .first = sweep->first + (unsigned)i, .end = end};
        if (pthread_create(&thread[i], NULL, sweep_slice_run, &slice[i])) {
            fputs("sweep: no thread\n", stderr);
            return 1;
        }
    }
    for (int i = 0; i < SWEEP_THREADS; i++) {
        pthread_join(thread[i], NULL);
        all.sum += slice[i].sum;
        if (slice[i].least < all.least) {
            all.least = slice[i].least;
            all.least_at = slice[i].least_at;
        }
        if (slice[i].most > all.most) {
            all.most = slice[i].most;
            all.most_at = slice[i].most_at;
        }
    }
    int bad = end <= sweep->first || !(-all.least <= sweep->bound && all.most <= sweep->bound);
    printf("%s %-22s %10llu arguments: %+.4g at %08x, %+.4g at %08x, mean %.4g %s, bound %.4g\n", bad ? "FAIL" : "ok  ",
           sweep->name, (unsigned long long)(end - sweep->first), all.least, all.least_at, all.most, all.most_at,
           all.sum / (double)(end - sweep->first), sweep->unit, sweep->bound);
    fflush(stdout);
    return bad;
}

#endif

/* SPDX-License-Identifier: MIT */
/*
 * The set-ups in double precision, on the desktop.
 *   bench_real         every one: CSV lines `name,nanoseconds a set-up`, the best of several runs, the loop taken off
 *   bench_real NAME    one, once over all triangles, nothing printed: for callgrind, which looks at bench_run...()
 */
#include "tests/setups/real.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#define TRIANGLES 1024
#define RUNS      1000

static struct real_case triangles[TRIANGLES];
static volatile double sink;

typedef int quadratic_setup(const struct real_case *c, struct real_quadratic *out);
typedef int steps_setup(const struct real_case *c, struct step_variables *out);

void bench_run_quadratics(quadratic_setup *setup);
void bench_run_steps(steps_setup *setup);

__attribute__((noinline)) void bench_run_quadratics(quadratic_setup *setup)
{
    double sum = 0;
    for (int i = 0; i < TRIANGLES; i++) {
        struct real_quadratic q = {0};
        setup(&triangles[i], &q);
        sum += q.a + q.b + q.c + q.d + q.e + q.f;
    }
    sink = sum;
}

__attribute__((noinline)) void bench_run_steps(steps_setup *setup)
{
    double sum = 0;
    for (int i = 0; i < TRIANGLES; i++) {
        struct step_variables v = {0};
        setup(&triangles[i], &v);
        sum += v.right_second;
        for (int k = 0; k < 2; k++)
            sum += v.edge[k].value + v.edge[k].step + v.edge[k].second + v.edge[k].right + v.edge[k].right_step;
    }
    sink = sum;
}

static int quadratic_nothing(const struct real_case *c, struct real_quadratic *out)
{
    out->f = c->x1;
    return 1;
}

static int steps_nothing(const struct real_case *c, struct step_variables *out)
{
    out->right_second = c->x1;
    return 1;
}

/* One of the two kinds; the other is null. The first of a kind does nothing: the loop and the call alone. */
struct entry {
    const char *name;
    quadratic_setup *quadratic;
    steps_setup *steps;
    double best; /* nanoseconds of all triangles */
};
static struct entry entries[2 + REAL_SETUPS + STEP_SETUPS];
static int entry_count;

static void run(const struct entry *e)
{
    if (e->quadratic)
        bench_run_quadratics(e->quadratic);
    else
        bench_run_steps(e->steps);
}

static void time_once(struct entry *e)
{
    struct timespec from, to;
    clock_gettime(CLOCK_MONOTONIC, &from);
    run(e);
    clock_gettime(CLOCK_MONOTONIC, &to);
    double took = (double)(to.tv_sec - from.tv_sec) * 1e9 + (double)(to.tv_nsec - from.tv_nsec);
    e->best = e->best == 0 || took < e->best ? took : e->best;
}

/* In turns, so that a clock that changes or another program is no single one's burden. */
static void time_all(void)
{
    const struct entry *nothing = entries;
    for (int i = 0; i < RUNS; i++)
        for (int k = 0; k < entry_count; k++)
            time_once(&entries[k]);
    for (int k = 0; k < entry_count; k++) {
        if ((entries[k].quadratic == 0) != (nothing->quadratic == 0))
            nothing = &entries[k];
        if (&entries[k] != nothing)
            printf("%s,%.3f\n", entries[k].name, (entries[k].best - nothing->best) / TRIANGLES);
    }
}

int main(int argc, char **argv)
{
    for (int i = 0; i < TRIANGLES; i++) {
        struct setup_case c;
        setup_case_make(&c, (uint32_t)i);
        triangles[i] = real_of(&c);
    }
    entries[entry_count++] = (struct entry){"nothing", quadratic_nothing, 0, 0};
    for (unsigned k = 0; k < REAL_SETUPS; k++)
        entries[entry_count++] = (struct entry){real_setups[k].name, real_setups[k].setup, 0, 0};
    entries[entry_count++] = (struct entry){"steps-nothing", 0, steps_nothing, 0};
    for (unsigned k = 0; k < STEP_SETUPS; k++)
        entries[entry_count++] = (struct entry){step_setups[k].name, 0, step_setups[k].setup, 0};
    if (argc == 1) {
        time_all();
        return fflush(stdout) == 0 ? 0 : 3;
    }
    for (int k = 0; k < entry_count; k++)
        if (strcmp(entries[k].name, argv[1]) == 0) {
            run(&entries[k]);
            return 0;
        }
    fprintf(stderr, "bench_real: no set-up named %s\n", argv[1]);
    return 2;
}

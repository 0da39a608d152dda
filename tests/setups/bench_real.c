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
#define RUNS      400

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

/* One of each kind; the other is null. */
static void run(quadratic_setup *quadratic, steps_setup *steps)
{
    if (quadratic)
        bench_run_quadratics(quadratic);
    else
        bench_run_steps(steps);
}

static double nanoseconds(quadratic_setup *quadratic, steps_setup *steps)
{
    double best = 1e30;
    for (int i = 0; i < RUNS; i++) {
        struct timespec from, to;
        clock_gettime(CLOCK_MONOTONIC, &from);
        run(quadratic, steps);
        clock_gettime(CLOCK_MONOTONIC, &to);
        double took = (double)(to.tv_sec - from.tv_sec) * 1e9 + (double)(to.tv_nsec - from.tv_nsec);
        best = took < best ? took : best;
    }
    return best / TRIANGLES;
}

/* Returns whether it was the one asked for. */
static int bench_one(const char *name, const char *only, quadratic_setup *quadratic, steps_setup *steps)
{
    static double nothing[2];
    if (only) {
        if (strcmp(name, only) != 0)
            return 0;
        run(quadratic, steps);
        return 1;
    }
    double *base = &nothing[quadratic == 0];
    double took = nanoseconds(quadratic, steps);
    if (*base == 0)
        *base = took; /* the first of a kind is the one that does nothing */
    else
        printf("%s,%.3f\n", name, took - *base);
    return 1;
}

int main(int argc, char **argv)
{
    const char *only = argc > 1 ? argv[1] : 0;
    for (int i = 0; i < TRIANGLES; i++) {
        struct setup_case c;
        setup_case_make(&c, (uint32_t)i);
        triangles[i] = real_of(&c);
    }
    int found = bench_one("nothing", only, quadratic_nothing, 0);
    for (unsigned k = 0; k < REAL_SETUPS; k++)
        found |= bench_one(real_setups[k].name, only, real_setups[k].setup, 0);
    found |= bench_one("steps-nothing", only, 0, steps_nothing);
    for (unsigned k = 0; k < STEP_SETUPS; k++)
        found |= bench_one(step_setups[k].name, only, 0, step_setups[k].setup);
    return found && fflush(stdout) == 0 ? 0 : 2;
}

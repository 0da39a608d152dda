/* SPDX-License-Identifier: MIT */
/*
 * Counts the instructions of the set-ups in integers, on a board or on the desktop.
 *   bench         every one of them, over all triangles: CSV lines `name,instructions,triangles`
 *   bench NAME    one of them, nothing printed: for profilers, which look at the call of bench_run()
 */
#include "tests/device/program.h"
#include "tests/setups/setup.h"

#define TRIANGLES 1024u

static struct setup_case triangles[TRIANGLES];

typedef int bench_setup(const struct setup_case *c, struct polynomial *out);

int bench_run(bench_setup *setup, uint32_t *sum);

/* How many had an answer. What they gave is summed up, so that none of it can be left out. */
__attribute__((noinline)) FX_WRAPS int bench_run(bench_setup *setup, uint32_t *sum)
{
    int answers = 0;
    for (unsigned i = 0; i < TRIANGLES; i++) {
        struct polynomial p = {0};
        answers += setup(&triangles[i], &p);
        *sum += p.a + p.b + p.c + p.d + p.e + p.f;
    }
    return answers;
}

/* The loop and the call alone, to be taken off. */
static int bench_nothing(const struct setup_case *c, struct polynomial *out)
{
    out->f = (uint32_t)c->place[0][0];
    return 1;
}

/* What all share: the triangle's place, with its one reciprocal. */
static int bench_place(const struct setup_case *c, struct polynomial *out)
{
    const int16_t *const p[3] = {c->place[0], c->place[1], c->place[2]};
    struct plane plane;
    int found = plane_setup(&plane, p, SETUP_SIZE, SETUP_SIZE);
    plane_setup_quadratic(&plane);
    out->f = (uint32_t)plane.r2;
    return found;
}

/* 1 if it was run, as it is unless `only` names another, and every triangle had an answer. */
static int bench_one(const char *name, bench_setup *setup, const char *only)
{
    uint32_t sum = 0;
    if (only)
        return text_equal(name, only) && bench_run(setup, &sum) == TRIANGLES;
    program_count_start();
    int answers = bench_run(setup, &sum);
    uint32_t instructions = program_count();
    struct line line = {.length = 0};
    line_text(&line, name);
    line_text(&line, ",");
    line_decimal(&line, instructions);
    line_text(&line, ",");
    line_decimal(&line, (uint32_t)answers);
    line_end(&line);
    return answers == TRIANGLES;
}

int program_main(int argc, char **argv)
{
    const char *only = argc > 1 ? argv[1] : 0;
    for (uint32_t i = 0; i < TRIANGLES; i++)
        setup_case_make(&triangles[i], i);
    int done = bench_one("nothing", bench_nothing, only) + bench_one("place", bench_place, only);
    for (unsigned k = 0; k < setup_integer_count; k++)
        done += bench_one(setup_integers[k].name, setup_integers[k].setup, only);
    done += bench_one("renderer", setup_renderer, only);
    if (done == (only ? 1 : (int)setup_integer_count + 3))
        return 0;
    program_write("bench: no such set-up, or a triangle without an answer\n");
    return 1;
}

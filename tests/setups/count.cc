/* SPDX-License-Identifier: MIT */
/*
 * How many additions, multiplications, divisions and roots each set-up takes: the formulas as they stand, run once on
 * numbers that count. This is C++ for its operators alone; it uses nothing of its library.
 *   setup,from normals: additions,multiplications,divisions,roots,of these from six samples: the same four
 */
extern "C" int printf(const char *, ...);

struct tally {
    int add, mul, div, root;
};
static tally now;

struct real {
    double value;
    real() = default;
    real(double v) : value(v) {}
};
static real operator+(real a, real b) { now.add++; return a.value + b.value; }
static real operator-(real a, real b) { now.add++; return a.value - b.value; }
static real operator*(real a, real b) { now.mul++; return a.value * b.value; }
static real operator/(real a, real b) { now.div++; return a.value / b.value; }
static real operator-(real a) { return -a.value; }
static bool operator==(real a, real b) { return a.value == b.value; }
static real real_root(real a) { now.root++; return __builtin_sqrt(a.value); }

#include "formulas.h"
#include "steps.h"

static void print(const tally &t)
{
    printf(",%d,%d,%d,%d", t.add, t.mul, t.div, t.root);
}

int main()
{
    const real_case c = {40, 20, -10, 50, {{0, 0, 1}, {.6, 0, .8}, {0, .6, .8}}, {.8, 0, .6}, -.1, -.18, -.1};
    for (const setup_real &s : real_setups) {
        real_samples samples;
        real_quadratic q;
        now = {};
        s.setup(&c, &q);
        const tally all = now;
        s.sample(&c, &samples);
        now = {};
        s.solve(&c, &samples, &q);
        printf("%s", s.name);
        print(all);
        print(now);
        printf("\n");
    }
    for (const step_setup &s : step_setups) {
        step_variables v;
        now = {};
        s.setup(&c, &v);
        printf("%s", s.name);
        print(now);
        print(now);
        printf("\n");
    }
}

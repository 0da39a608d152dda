/* SPDX-License-Identifier: MIT */
/* Every argument of the fixed-point functions of one number, and fx_power over all exponents, against double precision:
 * prints the largest and the mean error of each and fails where one exceeds its documented bound. */
#include "tests/exhaustive/fixed_truth.h"

#include <pthread.h>
#include <stdio.h>

#define THREADS 2

struct sweep {
    const char *name, *unit;
    double (*error)(uint32_t argument);
    uint64_t first, end;
    double bound;
};

struct slice {
    const struct sweep *sweep;
    uint64_t first;
    double least, most, sum; /* of the error; sum of its absolute value */
    uint32_t least_at, most_at;
};

static double narrow_clz(uint32_t x)
{
    return (double)fx_clz_narrow(x) - (x ? __builtin_clz(x) : 32);
}

/* The argument's bits are scattered over both factors, so that each half takes every value. */
FX_WRAPS static double narrow_mulhi(uint32_t x)
{
    uint32_t a = x * 0x9e3779b1u, b = (x ^ x >> 15) * 0x85ebca77u;
    uint32_t u = (uint32_t)((uint64_t)a * b >> 32);
    int32_t s = (int32_t)((int64_t)(int32_t)a * (int32_t)b >> 32);
    return fx_mulhi_u32_narrow(a, b) == u && fx_mulhi_s32_narrow((int32_t)a, (int32_t)b) == s ? 0 : INFINITY;
}

FX_WRAPS static double narrow_divmod(uint32_t x)
{
    int32_t num = (int32_t)(x * 0x9e3779b1u) >> 1 >> (x >> 8 & 15),
            den = 1 + (int32_t)((x & 0x7ffffu) >> (x >> 20 & 15));
    int32_t q, r, nq, nr;
    if (num == -(1 << 30))
        num = 0;
    fx_divmod_floor(num, den, &q, &r);
    fx_divmod_floor_narrow(num, den, &nq, &nr);
    return q == nq && r == nr && r >= 0 && r < den && (int64_t)q * den + r == num ? 0 : INFINITY;
}

/* The argument: 10 bits of exponent, 20 of s between -1/16 and 17/16. */
static _Thread_local struct fx_power power_table;
static double power_any(uint32_t x)
{
    unsigned n = x >> 20;
    if (n == 0)
        return 0;
    if (power_table.exponent != n)
        fx_power_build(&power_table, n);
    return truth_power(&power_table, (q30_t)((x & 0xfffffu) * 1152u) - (1 << 26));
}

static void *slice_run(void *argument)
{
    struct slice *slice = argument;
    for (uint64_t i = slice->first; i < slice->sweep->end; i += THREADS) {
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

static int sweep_run(const struct sweep *sweep)
{
    struct slice slice[THREADS], all = {0};
    pthread_t thread[THREADS];
    for (int i = 0; i < THREADS; i++) {
        slice[i] = (struct slice){.sweep = sweep, .first = sweep->first + (unsigned)i};
        if (pthread_create(&thread[i], NULL, slice_run, &slice[i])) {
            fputs("exhaustive_fixed: no thread\n", stderr);
            return 1;
        }
    }
    for (int i = 0; i < THREADS; i++) {
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
    int bad = !(-all.least <= sweep->bound && all.most <= sweep->bound);
    printf("%s %-10s %+.4g at %08x, %+.4g at %08x, mean %.4g %s, bound %.4g\n", bad ? "FAIL" : "ok  ", sweep->name,
           all.least, all.least_at, all.most, all.most_at, all.sum / (double)(sweep->end - sweep->first), sweep->unit,
           sweep->bound);
    fflush(stdout);
    return bad;
}

int main(void)
{
    static const struct sweep sweeps[] = {
        {"fx_recip", "of the value", truth_recip, 1ull << 31, 1ull << 32, TRUTH_RECIP_BOUND},
        {"fx_rsqrt", "of the value", truth_rsqrt, 1ull << 30, 1ull << 32, TRUTH_RSQRT_BOUND},
        {"fx_sin", "x 2^-30", truth_sin, 0, 1ull << 32, TRUTH_SIN_BOUND},
        {"fx_power", "x 1/255", power_any, 0, 1ull << 30, TRUTH_POWER_BOUND},
        {"fx_clz", "(narrow)", narrow_clz, 0, 1ull << 32, 0},
        {"fx_mulhi", "(narrow)", narrow_mulhi, 0, 1ull << 32, 0},
        {"fx_divmod", "(narrow)", narrow_divmod, 0, 1ull << 32, 0},
    };
    int bad = 0;
    for (size_t i = 0; i < sizeof sweeps / sizeof *sweeps; i++)
        bad |= sweep_run(&sweeps[i]);
    return bad;
}

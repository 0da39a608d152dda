/* SPDX-License-Identifier: MIT */
/*
 * The bounds of firmware/plan: millions of random triangles against the truth, and the maxima that its table of chords
 * was made of, found anew on a finer grid.
 *   exhaustive_plan [TRIANGLES]    for each of four widths of normals; 3,000,000
 */
#include "../unit/plan_case.h"

#include "plan/curve.h"

#include <stdio.h>
#include <stdlib.h>

static const double widest[] = {20, 45, 90, 170}; /* degrees between normals */

static int triangles(unsigned long count)
{
    static const char *const names[PLAN_RUNGS] = {"dark", "constant", "gouraud", "linear", "six", "duff", "phong"};
    int bad = 0;
    random_seed(11);
    for (size_t w = 0; w < sizeof widest / sizeof *widest; w++) {
        struct plan_case_counts counts = {0};
        plan_case_run(&counts, widest[w], count * 7 / 8, 12, 1);
        plan_case_run(&counts, widest[w], count / 8, 24, 1);
        printf("normals within %g degrees, %lu triangles:", widest[w], count);
        for (int r = 0; r < PLAN_PHONG; r++) {
            printf(" %s %lu beyond of %lu, at most %.2f;", names[r], counts.beyond[r], counts.planned[r],
                   counts.closest[r]);
            bad |= counts.beyond[r] != 0;
        }
        puts("");
        fflush(stdout);
    }
    return bad;
}

/* What six leaves of f = l / |N|, per h1 kB^2 (README.md beside plan.h, f): bends kappa kB of the edges 12, 23, 31,
 * corner values h1 (1, 1 - A kB t, 1 - A kB) or with the middle one at either end. */
static double remainder_of(const double kappa[3], double bend, double fall, int t, const double b[3])
{
    const double value[3] = {1, t ? 1 - fall * bend : 1, 1 - fall * bend};
    double linear = 0, bent = 0, square = 1;
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        linear += value[k] * b[k];
        bent += (value[k] + value[next]) * 2 * (1 / sqrt(1 - kappa[k] * bend) - 1) * b[k] * b[next];
        square -= 4 * kappa[k] * bend * b[k] * b[next];
    }
    return fabs(linear / sqrt(square) - linear - bent) / (bend * bend);
}

#define PARTS 12 /* of the kappas */
#define SIDE  30 /* of the lattice */

/* The largest remainder at one bend and fall A. */
static double largest(double bend, double fall)
{
    double most = 0;
    for (int c = 0; c < (PARTS + 1) * (PARTS + 1) * (PARTS + 1); c++) {
        const double kappa[3] = {c % (PARTS + 1) / (double)PARTS, c / (PARTS + 1) % (PARTS + 1) / (double)PARTS,
                                 c / (PARTS + 1) / (PARTS + 1) / (double)PARTS};
        const double chord[3] = {sqrt(kappa[0]), sqrt(kappa[1]), sqrt(kappa[2])};
        if (fmax(kappa[0], fmax(kappa[1], kappa[2])) < 1 || chord[0] > chord[1] + chord[2] + 1e-9 ||
            chord[1] > chord[2] + chord[0] + 1e-9 || chord[2] > chord[0] + chord[1] + 1e-9)
            continue;
        for (int i = 0; i <= SIDE; i++)
            for (int j = 0; i + j <= SIDE; j++) {
                const double b[3] = {(SIDE - i - j) / (double)SIDE, i / (double)SIDE, j / (double)SIDE};
                for (int t = 0; t < 2; t++)
                    most = fmax(most, remainder_of(kappa, bend, fall, t, b));
            }
    }
    return most;
}

/* Each chord of the table lies above what is found, at its ends and between. */
static int table(void)
{
    static const double falls[] = {0, .5, 1, 1.5, 2, 3, 4, 8, 12, 16};
    int bad = 0;
    double from = 0.001;
    for (int band = 0; band < CURVE_BANDS; band++) {
        const struct curve_band *c = &curve_bands[band];
        const double to = c->most / 65536.;
        printf("bends to %.4f: fall, largest remainder, table:", to);
        for (size_t f = 0; f < sizeof falls / sizeof *falls; f++) {
            double most = 0, chords = 0;
            for (int step = 0; step <= 3; step++)
                most = fmax(most, largest(from + (to - from) * step / 3, falls[f]));
            for (int l = 0; l < 4; l++)
                chords = fmax(chords, (c->line[l].alpha + c->line[l].beta * falls[f]) / 65536);
            printf(" %g %.4f %.4f%s", falls[f], most, chords, most > chords ? " FAIL" : ";");
            bad |= most > chords;
        }
        puts("");
        fflush(stdout);
        from = to;
    }
    return bad;
}

int main(int argc, char **argv)
{
    const unsigned long count = argc > 1 ? strtoul(argv[1], NULL, 10) : 3000000;
    const int bad = table();
    return triangles(count) | bad;
}

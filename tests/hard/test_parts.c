/* SPDX-License-Identifier: MIT */
/* Polynomials over parts of triangles and quotients by W where numbers are largest, against double precision. */
#include "shade/part.h"
#include "shade/perspective.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "tests/unit/random.h"

#define SIDE 2048

/* A triangle in the guard band, its corners clockwise with y down, of up to 2^15 sub-pixels: half of them reach from
 * one end to the other less nothing, one or two sub-pixels. */
static void widest_triangle(int16_t place[3][3])
{
    int64_t turn;
    do {
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 2; i++) {
                const int end = random_between(0, 3);
                place[k][i] = (int16_t)(end == 0   ? -16384 + random_between(0, 2)
                                        : end == 1 ? 16384 - random_between(0, 2)
                                                   : random_between(-16384, 16384));
            }
        turn = (int64_t)(place[1][0] - place[0][0]) * (place[2][1] - place[0][1]) -
               (int64_t)(place[2][0] - place[0][0]) * (place[1][1] - place[0][1]);
    } while (turn < 1 << 24);
}

/* A part after `depth` halvings, as subdivision makes them. */
static void random_part(struct part_corner corner[3], int depth)
{
    double w[3][2] = {{1, 0}, {0, 1}, {0, 0}};
    for (; depth; depth--) {
        const int at = random_between(0, 3);
        double m[3][2], part[3][2];
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 2; i++)
                m[k][i] = (w[k][i] + w[(k + 1) % 3][i]) / 2;
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 2; i++)
                part[k][i] = at == 3 ? m[k][i] : (w[at][i] + w[k][i]) / 2;
        memcpy(w, part, sizeof w);
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
            corner[k].weight[i] = (uint16_t)(w[k][i] * PART_ONE);
}

/* Pixels of a part whose values, Q30, are compared; returns the largest difference. */
static double compare(const struct shade_setup *setup, const struct channel *channel, const double p[3][2],
                      const int32_t value[3], const int32_t bulge[3], long *pixels)
{
    double worst = 0;
    const double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
    for (int i = 0; i < 40; i++) {
        double l[3], sum = 0, at[2] = {0, 0}, wanted = 0;
        for (int k = 0; k < 3; k++)
            sum += l[k] = -log(random_fraction());
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 2; j++)
                at[j] += l[k] / sum * p[k][j];
        const int x = (int)floor(at[0]), y = (int)floor(at[1]);
        if (x < 0 || y < 0 || x >= SIDE || y >= SIDE)
            continue;
        for (int k = 0; k < 3; k++) {
            const double *a = p[(k + 1) % 3], *b = p[(k + 2) % 3], c[2] = {x + .5, y + .5};
            l[k] = ((a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])) / area;
        }
        if (l[0] < 0 || l[1] < 0 || l[2] < 0)
            continue;
        for (int k = 0; k < 3; k++)
            wanted += value[k] * 65536. * l[k] - bulge[k] * 4. * l[k] * l[(k + 1) % 3];
        int32_t got;
        plane_values(&setup->plane, channel, x, y, 1, &got);
        worst = fmax(worst, fabs(got - wanted));
        ++*pixels;
    }
    return worst;
}

/* What textures (split) and finished colours (subdivide-centre) are made of. */
static void a_part_of_the_widest_triangle_bends_as_it_should(void **state)
{
    double worst = 0;
    long pixels = 0, ends = 0;
    (void)state;
    random_seed(1);
    for (int i = 0; i < 60000; i++) {
        int16_t place[3][3] = {{0}};
        struct part_corner corner[3];
        struct shade_setup setup;
        struct channel channel;
        struct shade_input in = {.place = {place[0], place[1], place[2]}};
        int32_t value[3], bulge[3];
        double p[3][2];
        widest_triangle(place);
        random_part(corner, random_between(0, 4));
        assert_int_equal(plane_setup(&setup.plane, in.place, SIDE, SIDE), 1);
        for (int k = 0; k < 3; k++) {
            value[k] = random_between(-8190, 8190);
            bulge[k] = random_between(-(1 << 27), 1 << 27);
            const double w[3] = {corner[k].weight[0] / 32768., corner[k].weight[1] / 32768.,
                                 1 - corner[k].weight[0] / 32768. - corner[k].weight[1] / 32768.};
            for (int j = 0; j < 2; j++)
                p[k][j] = (w[0] * place[0][j] + w[1] * place[1][j] + w[2] * place[2][j]) / 16 + SIDE / 2;
        }
        const struct part_corner *const corners[3] = {&corner[0], &corner[1], &corner[2]};
        if (!part_channel(&setup, &in, corners, value, bulge, 0, &channel))
            continue;
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 2; j++)
                ends += place[(k + 1) % 3][j] - place[k][j] == -32767;
        worst = fmax(worst, compare(&setup, &channel, (const double(*)[2])p, value, bulge, &pixels));
    }
    print_message("%ld pixels, %ld edges of -32767 sub-pixels: off by at most %.5f\n", pixels, ends, worst * 0x1p-30);
    assert_true(pixels > 100000 && ends > 1000);
    /* second differences are rounded to 2^-31, times 3 * 2048^2; scaled corners by 2^-14, more where they are thin */
    assert_true(worst < 0x1p-6 * 0x1p30);
}

/* 1 / W and its square for every depth and how far closeness was moved up: as long as W is at least 2^-16 of the
 * nearest corner's they are right, below it what the least gives. */
static void a_quotient_by_any_depth_is_right_or_held(void **state)
{
    double once = 0, twice = 0;
    (void)state;
    for (unsigned up = 0; up < 16; up++)
        for (uint32_t depth = 0; depth < (uint32_t)DEPTH_NEAR << 16; depth += depth < 1u << 22 ? 509 : 77773) {
            const struct perspective_divisor by = perspective_divisor(depth, up);
            assert_true(by.up <= 15);
            assert_true(by.half >= 1 << 30);
            double w = (depth - 524288.) * 0x1p-32 * (1 << up); /* DEPTH_FAR is no closeness */
            const double least = fmax(0x1p-16, 0x1p-20 * (1 << up));
            w = w > least ? w : least;
            if (w > 1)
                continue;
            for (int32_t v = -(1 << 30); v <= 1 << 30; v += 1 << 29) {
                once = fmax(once, fabs(perspective_divide((int32_t)lrint(v * w), by) - (double)v) * w);
                twice = fmax(twice, fabs(perspective_divide_twice((int32_t)lrint(v * w * w), by) - (double)v) * w * w);
            }
        }
    /* half a unit of the numerator, and the product's lowest bits */
    print_message("off by at most %.2f units of P, %.2f of Q\n", once, twice);
    assert_true(once < 8 && twice < 16);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_part_of_the_widest_triangle_bends_as_it_should),
        cmocka_unit_test(a_quotient_by_any_depth_is_right_or_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Values where they are hard: slivers, long spans, an origin off the picture, the largest extent, depths far apart. */
#include "tests/unit/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

#include "exact_bounds.h"
#include "geometry/transform.h"
#include "spans_case.h"

#define UNIT 0x1p22 /* a display unit: 1/256 of full intensity, in Q30 */

static struct plane plane;
static struct channel channel;
static struct exact_quantity quantity;

static void random_quantity(int extreme, int quadratic)
{
    quantity.unit = 65536;
    for (int k = 0; k < 3; k++) {
        quantity.value[k] = extreme ? random_between(0, 1) * 32768 - 16384 : random_between(-16384, 16384);
        quantity.bulge[k] = !quadratic ? 0
                            : extreme  ? random_between(0, 1) * (1 << 29) - (1 << 28)
                                       : random_between(-(1 << 28), 1 << 28);
    }
}

static void set_up(const struct exact_triangle *t, int quadratic)
{
    assert_int_equal(plane_setup(&plane, spans_places(t, 0, 1), t->width, t->height), 1);
    plane_setup_quadratic(&plane);
    if (quadratic)
        plane_quadratic(&plane, quantity.value, quantity.bulge, &channel);
    else
        plane_linear(&plane, quantity.value, &channel);
}

/* How far the channel is off at a pixel, in units of its last place. */
static double off_at(const struct exact_triangle *t, int x, int y)
{
    int32_t got;
    plane_values(&plane, &channel, x, y, 1, &got);
    return exact_off((uint32_t)got, exact_value(t, &quantity, x, y), (exact_t)exact_area(t) * exact_area(t));
}

/* Thin ones whose weights change by more than 1 from a pixel to the next: no polynomial, and no overshoot either, as
 * weights are kept to the triangle. */
static void slivers_steeper_than_one_a_pixel_stay_between_their_corners(void **state)
{
    (void)state;
    long pixels = 0, steep = 0;
    double most = 0;
    random_seed(11);
    while (steep < 3000) {
        struct exact_triangle t = {.width = 64, .height = 64};
        const double angle = random_real(0, 2 * 3.14159265358979), length = random_magnitude(16, 10000);
        for (int k = 0; k < 3; k++) {
            const double along = k == 2 ? random_real(-1, 1) : k ? 1 : -1;
            t.p[k] = (struct cover_point){(int)lrint(along * length * cos(angle)) + random_between(-2, 2),
                                          (int)lrint(along * length * sin(angle)) + random_between(-2, 2)};
        }
        if (!spans_clockwise(&t))
            continue;
        /* a weight's gradient, by a pixel */
        const double gradient = 16. * fmax(abs(t.p[1].y - t.p[2].y), abs(t.p[1].x - t.p[2].x)) / (double)exact_area(&t);
        random_quantity((int)(steep & 1), 0);
        set_up(&t, 0);
        if (gradient <= 1 || !plane.sliver)
            continue;
        int low = INT32_MAX, high = INT32_MIN;
        for (int k = 0; k < 3; k++) {
            low = quantity.value[k] < low ? quantity.value[k] : low;
            high = quantity.value[k] > high ? quantity.value[k] : high;
        }
        steep++;
        for (int y = 0; y < 64; y++)
            for (int x = 0; x < 64; x++) {
                int32_t got;
                if (!exact_covers(&t, x, y))
                    continue;
                plane_values(&plane, &channel, x, y, 1, &got);
                const double off = fabs(off_at(&t, x, y));
                if (got < low * 65536 || got > high * 65536 || off > exact_corner_bound(&quantity, 0))
                    spans_complain(&t, x, y, "is off");
                most = fmax(most, off / UNIT);
                pixels++;
            }
    }
    print_message("%ld slivers, %ld pixels, at most %.4f of a display unit off\n", steep, pixels, most);
    assert_true(pixels > 1000);
}

/* Large triangles over a picture: FORMULAS' bound, with half a unit for the second differences and what a gradient errs
 * by for the first, and 1/128 of a display unit for corner values rounded to Q14. */
static void long_spans(unsigned width, unsigned height, int triangles, const char *name)
{
    double most = 0, nearest = 0, bound_most = 0;
    for (int i = 0; i < triangles;) {
        struct exact_triangle t = {.width = width, .height = height};
        const int w = 8 * (int)width, h = 8 * (int)height, corner = (int)(random_bits() & 3);
        /* a corner beside one of the picture's, the others as far the other way or farther */
        const int sx = corner & 1 ? 1 : -1, sy = corner & 2 ? 1 : -1;
        t.p[0] = (struct cover_point){sx * (w - random_between(0, 64)), sy * (h - random_between(0, 64))};
        t.p[1] = (struct cover_point){-sx * random_between(w, 2 * w < GUARD ? 2 * w : GUARD), t.p[0].y};
        t.p[2] = (struct cover_point){t.p[0].x, -sy * random_between(h, 2 * h < GUARD ? 2 * h : GUARD)};
        for (int k = 1; k < 3; k++) {
            t.p[k].x += random_between(-100, 100);
            t.p[k].y += random_between(-100, 100);
            t.p[k].x = t.p[k].x > GUARD ? GUARD : t.p[k].x < -GUARD ? -GUARD : t.p[k].x;
            t.p[k].y = t.p[k].y > GUARD ? GUARD : t.p[k].y < -GUARD ? -GUARD : t.p[k].y;
        }
        if (!spans_clockwise(&t))
            continue;
        random_quantity(i & 1, 1);
        set_up(&t, 1);
        assert_false(channel.exact);
        const struct exact_polynomial p = exact_polynomial(&t, &quantity, plane.ox, plane.oy);
        const struct exact_bounds by =
            plane.thin || plane.far ? exact_wide_bounds(&t, &p) : exact_quadratic_bounds(&t, &p);
        const double rounded = plane.far || plane.thin ? 0 : UNIT / 128;
        for (int n = 0; n < 400; n++) {
            const int y = n & 1   ? random_between(0, (int)height - 1)
                          : n & 2 ? 0
                                  : (int)height - 1,
                      x = n & 4   ? random_between(0, (int)width - 1)
                          : n & 8 ? 0
                                  : (int)width - 1;
            if (!exact_covers(&t, x, y))
                continue;
            const double X = abs(x - plane.ox), Y = abs(y - plane.oy), off = fabs(off_at(&t, x, y));
            const double sum = by.f + by.d * X + by.e * Y + by.a * X * X + by.b * Y * Y + by.c * X * Y;
            const double formula = .51 * (X * X + Y * Y + X * Y) + 16 * (X + Y + 1) + rounded;
            if (off > sum || off > formula)
                spans_complain(&t, x, y, "is off");
            most = fmax(most, off / UNIT);
            bound_most = fmax(bound_most, formula / UNIT);
            nearest = fmax(nearest, off / formula);
        }
        i++;
    }
    print_message("%s: at most %.4f of a display unit off, where the bound is %.4f; at most %.2f of a pixel's own\n",
                  name, most, bound_most, nearest);
    assert_true(nearest > .1);
}

static void spans_of_320_pixels_are_within_the_error_bound(void **state)
{
    (void)state;
    random_seed(12);
    long_spans(320, 240, 10000, "320 x 240");
}

static void spans_of_1280_pixels_are_within_the_error_bound(void **state)
{
    (void)state;
    random_seed(13);
    long_spans(1280, 1024, 10000, "1280 x 1024");
}

/* Corner 0 up to 1000 pixels outside: the origin is the nearest pixel inside, and nothing is lost. */
static void an_origin_off_the_picture_costs_no_accuracy(void **state)
{
    (void)state;
    double most[2] = {0, 0};
    long pixels = 0;
    random_seed(14);
    for (int i = 0; i < 20000;) {
        struct exact_triangle t = {.width = 320, .height = 240};
        for (int k = 0; k < 3; k++)
            t.p[k] = (struct cover_point){random_between(-GUARD, GUARD), random_between(-GUARD, GUARD)};
        if (!spans_clockwise(&t) || (abs(t.p[0].x) < 2560 + 160 && abs(t.p[0].y) < 1920 + 160))
            continue;
        const struct exact_origin o = exact_origin(&t);
        for (int quadratic = 0; quadratic < 2; quadratic++) {
            random_quantity(i & 1, quadratic);
            set_up(&t, quadratic);
            assert_true(plane.ox == o.x && plane.oy == o.y && plane.fx == o.from_x && plane.fy == o.from_y);
            assert_true(o.x >= 0 && o.x < 320 && o.y >= 0 && o.y < 240 && plane.far);
            for (int n = 0; n < 12 && !channel.exact; n++) {
                const int x = random_between(0, 319), y = random_between(0, 239);
                if (!exact_covers(&t, x, y))
                    continue;
                most[quadratic] = fmax(most[quadratic], fabs(off_at(&t, x, y)) / UNIT);
                pixels++;
            }
        }
        i++;
    }
    print_message("%ld pixels, at most %.4f (linear) and %.4f (quadratic) of a display unit off\n", pixels, most[0],
                  most[1]);
    assert_true(most[0] <= 1. / 64 + 1. / 64); /* corner values are rounded to half of 2 units of Q14 */
    assert_true(most[1] <= .5 * (320 * 320 + 240 * 240 + 320 * 240 + 320 + 240 + 1) / UNIT + 1. / 1000);
}

/* Corner depths as far apart as they can be, over all sizes to 2048 pixels: what is drawn stays in 16 bits. */
static void a_depth_from_the_near_to_the_far_plane_stays_in_16_bits(void **state)
{
    static const int32_t edge[] = {-GUARD - 1, -GUARD, GUARD, GUARD + 1};
    (void)state;
    long pixels = 0, low = 65535, high = 0;
    random_seed(15);
    for (int i = 0; i < 40000;) {
        struct exact_triangle t = {.width = 16, .height = 16};
        const int reach = 128 << random_bits() % 8 >> random_bits() % 3;
        for (int k = 0; k < 3; k++) {
            t.p[k] = (struct cover_point){random_between(-reach, reach), random_between(-reach, reach)};
            if (i % 3 == 0)
                t.p[k] = (struct cover_point){edge[random_bits() % 4], random_between(-reach, reach)};
            quantity.value[k] = random_bits() & 1 ? DEPTH_FAR : DEPTH_NEAR;
            quantity.bulge[k] = 0;
        }
        t.p[random_bits() % 3] = cover_centre(random_between(0, 15), random_between(0, 15), 16, 16);
        if (!spans_clockwise(&t))
            continue;
        quantity.unit = 65536;
        set_up(&t, 0);
        for (int y = 0; y < 16; y++)
            for (int x = 0; x < 16; x++) {
                int32_t got;
                if (!exact_covers(&t, x, y))
                    continue;
                plane_values(&plane, &channel, x, y, 1, &got);
                const long depth = (uint32_t)got >> 16;
                low = depth < low ? depth : low;
                high = depth > high ? depth : high;
                assert_true(fabs(off_at(&t, x, y)) < 4 * 65536);
                pixels++;
            }
        i++;
    }
    print_message("%ld pixels, depths %ld to %ld\n", pixels, low, high);
    assert_true(low >= DEPTH_FAR - 4 && high <= DEPTH_NEAR + 4 && pixels > 100000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slivers_steeper_than_one_a_pixel_stay_between_their_corners),
        cmocka_unit_test(spans_of_320_pixels_are_within_the_error_bound),
        cmocka_unit_test(spans_of_1280_pixels_are_within_the_error_bound),
        cmocka_unit_test(an_origin_off_the_picture_costs_no_accuracy),
        cmocka_unit_test(a_depth_from_the_near_to_the_far_plane_stays_in_16_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

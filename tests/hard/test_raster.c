/* SPDX-License-Identifier: MIT */
/* Coverage where it is hard: tiny, flat, thin and enormous triangles, meshes, and corners on the edges of others. */
#include "tests/unit/random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

#include "exact_rational.h"
#include "geometry/transform.h"
#include "raster/fine.h"
#include "spans_case.h"

static void a_triangle_without_area_is_refused_in_every_order(void **state)
{
    (void)state;
    long tried = 0;
    random_seed(1);
    for (int i = 0; i < 100000; i++) { /* on a line, at its ends, in a point */
        const int dx = random_between(-9, 9), dy = random_between(-9, 9), reach = i % 3 ? 100 : 1800;
        struct exact_triangle t = {.width = 9, .height = 7};
        struct plane plane;
        for (int k = 0; k < 3; k++) {
            const int at = random_between(-reach, reach);
            t.p[k] = (struct cover_point){at * dx, at * dy};
        }
        assert_int_equal(exact_area(&t), 0);
        for (int first = 0; first < 3; first++) {
            assert_int_equal(plane_setup(&plane, spans_places(&t, first, 1), t.width, t.height), 0);
            assert_int_equal(plane_setup(&plane, spans_places(&t, first, -1), t.width, t.height), 0);
        }
        tried++;
    }
    print_message("%ld, none drawn\n", tried);
}

/* All of them with a corner within 9 sub-pixels of a centre: at most the centre itself. */
static void a_sub_pixel_squared_covers_what_it_should(void **state)
{
    (void)state;
    long covered = 0, all = 0;
    for (int ax = -9; ax <= 9; ax++)
        for (int ay = -9; ay <= 9; ay++)
            for (int b = 0; b < 19 * 19; b++)
                for (int c = 0; c < 9; c++) {
                    /* the third corner: the parallel at distance 1 has a point in each step of the side */
                    struct exact_triangle t = {.width = 3, .height = 3};
                    t.p[0] = (struct cover_point){ax, ay};
                    t.p[1] = (struct cover_point){b % 19 - 9, b / 19 - 9};
                    t.p[2] = (struct cover_point){ax + c % 3 - 1, ay + c / 3 - 1};
                    if (llabs(exact_area(&t)) != 1 || !spans_clockwise(&t))
                        continue;
                    const int pixels = spans_check(&t);
                    assert_true(pixels <= 1);
                    covered += pixels;
                    all++;
                }
    print_message("%ld triangles of 1 sub-pixel^2 about a pixel's centre, %ld cover it\n", all, covered);
    assert_true(all > 5000 && covered > 100);
}

/* Every triangle on the lattice of pixel centres and corners of 3 x 3 pixels. */
static void flat_tops_and_bottoms_and_middles_on_either_side(void **state)
{
    long seen[4] = {0, 0, 0, 0}; /* flat top, flat bottom, middle left, middle right */
    (void)state;
    for (int i = 0; i < 7 * 7 * 7 * 7 * 7 * 7; i++) {
        struct exact_triangle t = {.width = 3, .height = 3};
        int at = i;
        for (int k = 0; k < 3; k++) {
            t.p[k] = (struct cover_point){at % 7 * 8 - 24, at / 7 % 7 * 8 - 24};
            at /= 49;
        }
        if (exact_area(&t) <= 0)
            continue;
        spans_check(&t);
        int top = 0, bottom = 0;
        for (int k = 1; k < 3; k++) {
            top = t.p[k].y < t.p[top].y ? k : top;
            bottom = t.p[k].y >= t.p[bottom].y ? k : bottom;
        }
        const int middle = 3 - top - bottom;
        if (t.p[middle].y == t.p[top].y)
            seen[0]++;
        else if (t.p[middle].y == t.p[bottom].y)
            seen[1]++;
        else
            seen[2 + ((middle - top + 3) % 3 == 1)]++; /* clockwise after the top: on the right */
    }
    print_message("%ld flat tops, %ld flat bottoms, %ld middles on the left, %ld on the right\n", seen[0], seen[1],
                  seen[2], seen[3]);
    for (int i = 0; i < 4; i++)
        assert_true(seen[i] > 5000);
}

/* As large as can be: the guard band and the sub-pixel that a cut may be rounded out by, 2048 pixels across. */
static void an_extent_of_2048_pixels_covers_what_it_should(void **state)
{
    static const int32_t edge[] = {-GUARD - 1, -GUARD, GUARD, GUARD + 1, 0};
    static uint8_t count[2048 * 64];
    (void)state;
    long extents = 0;
    random_seed(2);
    for (int i = 0; i < 3000;) {
        struct exact_triangle t = {.width = (unsigned)random_between(1, 48), .height = (unsigned)random_between(1, 48)};
        for (int k = 0; k < 3; k++)
            t.p[k] = (struct cover_point){
                random_bits() % 4 ? edge[random_bits() % 5] : random_between(-GUARD - 1, GUARD + 1),
                random_bits() % 4 ? edge[random_bits() % 5] : random_between(-GUARD - 1, GUARD + 1)};
        if (!spans_clockwise(&t))
            continue;
        spans_check(&t);
        for (int k = 0; k < 3; k++)
            extents += abs(t.p[k].x - t.p[(k + 1) % 3].x) == 1 << 15 || abs(t.p[k].y - t.p[(k + 1) % 3].y) == 1 << 15;
        if (i % 100 == 0) { /* the widest and the highest pictures */
            const unsigned across = i % 200 ? 2048 : 1, high = i % 200 ? 1 : 2048;
            t.width = across;
            t.height = high;
            memset(count, 0, (size_t)across * high);
            spans_count(&t, i % 3, count);
            for (int p = 0; p < 2048; p++)
                if (count[p] != exact_covers(&t, i % 200 ? p : 0, i % 200 ? 0 : p))
                    spans_complain(&t, p, 0, "along the picture");
        }
        i++;
    }
    assert_true(extents > 500);
}

/* A jittered grid over all of the picture and beyond it, each cell by one diagonal or the other. */
static void a_mesh_covers_every_pixel_exactly_once(void **state)
{
    enum { CELLS = 24, CORNERS = CELLS + 1 };
    static uint8_t count[200 * 200];
    static struct cover_point grid[CORNERS][CORNERS];
    (void)state;
    long triangles = 0;
    random_seed(3);
    for (int mesh = 0; mesh < 120; mesh++) {
        struct exact_triangle t = {.width = 200, .height = 200};
        const int step = mesh % 3 ? 1 : 8; /* every third on pixel centres and corners */
        memset(count, 0, sizeof count);
        for (int j = 0; j < CORNERS; j++)
            for (int i = 0; i < CORNERS; i++)
                grid[j][i] = (struct cover_point){(2 * i - CELLS) * 72 + random_between(-40, 40) / step *
                                                                             step, /* 9 pixels, and up to 2.5 */
                                                  (2 * j - CELLS) * 72 + random_between(-40, 40) / step * step};
        for (int j = 0; j < CELLS; j++)
            for (int i = 0; i < CELLS; i++) {
                const struct cover_point c[4] = {grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]};
                const unsigned turn = random_bits() & 1;
                for (unsigned half = 0; half < 2; half++) {
                    for (unsigned k = 0; k < 3; k++)
                        t.p[k] = c[(turn + 2 * half + k) % 4];
                    assert_true(exact_area(&t) > 0);
                    spans_count(&t, (int)(random_bits() % 3), count);
                    triangles++;
                }
            }
        for (int p = 0; p < 200 * 200; p++)
            if (count[p] != 1)
                spans_complain(&t, p % 200, p / 200, count[p] ? "is drawn twice" : "is left out");
    }
    print_message("%ld triangles, 4800000 pixels, each drawn once\n", triangles);
}

/*
 * A corner rounded to near an edge that has none there: of the promises, "never twice" and "no gap" hold for edges that
 * two triangles share, and a T is none. What is left open, or drawn twice, is exactly what the triangle between them
 * covers: lower than a sub-pixel, so at most a pixel of each column (row, where it is steep).
 */
static void a_t_junction_misses_or_doubles_what_lies_between_and_no_more(void **state)
{
    static uint8_t count[64 * 64];
    (void)state;
    long missed = 0, doubled = 0, exact = 0;
    random_seed(4);
    for (int i = 0; i < 40000; i++) {
        const struct cover_point a = {random_between(-640, 0), random_between(-640, 640)},
                                 b = {random_between(0, 640), random_between(-640, 640)};
        const int dx = b.x - a.x, dy = b.y - a.y, weight = random_between(1, 63);
        if (dx < 64)
            continue;
        const struct cover_point joint = {a.x + (dx * weight + 32) / 64, a.y + (int)lrint(dy * weight / 64.)};
        const struct cover_point below = {(a.x + b.x) / 2, 1400}, above = {(a.x + b.x) / 2, -1400};
        const struct exact_triangle part[4] = {{{a, b, below}, 64, 64},
                                               {{a, above, joint}, 64, 64},
                                               {{joint, above, b}, 64, 64},
                                               {{a, above, b}, 64, 64}}; /* the last two without the T */
        int across[64] = {0};
        const int64_t side = cover_turn(a, b, joint);
        struct exact_triangle between = {{a, joint, b}, 64, 64};
        spans_clockwise(&between);
        memset(count, 0, sizeof count);
        for (int k = 0; k < 3; k++)
            spans_count(&part[k], i % 3, count);
        exact += side == 0;
        for (int y = 0; y < 64; y++)
            for (int x = 0; x < 64; x++) {
                const int whole = exact_covers(&part[0], x, y) + exact_covers(&part[3], x, y),
                          off = count[64 * y + x] - whole, lies = side && exact_covers(&between, x, y);
                if (off != (lies ? side > 0 ? 1 : -1 : 0))
                    spans_complain(&between, x, y, "is not what lies between");
                if (lies && ++across[abs(dx) > abs(dy) ? x : y] > 1)
                    spans_complain(&between, x, y, "is a second of its column");
                missed += off < 0;
                doubled += off > 0;
            }
    }
    print_message("%ld pixels missed, %ld drawn twice; %ld joints exactly on the edge: none\n", missed, doubled, exact);
    assert_true(missed > 100 && doubled > 100 && exact > 200);
}

/* A part's pixels by definition: edge functions of corners in 2^-15 sub-pixels, below 2^62. */
static int covers_fine(const struct part_place p[3], int x, int y, unsigned width, unsigned height)
{
    const struct cover_point c = cover_centre(x, y, width, height);
    for (int k = 0; k < 3; k++) {
        const struct part_place a = p[k], b = p[(k + 1) % 3];
        const exact_t side =
            ((exact_t)b.x - a.x) * ((exact_t)c.y * 32768 - a.y) - ((exact_t)c.x * 32768 - a.x) * ((exact_t)b.y - a.y);
        if (side < 0 || (side == 0 && !(b.y < a.y || (b.y == a.y && b.x > a.x))))
            return 0;
    }
    return 1;
}

static void count_fine(const struct part_place p[3], unsigned size, uint8_t *count)
{
    struct edges e;
    for (int from = 0; fine_setup(&e, p, size, size, from, (int)size); from = e.last)
        spans_add(&e, size, count);
}

/* Parts have their corners at weighted means of the triangle's, so that a T-junction with a part is exact: beside a
 * neighbour that is not split, no pixel is missed and none drawn twice. */
static void parts_meet_each_other_and_whole_neighbours(void **state)
{
    enum { SIZE = 32 };
    static uint8_t count[SIZE * SIZE];
    (void)state;
    long parts = 0, pixels = 0;
    random_seed(5);
    while (parts < 60000) {
        struct cover_point c[4];
        const int reach = parts % 5 ? 300 : 16000;
        for (int k = 0; k < 4; k++)
            c[k] = (struct cover_point){random_between(-reach, reach), random_between(-reach, reach)};
        const struct exact_triangle whole = {{c[0], c[1], c[2]}, SIZE, SIZE}, next = {{c[0], c[3], c[1]}, SIZE, SIZE};
        if (exact_area(&whole) <= 0 || exact_area(&next) <= 0)
            continue;
        const int w = random_between(0, 32768); /* a corner on the shared edge, and one inside */
        const struct part_place q[3] = {
            {c[0].x * 32768, c[0].y * 32768}, {c[1].x * 32768, c[1].y * 32768}, {c[2].x * 32768, c[2].y * 32768}};
        const struct part_place on = {c[0].x * (32768 - w) + c[1].x * w, c[0].y * (32768 - w) + c[1].y * w};
        const struct part_place part[2][3] = {{q[0], on, q[2]}, {on, q[1], q[2]}};
        memset(count, 0, sizeof count);
        spans_count(&next, (int)parts % 3, count);
        for (int i = 0; i < 2; i++)
            if (w > 0 && w < 32768)
                count_fine(part[i], SIZE, count);
        if (w == 0 || w == 32768)
            count_fine(part[w == 0], SIZE, count);
        for (int y = 0; y < SIZE; y++)
            for (int x = 0; x < SIZE; x++) {
                const int wanted = exact_covers(&whole, x, y) + exact_covers(&next, x, y);
                if (count[SIZE * y + x] != wanted)
                    spans_complain(&whole, x, y, "of its parts and its neighbour");
                assert_int_equal(exact_covers(&whole, x, y), covers_fine(q, x, y, SIZE, SIZE));
                pixels += wanted;
            }
        parts += 2;
    }
    print_message("%ld parts, %ld pixels\n", parts, pixels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_triangle_without_area_is_refused_in_every_order),
        cmocka_unit_test(a_sub_pixel_squared_covers_what_it_should),
        cmocka_unit_test(flat_tops_and_bottoms_and_middles_on_either_side),
        cmocka_unit_test(an_extent_of_2048_pixels_covers_what_it_should),
        cmocka_unit_test(a_mesh_covers_every_pixel_exactly_once),
        cmocka_unit_test(a_t_junction_misses_or_doubles_what_lies_between_and_no_more),
        cmocka_unit_test(parts_meet_each_other_and_whole_neighbours),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Polynomials over triangles against Phi = sum Ii li - sum aij li lj in double precision, at covered pixels. */
#include "cover.h"
#include "random.h"
#include "raster/edges.h"
#include "shade/dots.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>

/* What a channel may err by, in display units, of which an intensity of 1 has 256. Q14 corner values have 1/64. */
#define LINEAR_ERROR    (1 / 40.)
#define QUADRATIC_ERROR (2 / 5.)  /* across 1024 pixels, normals half a turn apart */
#define WIDE_ERROR      (3 / 4.)  /* beyond 1024, where half a unit of the last place shows over the distance squared */
#define EXACT_ERROR     (1 / 32.) /* thin and tiny triangles: barycentric at each pixel */
#define UNIT            0x1p22

#define SIZE 2048 /* of the picture, so that nothing within the guard band is off it */

static struct cover_point corner[3];
static int32_t value[3], bulge[3];

static struct cover_point random_point(int reach)
{
    return (struct cover_point){random_between(-reach, reach), random_between(-reach, reach)};
}

static int32_t within(int32_t v, int32_t reach)
{
    return v < -reach ? -reach : v > reach ? reach : v;
}

enum shape { ANY, SLIVER, LOW, NARROW, SHAPES };

/* Clockwise, within `reach` sub-pixels of the middle; all but ANY no more than about `height` across. */
static void random_triangle(enum shape shape, int reach, int height)
{
    do {
        for (int k = 0; k < 3; k++)
            corner[k] = random_point(reach);
        if (shape == ANY)
            continue;
        if (shape == LOW)
            corner[1].y = within(corner[0].y + random_between(-height, height), reach);
        if (shape == NARROW)
            corner[1].x = within(corner[0].x + random_between(-height, height), reach);
        double at = random_fraction();
        corner[2].x =
            within((int)lrint(corner[0].x + (corner[1].x - corner[0].x) * at) + random_between(-height, height), reach);
        corner[2].y =
            within((int)lrint(corner[0].y + (corner[1].y - corner[0].y) * at) + random_between(-height, height), reach);
    } while (cover_turn(corner[0], corner[1], corner[2]) <= 0);
}

/* Anything, or every second time the most extreme. */
static void random_values(int extreme)
{
    for (int k = 0; k < 3; k++) {
        value[k] = extreme ? random_between(0, 1) * 32768 - 16384 : random_between(-16384, 16384);
        bulge[k] = extreme ? random_between(0, 1) * (1 << 29) - (1 << 28) : random_between(-(1 << 28), 1 << 28);
    }
}

static void turn_corners(void)
{
    struct cover_point c = corner[0];
    int32_t v = value[0], b = bulge[0];
    for (int k = 0; k < 2; k++) {
        corner[k] = corner[k + 1];
        value[k] = value[k + 1];
        bulge[k] = bulge[k + 1];
    }
    corner[2] = c;
    value[2] = v;
    bulge[2] = b;
}

/* The corners as the renderer has them. */
static const int16_t *const *places(void)
{
    static int16_t xy[3][2];
    static const int16_t *const p[3] = {xy[0], xy[1], xy[2]};
    for (int k = 0; k < 3; k++) {
        xy[k][0] = (int16_t)corner[k].x;
        xy[k][1] = (int16_t)corner[k].y;
    }
    return p;
}

static struct plane setup(void)
{
    struct plane plane;
    assert_int_equal(plane_setup(&plane, places(), SIZE, SIZE), 1);
    plane_setup_quadratic(&plane);
    return plane;
}

/* Linear and quadratic part at a pixel, in Q30. */
static void truth(int x, int y, double *linear, double *bend)
{
    struct cover_point c = cover_centre(x, y, SIZE, SIZE);
    double area = (double)cover_turn(corner[0], corner[1], corner[2]);
    double l[3] = {(double)cover_turn(c, corner[1], corner[2]) / area,
                   (double)cover_turn(corner[0], c, corner[2]) / area,
                   (double)cover_turn(corner[0], corner[1], c) / area};
    *linear = *bend = 0;
    for (int k = 0; k < 3; k++) {
        *linear += value[k] * l[k] * 0x1p16;
        *bend += bulge[k] * l[k] * l[(k + 1) % 3] * 0x1p2;
    }
}

static double worst[2][2];         /* [quadratic][exact] */
static long tested[2][2], thin[2]; /* triangles that are not, and that are */

static int32_t extent(void)
{
    int32_t most = 0;
    for (int k = 0; k < 3; k++) {
        int32_t x = corner[(k + 1) % 3].x - corner[k].x, y = corner[(k + 1) % 3].y - corner[k].y;
        most = most > abs(x) ? most : abs(x);
        most = most > abs(y) ? most : abs(y);
    }
    return most;
}

static void check_value(int quadratic, int exact, int x, int y, int32_t got, double wanted)
{
    double error = fabs(got - wanted) / UNIT;
    double bound = exact                  ? EXACT_ERROR
                   : !quadratic           ? LINEAR_ERROR
                   : extent() > 1024 * 16 ? WIDE_ERROR
                                          : QUADRATIC_ERROR;
    if (error > bound)
        fail_msg("(%d, %d) (%d, %d) (%d, %d)/16 px, %s%s: pixel (%d, %d) is off by %.3f display units", corner[0].x,
                 corner[0].y, corner[1].x, corner[1].y, corner[2].x, corner[2].y, quadratic ? "quadratic" : "linear",
                 exact ? ", exact" : "", x, y, error);
    if (error > worst[quadratic][exact])
        worst[quadratic][exact] = error;
    tested[quadratic][exact]++;
}

static void check_pixel(const struct plane *plane, const struct channel *linear, const struct channel *quadratic, int x,
                        int y)
{
    int32_t got;
    double wanted, bend;
    truth(x, y, &wanted, &bend);
    plane_values(plane, linear, x, y, 1, &got);
    check_value(0, linear->exact, x, y, got, wanted);
    plane_values(plane, quadratic, x, y, 1, &got);
    check_value(1, quadratic->exact != 0, x, y, got, wanted - bend);
}

/* All covered pixels; of long spans the ends and `some` others. */
static void check_triangle(int some)
{
    struct plane plane = setup();
    struct channel linear, quadratic;
    struct edges edges;
    struct span span;
    plane_linear(&plane, value, &linear);
    plane_quadratic(&plane, value, bulge, &quadratic);
    assert_int_equal(linear.exact, plane.sliver);
    assert_int_equal(quadratic.exact != 0, plane.slim);
    thin[plane.thin]++;
    if (!edges_setup(&edges, places(), SIZE, SIZE, 0, SIZE))
        return;
    for (int y = edges.row; edges.row < edges.last; y++) {
        edges_spans(&edges, SIZE, &span, 1);
        int n = span.x1 - span.x0;
        for (int i = 0; i < n && i < some; i++)
            check_pixel(&plane, &linear, &quadratic, n <= some ? span.x0 + i : random_between(span.x0, span.x1 - 1), y);
        if (n > some) {
            check_pixel(&plane, &linear, &quadratic, span.x0, y);
            check_pixel(&plane, &linear, &quadratic, span.x1 - 1, y);
        }
    }
}

/* Many triangles of a shape and size, given in sub-pixels from the middle. */
static void check_triangles(enum shape shape, int reach, int count)
{
    for (int i = 0; i < count; i++) {
        random_triangle(shape, reach, 2 << (i % 6));
        random_values(i & 1);
        check_triangle(reach > 1000 ? 1 : 16);
    }
}

static void print_worst(void)
{
    for (int i = 0; i < 4; i++)
        print_message("%s%s: %ld pixels, at most %.4f display units off\n", i & 2 ? "quadratic" : "linear",
                      i & 1 ? ", exact" : "", tested[i >> 1][i & 1], worst[i >> 1][i & 1]);
}

static void every_pixel_up_to_1024_across_is_within_the_bounds(void **state)
{
    (void)state;
    random_seed(11);
    for (int shape = ANY; shape < SHAPES; shape++)
        for (int reach = 8; reach <= 8192; reach *= 2)
            check_triangles(shape, reach, reach > 1000 ? 500 : 4000);
    print_worst();
    for (int i = 0; i < 4; i++)
        assert_true(tested[i >> 1][i & 1] > 1000);
}

static void every_pixel_up_to_2048_across_is_within_the_bounds(void **state)
{
    (void)state;
    random_seed(12);
    for (int shape = ANY; shape < SHAPES; shape++)
        for (int reach = 8500; reach <= 16384; reach += 3942)
            check_triangles(shape, reach, 500);
    print_worst();
}

/* Heights about the limit of a quadratic, 2 pixels, on either side of it, at all lengths and angles. */
/* Bends of up to 2.9, in place of the 1 that 32 bits hold, from values in Q30 and in Q14; small triangles, where the
 * rounding of second differences does not show, so that an error of the arithmetic would. */
static void large_bends_are_taken_in_64_bits(void **state)
{
    (void)state;
    double most = 0;
    for (int i = 0; i < 20000; i++) {
        struct channel wide, narrow;
        random_triangle((enum shape)(i % SHAPES), 1500, 500);
        random_values(i & 1);
        for (int k = 0; k < 3; k++)
            bulge[k] += bulge[k] / 10 * 19;
        struct plane plane = setup();
        const int32_t q30[3] = {value[0] * 65536, value[1] * 65536, value[2] * 65536};
        plane_quadratic_wide(&plane, q30, bulge, &wide);
        plane_quadratic_large(&plane, value, bulge, &narrow);
        for (int n = 0; n < 8; n++) {
            double l[2] = {random_fraction(), random_fraction()}, linear, bend;
            int u = (int)(l[0] > l[1]), x, y;
            x = (int)floor(
                (corner[0].x + (corner[1].x - corner[0].x) * l[u] + (corner[2].x - corner[0].x) * (l[!u] - l[u])) / 16 +
                SIZE / 2);
            y = (int)floor(
                (corner[0].y + (corner[1].y - corner[0].y) * l[u] + (corner[2].y - corner[0].y) * (l[!u] - l[u])) / 16 +
                SIZE / 2);
            struct cover_point c = cover_centre(x, y, SIZE, SIZE);
            if (cover_turn(c, corner[1], corner[2]) < 0 || cover_turn(corner[0], c, corner[2]) < 0 ||
                cover_turn(corner[0], corner[1], c) < 0)
                continue;
            int32_t got[2];
            truth(x, y, &linear, &bend);
            plane_values(&plane, &wide, x, y, 1, &got[0]);
            plane_values(&plane, &narrow, x, y, 1, &got[1]);
            for (int way = 0; way < 2; way++) {
                double error = fabs(got[way] - (linear - bend)) / UNIT;
                most = error > most ? error : most;
            }
            tested[1][1]++;
        }
    }
    print_message("at most %.4f display units off\n", most);
    assert_true(most < 2 * EXACT_ERROR); /* weights have 16 bits, and the bends are larger */
}

static void about_two_pixels_of_height_are_within_the_bounds(void **state)
{
    (void)state;
    const long before[2] = {thin[0], thin[1]};
    random_seed(13);
    for (int i = 0; i < 20000; i++) {
        double angle = random_real(0, 2 * 3.14159265358979), length = random_magnitude(32, 8000),
               height = random_real(24, 48), at = random_real(-.2, 1.2);
        double c = cos(angle), s = sin(angle);
        corner[0] = random_point(64);
        corner[1].x = corner[0].x + (int)lrint(length * c);
        corner[1].y = corner[0].y + (int)lrint(length * s);
        corner[2].x = corner[0].x + (int)lrint(length * at * c - height * s);
        corner[2].y = corner[0].y + (int)lrint(length * at * s + height * c);
        random_values(i & 1);
        check_triangle(4);
    }
    assert_true(thin[0] - before[0] > 4000 && thin[1] - before[1] > 4000);
}

/* Where the mixed difference is largest of all triangles that are not thin: bends of half a turn and alternating signs,
 * with corner 0 in each place of a pixel. */
static void the_sharpest_bends_two_pixels_high_do_not_wrap(void **state)
{
    (void)state;
    static const int32_t most[2] = {PLANE_MOST_BULGE, 1 << 28};
    for (int place = 0; place < 512; place++) {
        const int x = place & 15, y = place >> 4 & 15;
        const struct cover_point at[3] = {{x, y}, {x + 124, y + 127}, {x - 127, y - 97}};
        static struct shade_setup s;
        struct channel *channel = &s.channel[0];
        int32_t got;
        for (int k = 0; k < 3; k++) {
            corner[k] = at[k];
            value[k] = 0;
            bulge[k] = k == 1 ? -most[place >> 8] : most[place >> 8];
        }
        s.plane = setup();
        assert_false(s.plane.thin);
        dots_quadratic(&s, value, bulge, channel);
        for (int row = SIZE / 2 - 4; row < SIZE / 2 + 5; row++)
            for (int column = SIZE / 2 - 5; column < SIZE / 2 + 6; column++) {
                const struct cover_point c = cover_centre(column, row, SIZE, SIZE);
                if (cover_turn(c, corner[1], corner[2]) < 0 || cover_turn(corner[0], c, corner[2]) < 0 ||
                    cover_turn(corner[0], corner[1], c) < 0)
                    continue;
                double linear, bend;
                truth(column, row, &linear, &bend);
                plane_values(&s.plane, channel, column, row, 1, &got);
                check_value(1, 0, column, row, got, linear - bend);
            }
    }
}

/* A triangle of one sub-pixel squared holds a pixel centre at most in a corner: its value is that corner's. */
static void the_smallest_triangles_have_their_corners_values(void **state)
{
    (void)state;
    int seen = 0;
    random_seed(14);
    for (int i = 0; i < 200000; i++) {
        corner[0] = cover_centre(random_between(0, SIZE - 1), random_between(0, SIZE - 1), SIZE, SIZE);
        for (int k = 1; k < 3; k++)
            corner[k] = (struct cover_point){corner[0].x + random_between(-9, 9), corner[0].y + random_between(-9, 9)};
        if (cover_turn(corner[0], corner[1], corner[2]) != 1)
            continue;
        random_values(i & 1);
        int32_t first = value[0], got;
        int x = (corner[0].x + 8 * SIZE) >> 4, y = (corner[0].y + 8 * SIZE) >> 4;
        for (int k = 0; k < 3; k++, turn_corners()) {
            struct plane plane = setup();
            struct channel linear, quadratic;
            plane_linear(&plane, value, &linear);
            plane_quadratic(&plane, value, bulge, &quadratic);
            plane_values(&plane, &linear, x, y, 1, &got);
            check_value(0, linear.exact, x, y, got, first * 0x1p16);
            plane_values(&plane, &quadratic, x, y, 1, &got);
            check_value(1, quadratic.exact != 0, x, y, got, first * 0x1p16);
        }
        seen++;
    }
    assert_true(seen > 1000);
}

static void whichever_corner_comes_first_the_values_agree(void **state)
{
    (void)state;
    random_seed(15);
    for (int i = 0; i < 20000; i++) {
        random_triangle((enum shape)(i % SHAPES), 16 << i % 10, 24);
        random_values(i & 1);
        int32_t got[3];
        int exact = 0;
        int x = (corner[0].x + corner[1].x + corner[2].x) / 48 + SIZE / 2,
            y = (corner[0].y + corner[1].y + corner[2].y) / 48 + SIZE / 2;
        if (!cover_polygon(corner, 3, cover_centre(x, y, SIZE, SIZE)))
            continue;
        for (int k = 0; k < 3; k++, turn_corners()) {
            struct plane plane = setup();
            struct channel quadratic;
            plane_quadratic(&plane, value, bulge, &quadratic);
            plane_values(&plane, &quadratic, x, y, 1, &got[k]);
            exact += quadratic.exact;
        }
        for (int k = 1; k < 3; k++)
            assert_true(fabs((double)got[k] - got[0]) <= 2 * (exact == 3 ? EXACT_ERROR : QUADRATIC_ERROR) * UNIT);
    }
}

/* "A pixel's value depends on the triangle and (x, y) alone". */
static void a_run_has_the_bits_of_its_pixels_one_by_one(void **state)
{
    (void)state;
    random_seed(16);
    for (int i = 0; i < 20000; i++) {
        random_triangle((enum shape)(i % SHAPES), 16 << i % 11, 24);
        random_values(i & 1);
        struct plane plane = setup();
        struct channel channel;
        if (i & 2)
            plane_linear(&plane, value, &channel);
        else
            plane_quadratic(&plane, value, bulge, &channel);
        struct cover_point middle = corner[random_between(0, 2)];
        int x = (middle.x + 8 * SIZE) >> 4, y = (middle.y + 8 * SIZE) >> 4;
        int32_t run[16], one;
        plane_values(&plane, &channel, x, y, 16, run);
        for (int j = 0; j < 16; j++) {
            plane_values(&plane, &channel, x + j, y, 1, &one);
            assert_int_equal(one, run[j]);
        }
    }
}

/* Depths are unsigned: their differences need 17 bits, their values all 32. */
static void depths_over_their_whole_range_stay_within_the_bound(void **state)
{
    (void)state;
    random_seed(17);
    for (int i = 0; i < 5000; i++) {
        random_triangle((enum shape)(i % SHAPES), 16 << i % 10, 24);
        for (int k = 0; k < 3; k++)
            value[k] = i & 1 ? random_between(0, 1) * 65535 : random_between(0, 65535);
        struct plane plane = setup();
        struct channel channel;
        plane_linear(&plane, value, &channel);
        for (int j = 0; j < 3; j++) { /* the pixels around each corner, those that are covered */
            int x = (corner[j].x + 8 * SIZE) >> 4, y = (corner[j].y + 8 * SIZE) >> 4;
            for (int n = 0; n < 9; n++) {
                int px = x + n % 3 - 1, py = y + n / 3 - 1;
                double wanted, bend;
                int32_t got;
                if (!cover_polygon(corner, 3, cover_centre(px, py, SIZE, SIZE)))
                    continue;
                truth(px, py, &wanted, &bend);
                plane_values(&plane, &channel, px, py, 1, &got);
                double error = fabs((uint32_t)got - wanted);
                error =
                    error > 0x1p31 ? 0x1p32 - error : error; /* a little below 0; the margins of depths keep it away */
                assert_true(error <= 2 * LINEAR_ERROR * UNIT); /* twice the range of the others */
            }
        }
    }
}

static void a_triangle_without_area_or_the_wrong_way_round_is_refused(void **state)
{
    (void)state;
    struct plane plane;
    random_seed(18);
    for (int i = 0; i < 10000; i++) {
        random_triangle((enum shape)(i % SHAPES), 16 << i % 11, 2);
        assert_int_equal(plane_setup(&plane, places(), SIZE, SIZE), 1);
        const int16_t *const *p = places();
        const int16_t *const back[3] = {p[0], p[2], p[1]}, *const none[3] = {p[0], p[1], p[1]};
        assert_int_equal(plane_setup(&plane, back, SIZE, SIZE), 0);
        assert_int_equal(plane_setup(&plane, none, SIZE, SIZE), 0);
    }
}

/* Beyond the edge from corner 1 to 2, at 3/4 along both others: what is over comes off the second. */
static void exact_values_are_clamped_to_the_triangle(void **state)
{
    static const int32_t ends[3] = {0, 100, 300};
    struct channel channel = {.exact = PLANE_EXACT};
    int32_t got;
    (void)state;
    corner[0] = (struct cover_point){8, 8}; /* a pixel's centre */
    corner[1] = (struct cover_point){8 + 64, 8};
    corner[2] = (struct cover_point){8, 8 + 64};
    const struct plane plane = setup();
    plane_keep_corners(&channel, ends, NULL);
    plane_exact_values(&plane, &channel, SIZE / 2 + 3, SIZE / 2 + 3, 1, &got);
    assert_true(fabs(got - (.75 * 100 + .25 * 300) * 0x1p16) <= 400); /* weights within 2^-16 */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_up_to_1024_across_is_within_the_bounds),
        cmocka_unit_test(every_pixel_up_to_2048_across_is_within_the_bounds),
        cmocka_unit_test(large_bends_are_taken_in_64_bits),
        cmocka_unit_test(about_two_pixels_of_height_are_within_the_bounds),
        cmocka_unit_test(the_sharpest_bends_two_pixels_high_do_not_wrap),
        cmocka_unit_test(the_smallest_triangles_have_their_corners_values),
        cmocka_unit_test(whichever_corner_comes_first_the_values_agree),
        cmocka_unit_test(a_run_has_the_bits_of_its_pixels_one_by_one),
        cmocka_unit_test(depths_over_their_whole_range_stay_within_the_bound),
        cmocka_unit_test(a_triangle_without_area_or_the_wrong_way_round_is_refused),
        cmocka_unit_test(exact_values_are_clamped_to_the_triangle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

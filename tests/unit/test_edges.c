/* SPDX-License-Identifier: MIT */
#include "cover.h"
#include "random.h"
#include "raster/edges.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#define RING_MOST 8

struct picture {
    unsigned width, height;
    uint8_t *pixel;
};

static struct picture picture_new(unsigned width, unsigned height)
{
    struct picture picture = {width, height, calloc(width, height)};
    assert_non_null(picture.pixel);
    return picture;
}

/* The spans of a clockwise triangle in rows [from, to), asked for `most` at a time; each must lie in the picture.
 * Calls `each` for every pixel. */
static void draw(struct picture *picture, const struct cover_point *const corner[3], int from, int to, int most,
                 void each(uint8_t *pixel, int what), int what)
{
    int16_t xy[3][2];
    const int16_t *p[3];
    struct edges edges;
    struct span span[32];
    for (int k = 0; k < 3; k++) {
        xy[k][0] = (int16_t)corner[k]->x;
        xy[k][1] = (int16_t)corner[k]->y;
        p[k] = xy[k];
    }
    if (!edges_setup(&edges, p, picture->width, picture->height, from, to))
        return;
    assert_true(edges.row >= from && edges.row < edges.last && edges.last <= to);
    for (int row = edges.row; edges.row < edges.last;) {
        int count = edges_spans(&edges, (int)picture->width, span, most);
        assert_in_range(count, 1, most);
        assert_int_equal(edges.row, row + count);
        for (int i = 0; i < count; i++, row++) {
            if (span[i].x1 <= span[i].x0)
                continue;
            assert_true(span[i].x0 >= 0 && span[i].x1 <= (int)picture->width);
            for (int x = span[i].x0; x < span[i].x1; x++)
                each(&picture->pixel[(size_t)row * picture->width + (size_t)x], what);
        }
    }
}

static void add_one(uint8_t *pixel, int what)
{
    *pixel = (uint8_t)(*pixel + what);
}

static void draw_whole(struct picture *picture, const struct cover_point *a, const struct cover_point *b,
                       const struct cover_point *c)
{
    const struct cover_point *const corner[3] = {a, b, c};
    draw(picture, corner, 0, (int)picture->height, 32, add_one, 1);
}

static struct cover_point random_point(int reach, int step)
{
    return (struct cover_point){random_between(-reach / step, reach / step) * step,
                                random_between(-reach / step, reach / step) * step};
}

/* Below or above the point that angles are taken about, and then by the turn. */
static struct cover_point fan_centre;
static int by_angle(const void *left, const void *right)
{
    const struct cover_point *a = left, *b = right;
    int a_half = a->y < fan_centre.y || (a->y == fan_centre.y && a->x < fan_centre.x);
    int b_half = b->y < fan_centre.y || (b->y == fan_centre.y && b->x < fan_centre.x);
    int64_t turn = cover_turn(fan_centre, *a, *b);
    return a_half != b_half ? a_half - b_half : turn > 0 ? -1 : turn < 0;
}

/* A closed fan: ring[] turns clockwise about fan_centre. 0 if these random points do not make one. */
static int random_fan(struct cover_point *ring, int count, int reach, int step)
{
    fan_centre = random_point(reach, step);
    for (int i = 0; i < count; i++)
        ring[i] = random_point(reach, step);
    qsort(ring, (size_t)count, sizeof *ring, by_angle);
    for (int i = 0; i < count; i++)
        if (cover_turn(fan_centre, ring[i], ring[(i + 1) % count]) <= 0)
            return 0;
    return 1;
}

static void check_fan(struct picture *picture, const struct cover_point *ring, int count)
{
    memset(picture->pixel, 0, (size_t)picture->width * picture->height);
    for (int i = 0; i < count; i++)
        draw_whole(picture, &fan_centre, &ring[i], &ring[(i + 1) % count]);
    const uint8_t *pixel = picture->pixel;
    for (unsigned y = 0; y < picture->height; y++)
        for (unsigned x = 0; x < picture->width; x++) {
            int times = *pixel++;
            struct cover_point centre = cover_centre((int)x, (int)y, picture->width, picture->height);
            if (times != cover_polygon(ring, count, centre)) {
                for (int i = 0; i < count; i++)
                    print_message("ring (%d, %d)/16 px\n", ring[i].x, ring[i].y);
                fail_msg("fan about (%d, %d)/16 px: pixel (%u, %u) of %u x %u is drawn %d times", fan_centre.x,
                         fan_centre.y, x, y, picture->width, picture->height, times);
            }
        }
}

/* `count` fans whose corners lie on a lattice of `step` sub-pixels within `reach` of the picture's centre. */
static void check_fans(unsigned width, unsigned height, int reach, int step, int count)
{
    struct picture picture = picture_new(width, height);
    struct cover_point ring[RING_MOST];
    while (count > 0) {
        int corners = random_between(3, RING_MOST);
        if (!random_fan(ring, corners, reach, step))
            continue;
        check_fan(&picture, ring, corners);
        count--;
    }
    free(picture.pixel);
}

static void shared_edge_is_drawn_once(void **state)
{
    (void)state;
    random_seed(1);
    check_fans(8, 8, 64, 8, 120000); /* half the corners' coordinates are those of pixel centres */
    check_fans(7, 7, 64, 8, 60000);  /* the other half of them; past the picture's sides */
    check_fans(8, 8, 64, 4, 60000);
    check_fans(8, 8, 64, 1, 100000);
    check_fans(2, 2, 16, 1, 50000);
    check_fans(5, 3, 100, 1, 20000);
}

static void shared_edge_is_drawn_once_at_every_extent(void **state)
{
    (void)state;
    random_seed(2);
    check_fans(1, 1, 8, 1, 20000); /* within one pixel */
    check_fans(2, 2, 3, 1, 20000); /* less than half a pixel, about a corner of pixels */
    check_fans(64, 48, 512, 8, 1000);
    check_fans(64, 48, 16384, 1, 1000); /* far beyond the picture, as far as the guard band */
    check_fans(300, 240, 2400, 8, 50);
    check_fans(2048, 1, 16384, 8, 100);
    check_fans(1, 2048, 16384, 8, 100);
    check_fans(2048, 2048, 16384, 8, 1);
    check_fans(2048, 2048, 16384, 1, 2);
}

static struct cover_point corner[3];

/* Clockwise, area not 0. */
static void random_triangle(int reach, int step)
{
    do {
        for (int k = 0; k < 3; k++)
            corner[k] = random_point(reach, step);
    } while (cover_turn(corner[0], corner[1], corner[2]) <= 0);
}

static void a_triangle_cut_into_bands_covers_the_same_pixels(void **state)
{
    (void)state;
    struct picture whole = picture_new(40, 40), bands = picture_new(40, 40);
    random_seed(3);
    for (int i = 0; i < 20000; i++) {
        random_triangle(i & 1 ? 320 : 3000, 1 << (i & 3));
        memset(whole.pixel, 0, 1600);
        memset(bands.pixel, 0, 1600);
        const struct cover_point *const p[3] = {&corner[0], &corner[1], &corner[2]};
        draw_whole(&whole, p[0], p[1], p[2]);
        int height = random_between(1, 39), most = random_between(1, 32);
        for (int from = 0; from < 40; from += height)
            draw(&bands, p, from, from + height < 40 ? from + height : 40, most, add_one, 1);
        assert_memory_equal(whole.pixel, bands.pixel, 1600);
    }
    free(whole.pixel);
    free(bands.pixel);
}

static void the_first_corner_does_not_matter(void **state)
{
    (void)state;
    struct picture picture = picture_new(24, 24);
    random_seed(4);
    for (int i = 0; i < 20000; i++) {
        random_triangle(i & 1 ? 192 : 2000, 8);
        memset(picture.pixel, 0, 576);
        for (int k = 0; k < 3; k++)
            draw_whole(&picture, &corner[k], &corner[(k + 1) % 3], &corner[(k + 2) % 3]);
        for (int j = 0; j < 576; j++)
            assert_true(picture.pixel[j] == 0 || picture.pixel[j] == 3);
    }
    free(picture.pixel);
}

static void a_triangle_beyond_the_rows_asked_for_has_none(void **state)
{
    (void)state;
    static const int16_t xy[3][2] = {{0, -16}, {16, 16}, {-16, 16}}; /* rows 3 and 4 of 8 */
    const int16_t *const p[3] = {xy[0], xy[1], xy[2]};
    struct edges edges;
    assert_int_equal(edges_setup(&edges, p, 8, 8, 0, 3), 0);
    assert_int_equal(edges_setup(&edges, p, 8, 8, 5, 8), 0);
    assert_int_equal(edges_setup(&edges, p, 8, 8, 0, 4), 1);
    assert_int_equal(edges.row, 3);
    assert_int_equal(edges_setup(&edges, p, 8, 8, 4, 8), 1);
    assert_int_equal(edges.row, 4);
    assert_int_equal(edges.last, 5);
}

/* Pictures that pin the rule. Corners are in half pixels from the top left: an odd one is a pixel centre. */
struct golden {
    const char *name;
    int triangles;
    int corner[4][6];
    const char *rows; /* '.' none, or the triangle that draws the pixel: a, b, ...; 8 columns */
};

static void mark(uint8_t *pixel, int what)
{
    *pixel = (uint8_t)(*pixel == '.' ? what : '!'); /* twice */
}

static const struct golden goldens[] = {
    {"a square between pixel centres loses its right column and its bottom row; \\ goes to the right one",
     2,
     {{3, 3, 9, 3, 9, 9}, {3, 3, 9, 9, 3, 9}},
     "........\n"
     ".aaa....\n"
     ".baa....\n"
     ".bba....\n"
     "........\n"
     "........\n"},
    {"so does / to the right one",
     2,
     {{3, 3, 9, 3, 3, 9}, {9, 3, 9, 9, 3, 9}},
     "........\n"
     ".aaa....\n"
     ".aab....\n"
     ".abb....\n"
     "........\n"
     "........\n"},
    {"a square between pixel corners keeps all of its pixels",
     2,
     {{2, 2, 8, 2, 8, 8}, {2, 2, 8, 8, 2, 8}},
     "........\n"
     ".aaa....\n"
     ".baa....\n"
     ".bba....\n"
     "........\n"
     "........\n"},
    {"four triangles about a pixel centre: each axis goes to the one below or right of it",
     4,
     {{7, 7, 1, 7, 7, 1}, {7, 7, 7, 1, 13, 7}, {7, 7, 13, 7, 7, 13}, {7, 7, 7, 13, 1, 7}},
     "........\n"
     "..ab....\n"
     ".aabb...\n"
     "dddccc..\n"
     ".ddcc...\n"
     "..dc....\n"},
    {"four triangles about a pixel corner",
     4,
     {{8, 6, 4, 2, 12, 2}, {8, 6, 12, 2, 12, 10}, {8, 6, 12, 10, 4, 10}, {8, 6, 4, 10, 4, 2}},
     "........\n"
     "..aaab..\n"
     "..dabb..\n"
     "..dcbb..\n"
     "..cccb..\n"
     "........\n"},
    {"less than a pixel: drawn if it holds a centre, on its left or top too",
     4,
     {{2, 3, 4, 1, 4, 4}, {7, 3, 8, 3, 7, 4}, {10, 3, 11, 2, 11, 3}, {13, 2, 14, 2, 13, 3}},
     "........\n"
     ".a.b....\n"
     "........\n"
     "........\n"
     "........\n"
     "........\n"},
    {"a row of centres on the lower side is not reached, one through the left corner is",
     2,
     {{0, 2, 16, 2, 16, 3}, {0, 4, 16, 6, 0, 5}},
     "........\n"
     "........\n"
     "bbbb....\n"
     "........\n"
     "........\n"
     "........\n"},
};

static void the_top_left_rule_is_pinned_by_pictures(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof goldens / sizeof *goldens; i++) {
        const struct golden *g = &goldens[i];
        struct picture picture = picture_new(8, 6);
        char text[6 * 9 + 1] = "";
        memset(picture.pixel, '.', 48);
        for (int t = 0; t < g->triangles; t++) {
            struct cover_point p[3];
            for (int k = 0; k < 3; k++)
                p[k] = (struct cover_point){8 * g->corner[t][2 * k] - 64, 8 * g->corner[t][2 * k + 1] - 48};
            assert_true(cover_turn(p[0], p[1], p[2]) > 0);
            const struct cover_point *const corners[3] = {&p[0], &p[1], &p[2]};
            draw(&picture, corners, 0, 6, 32, mark, 'a' + t);
        }
        for (int y = 0; y < 6; y++) {
            strncat(text, (const char *)picture.pixel + 8 * y, 8);
            strcat(text, "\n");
        }
        if (strcmp(text, g->rows) != 0)
            fail_msg("%s:\n%sis drawn as\n%s", g->name, g->rows, text);
        free(picture.pixel);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_top_left_rule_is_pinned_by_pictures),
        cmocka_unit_test(shared_edge_is_drawn_once),
        cmocka_unit_test(shared_edge_is_drawn_once_at_every_extent),
        cmocka_unit_test(a_triangle_cut_into_bands_covers_the_same_pixels),
        cmocka_unit_test(the_first_corner_does_not_matter),
        cmocka_unit_test(a_triangle_beyond_the_rows_asked_for_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Frames of which nothing is left after snapping, and corners past the guard band. */
#include "exact_rational.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "clip_case.h"

static void begin_flat(void)
{
    scene_case_sub_pixels(&scene, WIDTH, HEIGHT);
    clip_begin();
}

static void what_has_no_area_or_snaps_to_none_is_culled(void **state)
{
    (void)state;
    begin_flat();
    random_seed(21);
    struct scene_object *object = clip_part(blob->objects);
    for (int i = 0; i < 20000; i++) {
        int32_t p[4][3] = {{0}};
        const int snapped = i & 1, dx = random_between(-30, 30), dy = random_between(-30, 30);
        object->scale = snapped ? CASE_UNIT / 64 : CASE_UNIT; /* a unit is 1/64 sub-pixel, and area does not survive */
        for (int k = 0; k < 3; k++) {
            const int at = random_between(-9, 9);
            p[k][0] = snapped ? 64 * 5 + random_between(-31, 31) : at * dx;
            p[k][1] = snapped ? 64 * 3 + random_between(-31, 31) : at * dy;
            if (snapped && i & 2) /* to a line instead of to a point */
                p[k][0] += 640 * at;
        }
        clip_draw(p, triangle[0].corner);
        assert_int_equal(frame.frame.stats.culled, 1);
        clip_nothing_is_drawn();
    }
    clip_end();
}

/* Whether a pixel's centre is within `near` sub-pixels of an edge's line, exactly: edge function squared against length
 * squared. */
static int touches(const struct exact_triangle *t, int x, int y, int near)
{
    const struct cover_point c = cover_centre(x, y, t->width, t->height);
    for (int k = 0; k < 3; k++) {
        const struct cover_point a = t->p[k], b = t->p[(k + 1) % 3];
        const exact_t side = exact_edge(t, k, c), dx = b.x - a.x, dy = b.y - a.y;
        if (side * side <= (dx * dx + dy * dy) * near * near)
            return 1;
    }
    return 0;
}

/* 2048 pixels across is the most that is drawn whole; a sub-pixel more is cut, and to what is in the picture that makes
 * no difference but where a cut's rounding moves an edge, by less than a sub-pixel. */
static void a_sub_pixel_more_than_2048_pixels_is_cut(void **state)
{
    static const int32_t edge[] = {-GUARD - 2, -GUARD - 1, -GUARD, 1 - GUARD, GUARD - 1, GUARD, GUARD + 1, GUARD + 2};
    long whole = 0, cut = 0, pixels = 0, moved = 0;
    (void)state;
    begin_flat();
    random_seed(22);
    for (int i = 0; i < 30000;) {
        struct exact_triangle t = {.width = WIDTH, .height = HEIGHT};
        int32_t p[4][3] = {{0}};
        int outside = 0;
        for (int k = 0; k < 3; k++) {
            p[k][0] = random_bits() % 3 ? edge[random_bits() % 8] : random_between(-500, 500);
            p[k][1] = random_bits() % 3 ? edge[random_bits() % 8] : random_between(-500, 500);
            t.p[k] = (struct cover_point){p[k][0], -p[k][1]};
            outside |= abs(p[k][0]) > GUARD || abs(p[k][1]) > GUARD;
        }
        clip_draw(p, triangle[0].corner);
        const uint32_t clipped = frame.frame.stats.clipped;
        assert_int_equal(frame.frame.stats.dropped, 0);
        if (exact_area(&t) < 0) {
            const struct cover_point other = t.p[1];
            t.p[1] = t.p[2];
            t.p[2] = other;
        }
        int drawn = 0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                const int wanted = exact_area(&t) && exact_covers(&t, x, y), got = frame.picture[WIDTH * y + x] != 0;
                pixels += wanted;
                drawn += got;
                if (wanted == got)
                    continue;
                moved++;
                if (!outside || !touches(&t, x, y, 1))
                    fail_msg("(%d, %d) (%d, %d) (%d, %d)/16 px: pixel (%d, %d)", t.p[0].x, t.p[0].y, t.p[1].x, t.p[1].y,
                             t.p[2].x, t.p[2].y, x, y);
            }
        whole += drawn && !clipped;
        cut += drawn && clipped;
        i++;
    }
    print_message("%ld drawn whole, %ld cut; of %ld pixels %ld within a sub-pixel of a cut edge differ\n", whole, cut,
                  pixels, moved);
    assert_true(whole > 300 && cut > 3000 && pixels > 1000000);
    clip_end();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_has_no_area_or_snaps_to_none_is_culled),
        cmocka_unit_test(a_sub_pixel_more_than_2048_pixels_is_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

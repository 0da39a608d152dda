/* SPDX-License-Identifier: MIT */
/* Linear fog over triangles that are hard for a polynomial: slivers, and the
 * widest there are. */
#include "cover.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "frame_case.h"
#include "scene_case.h"

#define AWAY                                                                     \
    9000 /* the object, in units; a position unit is 1/16 of one and a sub-pixel \
            on the screen */

/* A white triangle in black fog that begins and ends at these distances.
 * Corners are sub-pixels, y down, clockwise, and 1/16 units nearer than AWAY.
 */
static struct scene_header *triangle_in_fog(struct scene_case *c, const int place[3][3], int from, int to)
{
    static struct scene_vertex vertex[3];
    static struct scene_triangle triangle;
    for (int k = 0; k < 3; k++) {
        struct scene_vertex *v = &vertex[k ? 3 - k : 0];
        v->position[0] = (int16_t)place[k][0];
        v->position[1] = (int16_t)-place[k][1];
        v->position[2] = (int16_t)place[k][2];
        scene_case_normal(v->normal, 0, 0, 1);
        triangle.corner[k] = (uint16_t)k;
    }
    scene_case_bend(&triangle, vertex);
    c->head.fog.kind = FOG_LINEAR;
    c->head.fog.from = from * CASE_UNIT;
    c->head.fog.to = to * CASE_UNIT;
    c->mesh[0].vertices = vertex;
    c->mesh[0].triangles = &triangle;
    c->mesh[0].vertex_count = 3;
    c->mesh[0].triangle_count = 1;
    return scene_case_blob(c);
}

/* Two sub-pixels high and 500 pixels long. */
static void fog_over_a_sliver_is_its_formula(void **state)
{
    enum { WIDTH = 600, HEIGHT = 4, LONG = 4000, DEEP = 32000 };
    static const int place[3][3] = {{-LONG, 7, -DEEP}, {LONG, 7, DEEP}, {LONG, 9, DEEP}};
    struct scene_case c;
    int drawn = 0;
    (void)state;
    for (int turned = 0; turned < 3; turned++) {
        const int from = AWAY - 2100 - 700 * turned, to = AWAY + 2100 + 300 * turned;
        int corner[3][3];
        for (int k = 0; k < 3; k++)
            memcpy(corner[k], place[(k + turned) % 3], sizeof corner[k]);
        scene_case_sub_pixels(&c, WIDTH, HEIGHT);
        struct scene_header *blob = triangle_in_fog(&c, (const int(*)[3])corner, from, to);
        struct frame_case f = frame_case_small(WIDTH, HEIGHT, GLINT_GREY8);
        f.config.method = &glint_flat;
        frame_case_open_for(&f, blob);
        frame_case_draw(&f, blob, 0);
        assert_int_equal(f.frame.stats.fogged, 1);
        assert_int_equal(f.frame.stats.fogged_by_pixel, 0);
        for (int x = 0; x < WIDTH; x++) {
            const double along = (16 * x + 8 - 8 * WIDTH) / (double)LONG, away = AWAY - along * DEEP / 16,
                         fog = fmax(0, fmin((away - from) / (to - from), 1));
            if (along < 0 || along > 1) /* the row of centres is in the middle of the end's height */
                continue;
            const int grey = f.picture[2 * WIDTH + x];
            if (fabs(grey - 255 * (1 - fog)) > 1)
                fail_msg("pixel %d: %d, not %.2f", x, grey, 255 * (1 - fog));
            drawn++;
        }
        frame_case_close(&f);
        free(blob);
    }
    assert_int_equal(drawn, 750);
}

/* Interpolated over 2048 pixels a part may come out at 1 + 2^-14: as much as 1,
 * also where dither adds least. */
static void fog_that_is_all_at_two_corners_leaves_no_light_between_them(void **state)
{
    enum { SIZE = 2048, ROW = 993, NEAR = 18400, FAR = -16000, THICK = (NEAR - FAR) / 16 * 16384 / (16384 - 1117) };
    static const int place[3][3] = {{4866, -3137, NEAR}, {-14510, 7088, FAR}, {224, -13112, FAR}};
    struct scene_case c;
    (void)state;
    for (int moved = 0; moved < 16; moved++) {
        const int right = moved & 3, down = moved >> 2, y = ROW + down;
        int corner[3][3];
        struct cover_point p[3];
        for (int k = 0; k < 3; k++) {
            memcpy(corner[k], place[k], sizeof corner[k]);
            p[k].x = corner[k][0] += 16 * right;
            p[k].y = corner[k][1] += 16 * down;
        }
        scene_case_sub_pixels(&c, SIZE, SIZE);
        struct scene_header *blob =
            triangle_in_fog(&c, (const int(*)[3])corner, AWAY - FAR / 16 - THICK, AWAY - FAR / 16);
        struct frame_case f = frame_case_small(SIZE, SIZE, GLINT_RGB565);
        struct glint_band band;
        f.config.method = &glint_flat;
        f.config.flags = GLINT_DITHER;
        f.config.band_rows = 1;
        frame_case_open_for(&f, blob);
        assert_int_equal(glint_frame_begin(&f.frame, blob, 0), 0);
        assert_int_equal(glint_frame_band(&f.frame, (unsigned)y, f.config.band[0], &band), 1);
        int drawn = 0;
        for (int x = 0; x < SIZE; x++) {
            const struct cover_point at = cover_centre(x, y, SIZE, SIZE);
            const double share = cover_turn(p[1], p[2], at) / (double)cover_turn(p[1], p[2], p[0]);
            if (share < 0 || cover_turn(p[0], p[1], at) < 0 || cover_turn(p[2], p[0], at) < 0)
                continue;
            drawn++;
            const double light = 31 * share * (NEAR - FAR) / 16 / THICK;
            assert_true(fabs((((const uint16_t *)band.pixels)[x] >> 11) - light) < 1.01);
        }
        assert_true(drawn > 100);
        frame_case_guards(&f);
        frame_case_close(&f);
        free(blob);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fog_over_a_sliver_is_its_formula),
        cmocka_unit_test(fog_that_is_all_at_two_corners_leaves_no_light_between_them),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

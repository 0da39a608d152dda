/* SPDX-License-Identifier: MIT */
/* Bump maps from heights, from pictures of normals and made ones, and what packing keeps of them. */
#include "scene/relief.h"

#include "pack/bump.h"
#include "scene/scene.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static double slope(const double n[3])
{
    return hypot(n[0], n[1]) / n[2];
}

static void release(struct model_texture *t)
{
    free(t->normals);
    *t = (struct model_texture){0};
}

static void a_slope_that_rises_along_u_and_v_leans_back_against_both(void **state)
{
    (void)state;
    struct model_texture t = {.clamp = {true, true}};
    double heights[4][4];
    for (int y = 0; y < 4; y++)
        for (int x = 0; x < 4; x++)
            heights[y][x] = x - 2 * y; /* rows run down, v up */
    relief_from_heights(&t, heights[0], 4, 4, 1, 1, .5);
    const double *n = t.normals[5];
    assert_true(n[0] < 0 && fabs(n[1] - 2 * n[0]) < 1e-12 && n[2] > 0);
    assert_true(fabs(slope(n) - .5) < 1e-12); /* the steepest */
    release(&t);
}

static void made_reliefs_are_as_steep_as_asked_and_repeat(void **state)
{
    static const unsigned size[2] = {64, 32}, cells[2] = {4, 2};
    (void)state;
    for (int kind = 0; kind < RELIEF_KINDS; kind++) {
        struct model_texture t = {0};
        double steepest = 0, seam = 0;
        relief_make(&t, (enum relief_kind)kind, size, cells, .75);
        for (unsigned i = 0; i < size[0] * size[1]; i++) {
            steepest = fmax(steepest, slope(t.normals[i]));
            if (i % size[0] == 0) /* the last column goes on with the first as any two do */
                seam = fmax(seam, fabs(t.normals[i][0] - t.normals[i + size[0] - 1][0]));
        }
        assert_true(fabs(steepest - .75) < 1e-9);
        assert_true(seam < .5);
        release(&t);
    }
}

static void a_normal_map_is_read_as_it_is_drawn_elsewhere(void **state)
{
    (void)state;
    struct model_texture t = {0};
    const uint8_t rgb[3][3] = {{128, 128, 255}, {255, 128, 128}, {0, 0, 0}};
    relief_from_normals(&t, rgb[0], 3, 1);
    assert_true(t.normals[0][2] > .9999);
    assert_true(t.normals[1][0] > .999);
    assert_true(t.normals[2][2] == 1); /* points inwards */
    release(&t);
}

static void packed_normals_are_unit_and_close_to_what_they_were(void **state)
{
    static const unsigned size[2] = {64, 64}, cells[2] = {3, 3};
    static const double steepness[] = {0, .1, .5, 2, 8};
    (void)state;
    for (size_t s = 0; s < sizeof steepness / sizeof *steepness; s++) {
        char name[] = "noise";
        struct model_texture t = {.name = name, .format = TEXTURE_BUMP8};
        struct texture_packed packed;
        struct pack_texture_report report;
        relief_make(&t, RELIEF_NOISE, size, cells, steepness[s]);
        texture_pack(&t, &packed, &report);
        const int8_t *texel = packed.texels;
        for (unsigned i = 0; i < 64 * 64; i++) {
            const int x = texel[2 * i], y = texel[2 * i + 1];
            const double unit = packed.head.steepness / (16384. * 128);
            const double n[3] = {x * unit, y * unit, packed.rises[(x * x + y * y) / 128] / 16384.};
            const double *was = t.normals[(63 - i / 64) * 64 + i % 64]; /* rows turned over */
            assert_true(fabs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) < .006);
            assert_true(fabs(n[0] - was[0]) < .005 && fabs(n[1] - was[1]) < .005);
        }
        assert_true(report.normals && report.error < 2);
        texture_free(&packed);
        free(report.name);
        release(&t);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slope_that_rises_along_u_and_v_leans_back_against_both),
        cmocka_unit_test(made_reliefs_are_as_steep_as_asked_and_repeat),
        cmocka_unit_test(a_normal_map_is_read_as_it_is_drawn_elsewhere),
        cmocka_unit_test(packed_normals_are_unit_and_close_to_what_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

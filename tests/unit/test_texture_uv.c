/* SPDX-License-Identifier: MIT */
/* Texture coordinates over triangles in perspective: how far each way of interpolating them is off, and the bounds. */
#include "plan/texture.h"
#include "raster/effects.h"
#include "raster/texture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>

#define SIZE 256

/* A rectangle that goes away from the eye, four times as far at its upper edge (t = 1) as at its lower one: a trapezoid
 * on the screen, u from 0 to 1 on the way. */
#define CLOSENESS(t) (1 - .75 * (t))

static double true_u(double t)
{
    return t * .25 / CLOSENESS(t);
}

/* A corner on the left (-1) or the right (1) at t. */
static void put_corner(int16_t place[3], int16_t uv[2], int side, double t)
{
    place[0] = (int16_t)lrint(side * 15 * SIZE / 2 * CLOSENESS(t));
    place[1] = (int16_t)lrint(15 * SIZE / 2 * (1 - 2 * t));
    place[2] = (int16_t)(uint16_t)lrint(DEPTH_FAR + CLOSENESS(t) * (DEPTH_NEAR - DEPTH_FAR));
    uv[0] = (int16_t)lrint(4096 * true_u(t));
    uv[1] = 0;
}

static struct raster *raster;

/* The worst error of u in a triangle of corners 0, 1, 2 as given, clockwise on the screen. */
static double worst_of(int16_t place[3][3], const int16_t (*uv)[2], unsigned kind)
{
    static const struct scene_triangle triangle = {.corner = {0, 2, 1}};
    struct raster *r = raster;
    struct uv_corners corners;
    struct edges e;
    double worst = 0;
    for (int k = 0; k < 3; k++)
        r->input.place[k] = place[k];
    r->input.triangle = &triangle;
    r->input.uvs = uv;
    r->input.divides = 1;
    assert_true(edges_setup(&e, r->input.place, SIZE, SIZE, 0, SIZE));
    assert_true(plane_setup(&r->setup.plane, r->input.place, SIZE, SIZE));
    const int32_t depth[3] = {(uint16_t)place[0][2], (uint16_t)place[1][2], (uint16_t)place[2][2]};
    plane_linear(&r->setup.plane, depth, &r->setup.depth);
    uv_corners(&corners, &r->input);
    uv_setup_corners(&r->setup, &corners, kind);
    assert_int_equal(r->setup.uv_kind, kind);
    for (int y = e.row; e.row < e.last;) {
        const int count = edges_spans(&e, SIZE, r->span, SPANS);
        for (int i = 0; i < count; i++, y++)
            for (int x = r->span[i].x0; x < r->span[i].x1; x += RUN) {
                const int n = r->span[i].x1 - x < RUN ? r->span[i].x1 - x : RUN;
                texture_coordinates(r, x, y, n);
                const double t = .5 - (16 * y + 8 - 8 * SIZE) / (15. * SIZE);
                for (int k = 0; k < n; k++)
                    worst = fmax(worst, fabs(r->uv[0][k] * 0x1p-28 - true_u(t)));
            }
    }
    return worst;
}

/* The worst of the rectangle's two triangles, each cut into pieces of one height. */
static double worst_of_rectangle(unsigned kind, int pieces)
{
    double worst = 0;
    for (int i = 0; i < pieces; i++) {
        int16_t place[4][3], uv[4][2]; /* lower left, upper left, upper right, lower right: clockwise */
        for (int k = 0; k < 4; k++)
            put_corner(place[k], uv[k], k == 0 || k == 1 ? -1 : 1, (i + (k == 1 || k == 2)) / (double)pieces);
        int16_t first[3][3], second[3][3];
        int16_t first_uv[3][2] = {{uv[0][0], 0}, {uv[1][0], 0}, {uv[2][0], 0}};
        int16_t second_uv[3][2] = {{uv[0][0], 0}, {uv[2][0], 0}, {uv[3][0], 0}};
        for (int k = 0; k < 3; k++) {
            first[0][k] = second[0][k] = place[0][k];
            first[1][k] = place[1][k];
            first[2][k] = second[1][k] = place[2][k];
            second[2][k] = place[3][k];
        }
        worst = fmax(worst, worst_of(first, (const int16_t(*)[2])first_uv, kind));
        worst = fmax(worst, worst_of(second, (const int16_t(*)[2])second_uv, kind));
    }
    return worst;
}

static void a_rectangle_at_depth_ratio_4_errs_as_theory_says(void **state)
{
    (void)state;
    raster = calloc(1, sizeof *raster);
    assert_non_null(raster);
    const double affine = worst_of_rectangle(GLINT_TEXTURE_AFFINE, 1);
    const double quadratic = worst_of_rectangle(GLINT_TEXTURE_QUADRATIC, 1);
    const double pieces = worst_of_rectangle(GLINT_TEXTURE_QUADRATIC, 4);
    const double perspective = worst_of_rectangle(GLINT_TEXTURE_PERSPECTIVE, 1);
    print_message("of the span: affine %.4f, quadratic %.4f, in 4 pieces %.4f, perspective %.5f\n", affine, quadratic,
                  pieces, perspective);
    assert_true(fabs(affine - 1. / 3) < .002);
    assert_true(fabs(quadratic - .111) < .002);
    assert_true(pieces > .008 && pieces < .0105);
    assert_true(perspective < .0005); /* coordinates and depths are rounded */
    free(raster);
}

/* The errors of the interpolations of a triangle, largest over a grid of points. */
static void find_errors(const double s[3], const double u[3], double *affine, double *quadratic)
{
    const int n = 60;
    *affine = *quadratic = 0;
    for (int i = 0; i <= n; i++)
        for (int j = 0; i + j <= n; j++) {
            const double l[3] = {i / (double)n, j / (double)n, (n - i - j) / (double)n};
            double sum = 0, product = 0, linear = 0, bend = 0;
            for (int k = 0; k < 3; k++) {
                const int next = (k + 1) % 3;
                sum += s[k] * l[k];
                product += s[k] * l[k] * u[k];
                linear += l[k] * u[k];
                bend += -2 * (u[k] - u[next]) * (s[k] - s[next]) / (s[k] + s[next]) * l[k] * l[next];
            }
            *affine = fmax(*affine, fabs(product / sum - linear));
            *quadratic = fmax(*quadratic, fabs(product / sum - (linear - bend)));
        }
}

static void no_triangle_errs_by_more_than_its_bound(void **state)
{
    (void)state;
    static const int order[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    double nearest_affine = 0, nearest_quadratic = 0;
    for (int q = 512; q <= 24576; q += 752) { /* Q15, up to 3/4 */
        const double ratio = (32768. + q) / (32768. - q),
                     bound[2] = {texture_affine(q) / 65536., texture_quadratic(q) / 65536.};
        for (int m = 0; m <= 16; m++)
            for (int o = 0; o < 6; o++)
                for (int k = 0; k < 3; k++) {
                    const double values[3] = {1, ratio, 1 + (ratio - 1) * m * m / 256.};
                    const double s[3] = {values[order[o][0]], values[order[o][1]], values[order[o][2]]};
                    double u[3] = {0, 0, 0}, affine, quadratic;
                    u[k] = 1;
                    find_errors(s, u, &affine, &quadratic);
                    assert_true(affine <= bound[0]);
                    assert_true(quadratic <= bound[1]);
                    nearest_affine = fmax(nearest_affine, affine / bound[0]);
                    nearest_quadratic = fmax(nearest_quadratic, quadratic / bound[1]);
                }
    }
    assert_true(nearest_affine > .97 && nearest_quadratic > .97); /* and the bounds are not wide */
}

static void bounds_grow_with_what_they_depend_on(void **state)
{
    (void)state;
    for (int q = 0; q < 32768; q++) {
        assert_true(texture_affine(q) <= texture_affine(q + 1));
        assert_true(texture_quadratic(q) <= texture_quadratic(q + 1));
    }
    struct scene_texture texture = {.log2_width = 6, .log2_height = 4, .flags = TEXTURE_BILINEAR, .contrast = 255 << 8};
    const uint32_t d[2] = {1 << 28, 0};
    const struct texture_spread one = texture_spread(&texture, d, 3277, 256);
    assert_in_range(one.texels, 64 << 8, (64 << 8) + 2);
    assert_in_range(one.worth, 64 * 255 << 8, (64 * 255 << 8) + 1024);
    /* a turn, ratio .1: .05 of 64 texels of full contrast */
    assert_in_range(texture_error(&one, GLINT_TEXTURE_AFFINE), 65534, 65535);
    uint32_t error = 1;
    assert_int_equal(texture_choose(&texture, &one, 128, &error), GLINT_TEXTURE_PERSPECTIVE);
    assert_int_equal(error, 0);
    texture.contrast = 16 << 8;
    const struct texture_spread faint = texture_spread(&texture, d, 328, 256); /* ratio .01 */
    assert_int_equal(texture_choose(&texture, &faint, 6 << 8, &error), GLINT_TEXTURE_AFFINE);
    assert_in_range(error, 5 << 8, 6 << 8);
    assert_int_equal(texture_choose(&texture, &faint, 128, &error), GLINT_TEXTURE_QUADRATIC);
    assert_in_range(error, 1, 128);
    texture.flags = 0; /* steps: .3 texels are too much, whatever they are worth */
    assert_int_equal(texture_choose(&texture, &faint, 60000, &error), GLINT_TEXTURE_QUADRATIC);
    const struct texture_spread flat = texture_spread(&texture, d, 0, 256);
    assert_int_equal(texture_choose(&texture, &flat, 0, &error), GLINT_TEXTURE_AFFINE);
}

/* At 65,536/255, to which 258 texels of full contrast come in full light. */
static void what_texels_are_worth_is_saturated(void **state)
{
    const struct scene_texture texture = {.log2_width = 10, .log2_height = 10, .contrast = 255 << 8};
    (void)state;
    for (uint32_t texels = 128; texels < 15 * 1024; texels += 130) { /* each way */
        const uint32_t d[2] = {texels << 18, texels << 18};
        const struct texture_spread spread = texture_spread(&texture, d, 3277, 256);
        if (texels < 129)
            assert_in_range(spread.worth, 2 * texels * 255 << 8, (2 * texels * 255 << 8) + 1024);
        else
            assert_int_equal(spread.worth, 1 << 24);
    }
}

static void no_kind_but_affine_and_quadratic_errs(void **state)
{
    const struct texture_spread worst = {1 << 23, 1 << 24, 32767};
    (void)state;
    for (unsigned kind = 0; kind < GLINT_TEXTURES; kind++)
        assert_int_equal(texture_error(&worst, kind),
                         kind == GLINT_TEXTURE_AFFINE || kind == GLINT_TEXTURE_QUADRATIC ? 65535 : 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rectangle_at_depth_ratio_4_errs_as_theory_says),
        cmocka_unit_test(no_triangle_errs_by_more_than_its_bound),
        cmocka_unit_test(bounds_grow_with_what_they_depend_on),
        cmocka_unit_test(what_texels_are_worth_is_saturated),
        cmocka_unit_test(no_kind_but_affine_and_quadratic_errs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

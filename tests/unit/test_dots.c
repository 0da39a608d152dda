/* SPDX-License-Identifier: MIT */
/* Six-sample set-up and perspective-correct numerators against double precision. */
#include "cover.h"
#include "random.h"
#include "shade/dots.h"
#include "shade/piece.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#define WIDTH  320
#define HEIGHT 240

static void the_length_factor_is_one_over_the_root(void **state)
{
    (void)state;
    for (uint32_t bend = 0; bend < 65536; bend++) {
        double wanted = bend > 65536 - 256 ? 0x1p20 : 0x1p16 / sqrt(1 - bend / 65536.);
        assert_true(fabs(dots_length_factor(bend) - wanted) < .51 + wanted * 0x1p-20);
    }
    assert_int_equal(dots_length_factor(0), 65536);
}

/* The quadratic through corners and mid-edge samples has those samples. */
static void the_bulges_bring_back_the_samples(void **state)
{
    (void)state;
    for (int i = 0; i < 100000; i++) {
        int32_t corner[3], middle[3], bulge[3];
        struct dots_factors factors = {.stretch = 65536};
        for (int k = 0; k < 3; k++) {
            factors.edge[k] = (uint32_t)random_between(65536, 1 << 18);
            corner[k] = random_between(-16384, 16384);
            middle[k] = (int32_t)(random_between(-16384, 16384) * 2 / (factors.edge[k] / 65536.));
        }
        dots_bulges(corner, middle, &factors, bulge);
        for (int k = 0; k < 3; k++) {
            double sample = (corner[k] + corner[(k + 1) % 3]) / 2. - bulge[k] / 65536.;
            assert_true(fabs(sample - middle[k] * (factors.edge[k] / 131072.)) < .01);
        }
    }
}

/* Of corners that are all light, and of light that is behind in the middle: 2^31 and beyond. */
static void bulges_that_32_bits_do_not_hold_are_saturated(void **state)
{
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2)
        for (uint32_t factor = 65534; factor < 65540; factor++) {
            const int32_t corner[3] = {sign * 16384, sign * 16384, sign * 16383};
            const int32_t middle[3] = {sign * -32768, sign * -32767, sign * 32768};
            const struct dots_factors factors = {.edge = {factor, factor, factor}, .stretch = 65536};
            int32_t bulge[3];
            dots_bulges(corner, middle, &factors, bulge);
            for (int k = 0; k < 3; k++) {
                const double ends = corner[k] + corner[(k + 1) % 3], exact = ends * 0x1p15 - middle[k] * (factor / 2.);
                assert_true(fabs(bulge[k] - fmax(-INT32_MAX, fmin(exact, INT32_MAX))) < 1);
            }
        }
}

/* The weights' differences along the first edge are 1, -1/2, -1/2: 5/4 of the bulges. */
static void bulges_of_a_piece_that_32_bits_do_not_hold_are_saturated(void **state)
{
    static const uint16_t weight[3][3] = {{0, 16384, 16384}, {32768, 0, 0}, {0, 32768, 0}};
    (void)state;
    for (int sign = -1; sign <= 1; sign += 2)
        for (int32_t size = 1 << 28; size > 0 && size <= INT32_MAX;
             size = (int32_t)(size * 1.1 < INT32_MAX ? size * 1.1 : -1)) {
            int32_t value[3] = {0, 0, 0}, bulge[3] = {sign * -size, sign * size, sign * -size};
            piece_quadratic(weight, value, bulge);
            const double wanted = fmin(1.25 * size, INT32_MAX);
            assert_true(fabs(bulge[0] * -(double)sign - wanted) < 16);
        }
}

/* A triangle of corners at different distances, and a quadratic over it in space. */
static struct {
    int16_t place[3][3];
    int32_t value[3], bulge[3];
    double s[3]; /* 1/w, to a common factor */
} given;

static const int16_t *const places[3] = {given.place[0], given.place[1], given.place[2]};

static void random_triangle(int nearest, int farthest)
{
    struct cover_point p[3];
    do
        for (int k = 0; k < 3; k++)
            p[k] = (struct cover_point){random_between(-8 * WIDTH, 8 * WIDTH), random_between(-8 * HEIGHT, 8 * HEIGHT)};
    while (cover_turn(p[0], p[1], p[2]) < 20000);
    for (int k = 0; k < 3; k++) {
        given.place[k][0] = (int16_t)p[k].x;
        given.place[k][1] = (int16_t)p[k].y;
        given.place[k][VERTEX_DEPTH] = (int16_t)(uint16_t)random_between(farthest, nearest);
        given.s[k] = (uint16_t)given.place[k][VERTEX_DEPTH] - DEPTH_FAR;
        given.value[k] = random_between(-16384, 16384);
        given.bulge[k] = random_between(-(1 << 27), 1 << 27);
    }
}

/* Barycentric coordinates of a pixel centre, in the picture and in space; 0 outside. */
static int coordinates(int x, int y, double screen[3], double space[3])
{
    struct cover_point p[3], c = cover_centre(x, y, WIDTH, HEIGHT);
    for (int k = 0; k < 3; k++)
        p[k] = (struct cover_point){given.place[k][0], given.place[k][1]};
    double area = (double)cover_turn(p[0], p[1], p[2]), sum = 0;
    screen[0] = (double)cover_turn(c, p[1], p[2]) / area;
    screen[1] = (double)cover_turn(p[0], c, p[2]) / area;
    screen[2] = (double)cover_turn(p[0], p[1], c) / area;
    for (int k = 0; k < 3; k++)
        sum += screen[k] * given.s[k];
    for (int k = 0; k < 3; k++)
        space[k] = screen[k] * given.s[k] / sum;
    return screen[0] >= 0 && screen[1] >= 0 && screen[2] >= 0;
}

/* Errors in 1/256 of full intensity, the largest, over random pixels of a triangle. */
static void check_pixels(const struct plane *plane, const struct perspective *perspective,
                         const struct channel channel[3], double worst[2])
{
    for (int i = 0; i < 200; i++) {
        double screen[3], space[3], linear = 0, bend = 0;
        int32_t value[3];
        int x = random_between(0, WIDTH - 1), y = random_between(0, HEIGHT - 1);
        if (!coordinates(x, y, screen, space))
            continue;
        for (int k = 0; k < 3; k++) {
            linear += given.value[k] * space[k] / 16384;
            bend += given.bulge[k] * space[k] * space[(k + 1) % 3] * 0x1p-28;
        }
        for (int c = 0; c < 3; c++)
            plane_values(plane, &channel[c], x, y, 1, &value[c]);
        struct perspective_divisor by = perspective_divisor((uint32_t)value[0], perspective->up);
        worst[0] = fmax(worst[0], fabs(perspective_divide(value[1], by) * 0x1p-30 - linear) * 256);
        worst[1] = fmax(worst[1], fabs(perspective_divide_twice(value[2], by) * 0x1p-30 - (linear - bend)) * 256);
    }
}

static void check_depths(int nearest, int farthest, double most)
{
    double worst[2] = {0, 0};
    struct shade_input in = {.divides = 1, .place = {places[0], places[1], places[2]}};
    for (int i = 0; i < 3000; i++) {
        struct plane plane;
        struct channel channel[3];
        struct perspective perspective;
        random_triangle(nearest, farthest);
        assert_int_equal(plane_setup(&plane, places, WIDTH, HEIGHT), 1);
        plane_setup_quadratic(&plane);
        if (!perspective_setup(&perspective, &in))
            continue;
        const int32_t depth[3] = {(uint16_t)given.place[0][VERTEX_DEPTH], (uint16_t)given.place[1][VERTEX_DEPTH],
                                  (uint16_t)given.place[2][VERTEX_DEPTH]};
        plane_linear(&plane, depth, &channel[0]);
        perspective_linear(&perspective, &plane, given.value, &channel[1]);
        perspective_quadratic(&perspective, &plane, given.value, given.bulge, &channel[2]);
        if (!channel[0].exact && !channel[2].exact)
            check_pixels(&plane, &perspective, channel, worst);
    }
    print_message("1/w %d..%d: linear off by at most %.4f of 1/256, quadratic by %.4f\n", farthest, nearest, worst[0],
                  worst[1]);
    assert_true(worst[0] < most && worst[1] < most && worst[1] > 0);
}

/* As near as a step from it: what is divided by W is never divided by 0. */
static void a_corner_on_the_far_plane_is_a_step_before_it(void **state)
{
    struct shade_input in = {.divides = 1, .place = {places[0], places[1], places[2]}};
    (void)state;
    for (int on = 0; on < 3; on++)
        for (int depth = DEPTH_FAR + 2; depth < DEPTH_NEAR; depth += depth / 2) {
            struct perspective perspective;
            for (int k = 0; k < 3; k++)
                given.place[k][VERTEX_DEPTH] = (int16_t)(uint16_t)(k == on ? DEPTH_FAR : depth);
            assert_int_equal(perspective_setup(&perspective, &in), 1);
            assert_in_range(perspective.s[(on + 1) % 3], 1 << 15, 65535);
            assert_int_equal(perspective.s[on], 1 << perspective.up);
            assert_int_equal(perspective.s[(on + 1) % 3], (depth - DEPTH_FAR) << perspective.up);
        }
}

static void numerators_over_the_depth_are_right_in_perspective(void **state)
{
    (void)state;
    check_depths(65000, 40000, 1 / 32.);
    check_depths(4000, 1000, 1 / 8.);
    check_depths(65000, 65000 / 17, 2);
}

/* By another power than the table its foot is 1 in Q14: what is below is 0. N.H less it passes -2 in Q30 below -32768,
 * or 256 before, for roundings. */
static void another_power_shows_from_its_foot_on_and_is_deep_below_minus_two(void **state)
{
    static struct fx_power power;
    struct surface surface = {.power = &power, .channels = 1, .lights = 1, .highlights = 1};
    const struct shade_input in = {.surface = &surface};
    (void)state;
    fx_power_build(&power, 20);
    for (int32_t low = -33100; low < -32000; low++)
        for (int32_t bend = 0; bend < 3; bend++)
            for (int32_t top = 0; top < 4; top++) {
                const int deep = low - bend - 1 < -32768 + 256;
                struct shade_setup setup = {.runs_only = 0};
                uint32_t error;
                const int shows = dots_show(&setup, &in, 0, 1, (struct bounds){low, top - bend}, bend, 1, &error);
                assert_int_equal(shows, top >= 1);
                assert_int_equal(setup.runs_only, shows && deep);
            }
}

/* Far lights on a triangle without bends: N.L and N.H of its corners. */
static void set_up_far(struct shade_setup *setup, const struct surface *surface, int16_t lights[3][2], uint32_t stretch)
{
    static const int16_t corner[3][3] = {{-800, -800, 0}, {800, -800, 0}, {0, 800, 0}};
    const struct object_state object = {.local = 0};
    const struct dots_factors factors = {.edge = {65536, 65536, 65536}, .stretch = stretch};
    const struct shade_input in = {.place = {corner[0], corner[1], corner[2]},
                                   .lights = {lights[0], lights[1], lights[2]},
                                   .object = &object,
                                   .surface = surface};
    *setup = (struct shade_setup){.runs_only = 0};
    assert_int_equal(plane_setup(&setup->plane, in.place, WIDTH, HEIGHT), 1);
    dots_setup(setup, &in, &factors, NULL);
}

static void a_matt_surface_has_no_highlight(void **state)
{
    static struct fx_power power;
    struct surface surface = {.power = &power, .channels = 1, .lights = 1};
    int16_t lights[3][2] = {{8000, 16384}, {9000, 16384}, {10000, 16384}};
    struct shade_setup setup;
    (void)state;
    fx_power_build(&power, 20);
    for (int shiny = 0; shiny < 2; shiny++) {
        surface.highlights = (uint8_t)shiny;
        set_up_far(&setup, &surface, lights, 65536);
        assert_int_equal(setup.diffuse_lights, 1);
        assert_int_equal(setup.specular_lights, shiny);
    }
}

/* The table of the first power begins at 0: N.H of -1 is within [-2, 2), twice that is not. */
static void a_highlight_below_zero_is_stretched_too(void **state)
{
    static struct fx_power power;
    const struct surface surface = {.power = &power, .channels = 1, .lights = 1, .highlights = 1};
    int16_t lights[3][2] = {{8000, -16384}, {9000, 16384}, {10000, 16384}};
    struct shade_setup setup;
    (void)state;
    fx_power_build(&power, 1);
    for (int times = 1; times <= 2; times++) {
        set_up_far(&setup, &surface, lights, 65536u * (uint32_t)times);
        assert_int_equal(setup.specular_lights, 1);
        assert_int_equal(setup.runs_only, times == 2);
    }
}

/* A linear channel that a polynomial holds does not take back that N.H leaves what a table's loop can index. */
static void a_planned_highlight_far_below_its_foot_goes_by_runs(void **state)
{
    static const int16_t corner[3][3] = {{-800, -800, 0}, {800, -800, 0}, {0, 800, 0}};
    static const struct shade_plan plan = {.rung = PLAN_LINEAR, .diffuse = 1, .specular = 1};
    static struct fx_power power;
    const struct surface surface = {.power = &power, .channels = 1, .lights = 1, .highlights = 1};
    int16_t lights[3][2] = {{8000, -16384}, {9000, 16384}, {10000, 16384}};
    const struct shade_input in = {.place = {corner[0], corner[1], corner[2]},
                                   .lights = {lights[0], lights[1], lights[2]},
                                   .surface = &surface,
                                   .plan = plan};
    (void)state;
    for (unsigned n = 1; n <= 1023; n += 1022) { /* the table begins at 0, or at 1 - 2^-7: 2 - 2^-6 below is above -1 */
        struct shade_setup setup = {.runs_only = 0};
        fx_power_build(&power, n);
        assert_int_equal(power.octave, n == 1 ? 0 : 7);
        assert_int_equal(plane_setup(&setup.plane, in.place, WIDTH, HEIGHT), 1);
        shade_planned(&setup, &in);
        assert_int_equal(setup.channel[1].exact, 0);
        assert_int_equal(setup.runs_only, n == 1023);
    }
}

/* X-shading leaves out the same bends under one light, and under two of which the second is behind. */
static void a_light_behind_the_triangle_bends_nothing(void **state)
{
    static const int16_t corner[3][3] = {{-800, -800, 0}, {800, -800, 0}, {0, 800, 0}};
    static struct fx_power power;
    int16_t lights[3][4] = {{8000, 0, -8000, 0}, {9000, 0, -8000, 0}, {10000, 0, -8000, 0}};
    int bent = 0;
    (void)state;
    fx_power_build(&power, 20);
    for (uint16_t bend = 0; bend < 400; bend++) {
        const struct scene_triangle triangle = {.bend = {bend, bend, bend}};
        const struct object_state object = {.local = 0};
        uint8_t quadratic[2];
        for (unsigned behind = 0; behind < 2; behind++) {
            const struct surface surface = {.power = &power,
                                            .channels = 1,
                                            .lights = (uint8_t)(1 + behind),
                                            .bend_limit = (uint8_t)(behind ? 64 : 128),
                                            .light = {{.diffuse_most = 255 << 8}, {.diffuse_most = 255 << 8}}};
            const struct shade_input in = {.place = {corner[0], corner[1], corner[2]},
                                           .lights = {lights[0], lights[1], lights[2]},
                                           .triangle = &triangle,
                                           .object = &object,
                                           .surface = &surface};
            struct shade_setup setup = {.runs_only = 0};
            assert_int_equal(plane_setup(&setup.plane, in.place, WIDTH, HEIGHT), 1);
            shade_x(&setup, &in);
            assert_int_equal(setup.diffuse_lights, 1);
            quadratic[behind] = setup.quadratic;
        }
        assert_int_equal(quadratic[0], quadratic[1]);
        bent += quadratic[0];
    }
    assert_in_range(bent, 1, 399);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_length_factor_is_one_over_the_root),
        cmocka_unit_test(the_bulges_bring_back_the_samples),
        cmocka_unit_test(bulges_that_32_bits_do_not_hold_are_saturated),
        cmocka_unit_test(bulges_of_a_piece_that_32_bits_do_not_hold_are_saturated),
        cmocka_unit_test(a_corner_on_the_far_plane_is_a_step_before_it),
        cmocka_unit_test(numerators_over_the_depth_are_right_in_perspective),
        cmocka_unit_test(another_power_shows_from_its_foot_on_and_is_deep_below_minus_two),
        cmocka_unit_test(a_matt_surface_has_no_highlight),
        cmocka_unit_test(a_highlight_below_zero_is_stretched_too),
        cmocka_unit_test(a_planned_highlight_far_below_its_foot_goes_by_runs),
        cmocka_unit_test(a_light_behind_the_triangle_bends_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Ranges that decide which loop draws, and what loops divide by, at their ends; and what a plan leaves out. */
#include "random.h"
#include "raster/raster.h"
#include "shade/x.c"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

/* Drawn without a clamp, all sums must be within the format: a step and more above 0, a step below 256, in Q7. */
static void what_is_drawn_without_a_clamp_stays_in_the_format(void **state)
{
    int plain = 0, wide = 0;
    (void)state;
    random_seed(81);
    for (int i = 0; i < 200000; i++) {
        struct shade_setup setup;
        struct surface surface = {.fold = (uint16_t)(i % 3 ? random_between(0, 65280) : random_between(0, 999))};
        surface.ambient = (uint16_t)random_between(0, 255 << 7);
        const int far = i % 8 == 0; /* up to 2 */
        const int32_t a = random_between(far ? 16500 : -16384, 18000), b = random_between(far ? 16500 : -16384, 18000),
                      bend = far ? random_between(14000, 16499) : random_between(0, i % 5 ? 3000 : 65535);
        const struct bounds range = {a < b ? a : b, a < b ? b : a};
        int32_t value[3] = {a, b, a};
        steps_take(&setup, &surface, range, bend, value, NULL);
        const double low = range.low - bend, high = range.high + bend, fold = surface.fold / 32768.;
        const int fits = low > 0 && high < 32768 && low * fold + surface.ambient > 128 &&
                         high * fold + surface.ambient < (255 << 7) - 1;
        assert_int_equal(setup.in_steps, 1);
        assert_true(fabs(value[1] - b * (surface.fold / 65536.)) <= .5);
        if (setup.plain) {
            assert_true(low > 0 && high < 32768 && low * fold + surface.ambient >= 128);
            assert_true(high * fold + surface.ambient < 255 << 7);
        } else {
            assert_false(fits);
            wide += low > 0 && high >= 32768;
        }
        plain += setup.plain;
    }
    assert_true(plain > 5000 && wide > 5000);
}

/* A normal shorter than 2^-9 counts as that long, a depth behind the far plane as a step before it. */
static void what_is_divided_by_is_never_0(void **state)
{
    static struct raster r;
    (void)state;
    r.width = r.height = 64;
    r.setup.perspective = 1;
    for (int i = 0; i < 64; i++) {
        const uint32_t step = 1u << 10;
        r.setup.depth = (struct channel){.p = {.f = (DEPTH_FAR << 16) + (uint32_t)(i - 32) * step * RUN, .d = step}};
        r.setup.channel[SHADE_SQUARE] = (struct channel){.p = {.f = (uint32_t)(i - 32) * 256 * RUN, .d = 256}};
        raster_divisors(&r, 0, 0, RUN);
        for (int x = 0; x < RUN; x++) {
            const double w = fmax((i - 32) * 1024. * RUN + 1024. * x, 65536) / 0x1p32; /* of the depth's scale */
            assert_true(fabs(r.divisor[x].half / 0x1p30 * exp2(r.divisor[x].up) * w - 1) < 0x1p-28);
        }
        raster_lengths(&r, 0, 0, RUN);
        for (int x = 0; x < RUN; x++) {
            const double square = fmax(((i - 32) * RUN + x) * 256., 4096) / 0x1p30;
            assert_true(fabs(r.divisor[x].half / 0x1p30 * exp2(r.divisor[x].up) * sqrt(square) - 1) < 0x1p-20);
        }
    }
}

/* N.H to the bit before 2 in Q14 times 2^octave from the power's foot, 256 for roundings less, whether it is there or
 * over .8: there it still fits, beyond it does not. */
static void a_highlight_is_wide_from_2_on(void **state)
{
    (void)state;
    for (uint16_t octave = 0; octave <= FX_POWER_MAX_OCTAVE; octave++) {
        const struct fx_power power = {.octave = octave};
        const int32_t foot = 16384 - (16384 >> octave);
        for (int32_t h = -32000; h <= 50000; h++) {
            const struct bounds low = {h, foot}, high = {foot, h};
            const double least = foot - (h < 0 ? floor(1.25 * h) : h), most = (32768 - 256) / exp2(octave);
            if (h <= foot)
                assert_int_equal(dots_wide(&power, low, 0), least > most);
            else
                assert_int_equal(dots_wide(&power, high, 0), h - foot > most);
        }
    }
}

/* What a plan takes of one light, in a triangle across the picture. */
struct planned_case {
    struct scene_triangle triangle;
    struct fx_power power;
    struct surface surface;
    struct object_state object;
    int16_t place[3][VERTEX_LIGHTS], lights[3][2];
    struct shade_input in;
    struct shade_setup setup;
};

static void open_planned(struct planned_case *c, unsigned exponent)
{
    static const int16_t corner[3][2] = {{0, 0}, {800, 40}, {100, 700}};
    memset(c, 0, sizeof *c);
    fx_power_build(&c->power, exponent);
    c->surface.power = &c->power;
    c->surface.lights = c->surface.highlights = c->surface.channels = 1;
    for (int k = 0; k < 3; k++) {
        c->place[k][0] = corner[k][0];
        c->place[k][1] = corner[k][1];
        c->place[k][VERTEX_DEPTH] = (int16_t)(DEPTH_FAR + 9000 + 1000 * k);
        c->in.place[k] = c->place[k];
        c->in.lights[k] = c->lights[k];
    }
    c->in.triangle = &c->triangle;
    c->in.surface = &c->surface;
    c->in.object = &c->object;
    assert_true(plane_setup(&c->setup.plane, c->in.place, 64, 64));
}

/* A linear N.H is off by its roundings, 2 units of Q14, wherever a corner's is. */
static void a_linear_highlight_is_wide_with_its_roundings(void **state)
{
    struct planned_case c;
    int wide = 0;
    (void)state;
    open_planned(&c, 20);
    for (int16_t low = -16384; low < 0; low++) {
        c.in.plan = (struct shade_plan){.rung = PLAN_LINEAR};
        c.in.plan.specular = 1;
        c.lights[0][1] = low;
        c.setup.found[0] = c.setup.found[1] = c.setup.found[2] = 0;
        shade_planned(&c.setup, &c.in);
        const int32_t foot = 16384 - (16384 >> c.power.octave);
        const double most = (32768 - 256) / exp2(c.power.octave);
        assert_int_equal(c.setup.wide, foot - floor(1.25 * (low - 2)) > most);
        wide += c.setup.wide;
    }
    assert_in_range(wide, 1000, 16000);
}

/* The table of reciprocal lengths holds SHADE_LENGTH_SUM itself: between two normals a quarter of the bend. */
static void lengths_are_tabled_up_to_the_largest_sum(void **state)
{
    struct planned_case c;
    (void)state;
    open_planned(&c, 20);
    c.surface.fold = 1;
    for (int e = 0; e < 3; e++)
        for (uint16_t bend = 16000; bend < 16384; bend++) {
            memset(c.triangle.bend, 0, sizeof c.triangle.bend);
            c.triangle.bend[e] = bend;
            assert_int_equal(duff_direct(&c.setup, &c.in), bend / 4 + 1 <= SHADE_LENGTH_SUM);
        }
}

/* Of light 0 in perspective: the channel of its highlight is not touched. */
static void a_highlight_that_is_left_out_is_not_set_up(void **state)
{
    (void)state;
    for (int shines = 0; shines < 2; shines++) {
        struct planned_case c;
        open_planned(&c, 20);
        c.in.divides = 1;
        c.in.plan.rung = PLAN_DUFF;
        c.in.plan.diffuse = 1;
        c.in.plan.specular = (uint8_t)shines;
        c.lights[0][1] = c.lights[1][1] = -16384;
        shade_planned_duff(&c.setup, &c.in);
        assert_int_equal(c.setup.wide, shines);
        assert_int_equal(c.setup.channel[1].p.f != 0, shines);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_drawn_without_a_clamp_stays_in_the_format),
        cmocka_unit_test(what_is_divided_by_is_never_0),
        cmocka_unit_test(a_highlight_is_wide_from_2_on),
        cmocka_unit_test(a_linear_highlight_is_wide_with_its_roundings),
        cmocka_unit_test(lengths_are_tabled_up_to_the_largest_sum),
        cmocka_unit_test(a_highlight_that_is_left_out_is_not_set_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

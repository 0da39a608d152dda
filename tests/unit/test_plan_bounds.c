/* SPDX-License-Identifier: MIT */
/* What a plan promises of a triangle holds: random triangles, materials, lights and budgets (plan_case.h). */
#include "plan/parts.h"
#include "plan_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static const double widest[] = {20, 45, 90, 170}; /* degrees between normals */

static const char *const rung_names[PLAN_RUNGS] = {"dark", "constant", "gouraud", "linear", "six", "duff", "phong"};

static struct plan_case_counts run(double share)
{
    struct plan_case_counts counts = {0};
    random_seed(7);
    for (size_t i = 0; i < sizeof widest / sizeof *widest; i++)
        plan_case_run(&counts, widest[i], 25000, 12, share);
    return counts;
}

static void no_pixel_is_off_by_more_than_its_plan_says(void **state)
{
    (void)state;
    const struct plan_case_counts counts = run(1);
    for (int r = 0; r < PLAN_PHONG; r++) {
        print_message("%-8s %6lu planned, %lu beyond; the worst error is %.2f of its bound\n", rung_names[r],
                      counts.planned[r], counts.beyond[r], counts.closest[r]);
        assert_true(counts.planned[r] > 100);
        assert_int_equal(counts.beyond[r], 0);
    }
}

/* The same triangles would find a bound that is wrong by a tenth. */
static void smaller_bounds_would_be_seen_to_fail(void **state)
{
    (void)state;
    const struct plan_case_counts counts = run(.9);
    for (int r = PLAN_CONSTANT; r <= PLAN_SIX; r++)
        assert_true(counts.beyond_most[r] > 0);
}

/* Whole and less: rounded up by one at most; what is more than whole is no more. */
static void a_part_of_a_coefficient_is_rounded_up(void **state)
{
    (void)state;
    random_seed(8);
    for (int i = 0; i < 100000; i++) {
        const uint32_t coefficient = (uint32_t)random_between(0, 65280);
        const int32_t part = i % 4 ? random_between(0, 16384) : random_between(16384, 16416);
        const double exact = coefficient * fmin(1, part / 16384.), is = parts_scaled(coefficient, part);
        assert_true(is > exact && is <= exact + 1);
    }
}

/* From the table's foot on, itself included; .29/255 is the table's own error (fixed.h), a unit of Q15 the rounding. */
static void a_power_begins_at_its_foot(void **state)
{
    (void)state;
    for (unsigned n = 1; n <= FX_POWER_MAX_EXPONENT; n++) {
        struct fx_power power;
        fx_power_build(&power, n);
        const struct plan_surface surface = {.power = &power, .foot = (int16_t)(16384 - (16384 >> power.octave))};
        for (int32_t h = surface.foot; h <= 16384; h += h < surface.foot + 4 ? 1 : 61)
            assert_true(fabs(parts_power(&surface, h) / 32768. - pow(h / 16384., n)) < .29 / 255 + 1 / 32768.);
        assert_int_equal(parts_power(&surface, surface.foot - 1), 0);
    }
}

/* The table's power, by straight lines from step to step of 128, of a part; of exponents whose table begins at 0. */
static double shine_of(const struct fx_power *power, double specular, double h)
{
    const double at = fmax(h, 0) / 128;
    const uint16_t *v = &power->value[(int)at];
    return specular * (v[0] + (v[1] - v[0]) * (at - floor(at))) / 32768;
}

/* From a corner that faces the other way to one where it just shows, its chord is above it by no more than what is said
 * and a unit of 1/256: at one of the table's steps it is so most. */
static void a_chord_to_the_dark_side_is_not_further_above_a_highlight(void **state)
{
    (void)state;
    for (unsigned n = 2; n < 10; n++) {
        struct fx_power power;
        fx_power_build(&power, n);
        const struct plan_surface surface = {.power = &power};
        assert_int_equal(power.octave, 0);
        for (int32_t high = 1; high <= 16384; high += high < 5461 ? 1 : 97) {
            const struct curve_values v = {.high = high, .middle = -16384, .low = -16384};
            const double bound = parts_shine_gap(&surface, 65280, &v), last = shine_of(&power, 65280, high);
            for (int32_t h = 0; h < high; h += 128)
                assert_true(last * (h + 16384) / (high + 16384) - shine_of(&power, 65280, h) < bound + 1);
        }
    }
}

/* Depths of next to nothing, whose ratio is not known: all that there is. */
static void perspective_moves_all_where_a_corner_is_next_to_infinity(void **state)
{
    int16_t record[3][VERTEX_LIGHTS] = {{0}};
    (void)state;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            record[i][VERTEX_DEPTH] = (int16_t)(uint16_t)(DEPTH_FAR + (i == k ? 200 : 40000));
        assert_int_equal(plan_shift((const int16_t *const[3]){record[0], record[1], record[2]}), 65536);
    }
}

/* A triangle without bends, whose corners have these N.L (Q14) of each of some lights that have no highlights. */
static void open_matt(struct plan_case *c, unsigned lights, uint16_t diffuse, const int16_t dot[3])
{
    memset(c, 0, sizeof *c);
    fx_power_build(&c->power, 20);
    c->surface = (struct plan_surface){.power = &c->power,
                                       .budget = 2 * 256,
                                       .lights = (uint8_t)lights,
                                       .duff_sum = 65535,
                                       .full = 65535,
                                       .foot = (int16_t)(16384 - (16384 >> c->power.octave))};
    for (unsigned l = 0; l < lights; l++)
        c->surface.light[l].diffuse = diffuse;
    for (int k = 0; k < 3; k++) {
        for (unsigned l = 0; l < lights; l++)
            c->record[k][VERTEX_LIGHTS + 2 * l] = dot[k];
        c->triangle.lights[k] = c->record[k] + VERTEX_LIGHTS;
    }
    c->triangle.bend = c->packed_bend;
}

/* 100 of 255 at the brightest corner: what the clamp takes there is missing beside it, and may be within the budget. */
static void finished_colours_may_be_clamped_by_the_budget_alone(void **state)
{
    static const int16_t dot[3] = {16384, 8192, 4096};
    struct plan_case c;
    struct shade_plan plan;
    (void)state;
    open_matt(&c, 1, 100 * 256, dot);
    c.surface.full = 99 * 256;
    plan_triangle(&plan, &c.surface, &c.triangle);
    assert_int_equal(plan.rung, PLAN_GOURAUD);
    assert_in_range(plan.error, 256, 2 * 256);
    c.surface.full = 98 * 256 - 1;
    plan_triangle(&plan, &c.surface, &c.triangle);
    assert_int_equal(plan.rung, PLAN_LINEAR);
}

/* Before a texel is known nothing may be clamped: two lights of 100, each rounded up, may add just what there is room
 * for. */
static void what_just_fits_is_finished_before_its_texel(void **state)
{
    static const int16_t dot[3] = {16384, 16384, 16384};
    struct plan_case c;
    struct shade_plan plan;
    (void)state;
    open_matt(&c, 2, 100 * 256, dot);
    c.surface.apart = 1;
    c.surface.full = 2 * (100 * 256 + 1);
    plan_triangle(&plan, &c.surface, &c.triangle);
    assert_int_equal(plan.rung, PLAN_CONSTANT);
    c.surface.full--;
    plan_triangle(&plan, &c.surface, &c.triangle);
    assert_int_equal(plan.rung, PLAN_LINEAR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pixel_is_off_by_more_than_its_plan_says),
        cmocka_unit_test(smaller_bounds_would_be_seen_to_fail),
        cmocka_unit_test(a_part_of_a_coefficient_is_rounded_up),
        cmocka_unit_test(a_power_begins_at_its_foot),
        cmocka_unit_test(a_chord_to_the_dark_side_is_not_further_above_a_highlight),
        cmocka_unit_test(perspective_moves_all_where_a_corner_is_next_to_infinity),
        cmocka_unit_test(finished_colours_may_be_clamped_by_the_budget_alone),
        cmocka_unit_test(what_just_fits_is_finished_before_its_texel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

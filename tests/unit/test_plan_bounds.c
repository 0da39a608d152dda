/* SPDX-License-Identifier: MIT */
/* What a plan promises of a triangle holds: random triangles, materials, lights and budgets (plan_case.h). */
#include "plan/parts.h"
#include "plan_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>

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

/* The table's chords are of one curve: where one ends the next begins. */
static void chords_meet_where_they_join(void **state)
{
    static const int32_t joint[] = {1, 2, 4};
    (void)state;
    for (int b = 0; b < CURVE_BANDS; b++)
        for (int i = 0; i < 3; i++) {
            const struct curve_line *line = curve_bands[b].line + i;
            assert_true(abs(line[0].alpha + line[0].beta * joint[i] - line[1].alpha - line[1].beta * joint[i]) <= 4);
        }
}

/* A dot product of unit vectors, whatever a corner's may be off by. */
static void no_true_value_is_above_1(void **state)
{
    (void)state;
    for (unsigned most = 0; most <= CURVE_MOST_BEND; most += most < 64 ? 1 : 499) {
        const uint16_t bend[3] = {(uint16_t)most, (uint16_t)(most / 2), 0};
        struct curve curve;
        curve_setup(&curve, bend);
        for (int32_t high = 16000; high <= 16384; high++) {
            struct curve_values v = curve_values(high, high, -high);
            curve_bound(&curve, &v);
            assert_in_range(v.top, high, 16384);
        }
    }
}

/* A quarter of what the ratio of closenesses is above 1, each rounded either way; at most all. */
static void perspective_moves_by_the_ratio_of_depths(void **state)
{
    int16_t record[3][VERTEX_LIGHTS] = {{0}};
    (void)state;
    random_seed(9);
    for (int i = 0; i < 100000; i++) {
        const int32_t near = random_between(256, 65000 - DEPTH_FAR),
                      far = random_between(near / 8 > 256 ? near / 8 : 256, near);
        for (int k = 0; k < 3; k++)
            record[k][VERTEX_DEPTH] = (int16_t)(uint16_t)(DEPTH_FAR + (k == i % 3 ? near : far));
        const double shift = plan_shift((const int16_t *const[3]){record[0], record[1], record[2]});
        assert_true(shift >= fmin(65536, (near - far) * 16384. / far));
        assert_true(shift <= fmin(65536, (near - far + 1) * 16384. / (far - 1) + 1));
    }
}

/* Of the first light, where dot products are computed at all: what is hidden of it is, too; of others it is not. */
static void what_is_kept_is_the_first_lights(void **state)
{
    static const uint8_t rungs[] = {PLAN_DARK, PLAN_LINEAR, PLAN_SIX, PLAN_DUFF};
    (void)state;
    for (size_t i = 0; i < sizeof rungs; i++) {
        struct shade_plan plan = {.rung = rungs[i]};
        plan.hidden_lights = plan.hidden_highlights = 3;
        plan_keep(&plan);
        assert_int_equal(plan.rung, rungs[i] == PLAN_DARK ? PLAN_LINEAR : rungs[i]);
        assert_int_equal(plan.diffuse, 1);
        assert_int_equal(plan.specular, 1);
    }
}

/* A ninth of 8 times the gap in the middle and 4 times that at the third quarter, or what lies beyond both: 3 is added
 * to each gap, and the ninth rounded up by less than 3. */
static void a_highlights_gap_is_the_larger_of_its_two_bounds(void **state)
{
    (void)state;
    for (unsigned n = 2; n < 10; n++) {
        struct fx_power power;
        fx_power_build(&power, n);
        const struct plan_surface surface = {.power = &power};
        for (int32_t high = 4096; high <= 16384; high += 128) {
            const struct curve_values v = {.high = high};
            const double last = parts_shine(&surface, 65280, high),
                         half = last / 2 - parts_shine(&surface, 65280, high / 2),
                         quarter = last * 3 / 4 - parts_shine(&surface, 65280, high * 3 / 4),
                         wanted = fmax((8 * half + 4 * quarter) / 9, 2 * quarter - half),
                         bound = parts_shine_gap(&surface, 65280, &v);
            assert_true(bound >= wanted && bound < wanted + 3 * 12 / 9. + 3);
        }
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
        cmocka_unit_test(chords_meet_where_they_join),
        cmocka_unit_test(no_true_value_is_above_1),
        cmocka_unit_test(perspective_moves_by_the_ratio_of_depths),
        cmocka_unit_test(what_is_kept_is_the_first_lights),
        cmocka_unit_test(a_highlights_gap_is_the_larger_of_its_two_bounds),
        cmocka_unit_test(finished_colours_may_be_clamped_by_the_budget_alone),
        cmocka_unit_test(what_just_fits_is_finished_before_its_texel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

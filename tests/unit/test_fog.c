/* SPDX-License-Identifier: MIT */
/* The fog's part of a pixel against its formula, and the bounds by which a
 * triangle's corners stand for its pixels. */
#include "plan/fog.h"
#include "random.h"
#include "raster/fogged.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#define DEPTHS 65519.

static void powers_of_two_fall_as_they_should(void **state)
{
    double most = 0;
    (void)state;
    for (uint32_t x = 0; x < 20u << 16; x++)
        most = fmax(most, fabs(fx_exp2_minus(x) - 65536 * exp2(-(double)x / 65536)));
    assert_true(most < 7.5);
    assert_int_equal(fx_exp2_minus(0), 65536);
    assert_int_equal(fx_exp2_minus(1u << 16), 32768);
    assert_int_equal(fx_exp2_minus(17u << 16), 1); /* a half, rounded up */
    assert_int_equal(fx_exp2_minus(18u << 16), 0);
    assert_int_equal(fx_exp2_minus(UINT32_MAX), 0);
}

/* A picture's distances and its fog. */
struct view_case {
    struct scene_header scene;
    struct fog fog;
    double near, far, from, to, density;
};

static void open_view(struct view_case *v, int perspective, int kind, double near, double far, double a, double b)
{
    struct scene_header *s = &v->scene;
    memset(v, 0, sizeof *v);
    s->camera.kind = perspective ? CAMERA_PERSPECTIVE : CAMERA_ORTHOGRAPHIC;
    s->camera.near_plane = (q16_t)lrint(near * 65536);
    s->camera.far_plane = (q16_t)lrint(far * 65536);
    s->fog.kind = (uint16_t)kind;
    if (kind == FOG_LINEAR) {
        s->fog.from = (q16_t)lrint(a * 65536);
        s->fog.to = (q16_t)lrint(b * 65536);
    } else {
        s->fog.density = (uint32_t)lrint(a * 0x1p24);
    }
    v->near = s->camera.near_plane / 65536.;
    v->far = s->camera.far_plane / 65536.;
    v->from = s->fog.from / 65536.;
    v->to = s->fog.to / 65536.;
    v->density = ldexp(s->fog.density, -24);
    fog_begin(&v->fog, s);
}

static void open_random(struct view_case *v)
{
    const double near = exp(random_real(-3, 3)), far = near * exp(random_real(.1, 5));
    const int perspective = random_between(0, 1), kind = random_between(FOG_LINEAR, FOG_EXPONENTIAL);
    const double a = near + (far - near) * random_real(-.1, .8);
    if (kind == FOG_LINEAR)
        open_view(v, perspective, kind, near, far, fmax(a, 0), fmax(a, 0) + (far - near) * exp(random_real(-4, 1)));
    else
        open_view(v, perspective, kind, near, far, fmin(16, exp(random_real(-3, 3)) / (far - near)), 0);
}

static double distance_of(const struct view_case *v, double closeness)
{
    if (v->scene.camera.kind == CAMERA_PERSPECTIVE)
        return v->near * DEPTHS / closeness;
    return v->far - (v->far - v->near) * closeness / DEPTHS;
}

static double part_at(const struct view_case *v, double distance)
{
    if (v->scene.fog.kind == FOG_LINEAR)
        return fmin(1, fmax(0, (distance - v->from) / (v->to - v->from)));
    return 1 - exp(-v->density * distance);
}

/* The depth of a distance as the transform has it, or a little nearer. */
static double closeness_at(const struct view_case *v, double distance)
{
    if (v->scene.camera.kind == CAMERA_PERSPECTIVE)
        return v->near / distance * DEPTHS;
    return (v->far - distance) / (v->far - v->near) * DEPTHS;
}

static double random_distance(const struct view_case *v)
{
    const double t = random_fraction();
    return random_fraction() < .5 ? v->near * pow(v->far / v->near, t) : v->near + t * (v->far - v->near);
}

static void a_part_is_its_formula_within_what_is_written(void **state)
{
    (void)state;
    random_seed(1);
    for (int i = 0; i < 3000; i++) {
        struct view_case v;
        open_random(&v);
        for (int j = 0; v.fog.kind && j < 200; j++) {
            const double z = random_distance(&v);
            /* rounded down twice in perspective, as project.h does */
            double closeness = closeness_at(&v, z);
            closeness =
                v.fog.divides ? floor(floor(z > 0 ? v.near / z * 65536 : 0) * DEPTHS / 65536) : floor(closeness);
            const double is = fog_part(&v.fog, (uint32_t)(DEPTH_FAR + fmax(closeness, 0)) << 16) / 65536.;
            const double most = (v.fog.error + 1) / 65536.;
            if (fabs(is - part_at(&v, z)) > most)
                fail_msg("view %d at %.4f of %.3f to %.3f: %.5f, not %.5f +- %.5f", i, z, v.near, v.far, is,
                         part_at(&v, z), most);
        }
    }
}

static void the_error_written_is_nearly_reached(void **state)
{
    struct view_case v;
    double most = 0;
    (void)state;
    open_view(&v, 1, FOG_LINEAR, 1, 200, 10, 100);
    for (int i = 0; i < 100000; i++) {
        const double z = 10 + 90 * i / 100000.;
        const double depth = DEPTH_FAR + floor(floor(1 / z * 65536) * DEPTHS / 65536);
        most = fmax(most, fabs(fog_part(&v.fog, (uint32_t)depth << 16) / 65536. - part_at(&v, z)));
    }
    print_message("z 10 to 100, near 1: off by %.2f of 1/255; written %.2f\n", most * 255, v.fog.error / 65536. * 255);
    assert_true(most * 65536 > v.fog.error * .5 && most * 65536 < v.fog.error);
}

/* Corners of a triangle at some distances, a few apart or many. */
static void random_depths(const struct view_case *v, int32_t depth[3])
{
    const double z = random_distance(v), spread = exp(random_real(-6, 0));
    for (int k = 0; k < 3; k++) {
        const double at = fmin(v->far, fmax(v->near, z * (1 + spread * random_real(-1, 1))));
        depth[k] = DEPTH_FAR + (int32_t)closeness_at(v, at);
    }
}

static const char *const names[FOGGED_KINDS] = {"not", "evenly", "linearly", "by run", "by pixel", "wholly"};

/* What a pixel with these barycentric coordinates gets, from the plan. */
static double planned(const struct view_case *v, const struct fog_plan *plan, const int32_t depth[3],
                      const double at[3])
{
    double value = 0, between = 0;
    for (int k = 0; k < 3; k++) {
        value += at[k] * plan->part[k] / 16384.;
        between += at[k] * depth[k];
    }
    return plan->kind == FOGGED_BY_PIXEL ? fog_part(&v->fog, (uint32_t)(between * 65536)) / 65536. : value;
}

/* Against the formula at the depth interpolated: the roundings of the depths
 * themselves are fog.error's. */
static void a_plan_is_within_its_error(void **state)
{
    static const uint32_t allowances[] = {0, 8, 64, 257, 2048, 16384};
    unsigned count[FOGGED_KINDS] = {0};
    double reached = 0;
    (void)state;
    random_seed(2);
    for (int i = 0; i < 60000; i++) {
        struct view_case v;
        struct fog_plan plan;
        int32_t depth[3];
        open_random(&v);
        if (!v.fog.kind)
            continue;
        random_depths(&v, depth);
        fog_choose(&v.fog, depth, allowances[i % 6], 0, &plan);
        count[plan.kind]++;
        const double most = (plan.error + 3) / 65536.;
        for (int j = 0; j < 30; j++) {
            double at[3] = {random_fraction(), random_fraction(), 0}, closeness = 0;
            if (at[0] + at[1] > 1)
                at[0] = 1 - at[0], at[1] = 1 - at[1];
            if (j % 3 == 0) /* an edge */
                at[0] = 1 - at[1];
            at[2] = 1 - at[0] - at[1];
            for (int k = 0; k < 3; k++)
                closeness += at[k] * (depth[k] - DEPTH_FAR + (v.fog.divides ? 1 : .5));
            const double is = planned(&v, &plan, depth, at);
            const double error = fabs(is - part_at(&v, distance_of(&v, closeness)));
            if (error > most)
                fail_msg("triangle %d, %s: off by %.2f of 1/255, not %.2f", i, names[plan.kind], error * 255,
                         most * 255);
            if (plan.kind == FOGGED_LINEARLY && plan.error > v.fog.error + 200u)
                reached = fmax(reached, error / most);
            assert_true((1 - is) * 65536 <= plan.shown + 8. + most * 65536);
        }
    }
    for (int k = 0; k < FOGGED_KINDS; k++)
        print_message("%s: %u\n", names[k], count[k]);
    print_message("up to %.2f of the bound\n", reached);
    for (int k = 0; k < FOGGED_KINDS; k++)
        assert_true(k == FOGGED_BY_RUN || count[k] > 500); /* that is decided later */
    assert_true(reached > .9);
}

/* The part between a run's ends, in a triangle of such depths. */
static void a_run_is_within_its_error(void **state)
{
    double reached = 0;
    unsigned count = 0;
    (void)state;
    random_seed(4);
    for (int i = 0; i < 60000; i++) {
        struct view_case v;
        int32_t depth[3], low, high;
        open_random(&v);
        if (!v.fog.kind)
            continue;
        random_depths(&v, depth);
        low = depth[0] < depth[1] ? depth[0] : depth[1];
        low = depth[2] < low ? depth[2] : low;
        high = depth[0] > depth[1] ? depth[0] : depth[1];
        high = depth[2] > high ? depth[2] : high;
        const double step = (high - low) * random_fraction();
        const uint32_t error = fog_run_error(&v.fog, depth, (uint32_t)ceil(step * 65536));
        const double from = low + (high - low - step) * random_fraction(), to = from + step;
        const double first = fog_part(&v.fog, (uint32_t)(from * 65536)),
                     last = fog_part(&v.fog, (uint32_t)(to * 65536));
        for (int j = 1; j < 8; j++) {
            const double t = j / 8., at = from + t * step;
            const double off = fabs(first + t * (last - first) - fog_part(&v.fog, (uint32_t)(at * 65536)));
            if (off > error + 16) /* roundings of the parts themselves */
                fail_msg("run %d: off by %.1f, not %u", i, off, error);
            if (error > 200 && error < 65536) {
                reached = fmax(reached, off / error);
                count++;
            }
        }
    }
    print_message("up to %.2f of the bound, %u\n", reached, count);
    assert_true(count > 10000 && reached > .8);
}

static void what_is_left_out_cannot_show(void **state)
{
    (void)state;
    random_seed(3);
    for (int i = 0; i < 30000; i++) {
        struct view_case v;
        struct fog_plan plan, all;
        int32_t depth[3];
        open_random(&v);
        if (!v.fog.kind)
            continue;
        random_depths(&v, depth);
        fog_choose(&v.fog, depth, 64, 0, &plan);
        fog_choose(&v.fog, depth, 64, 1, &all);
        for (int k = 0; k < 3; k++)
            assert_int_equal(plan.part[k], all.part[k]);
        if (plan.kind != FOGGED_NOT && plan.kind != FOGGED_WHOLLY) {
            assert_int_equal(plan.kind, all.kind);
            continue;
        }
        assert_int_equal(all.kind, FOGGED_EVENLY);
        assert_int_equal(plan.part[0], plan.kind == FOGGED_NOT ? 0 : 16384);
    }
}

/* What auto's plan may err by, as far as it shows, and what the fog does:
 * together the budget. */
static void the_budget_is_divided_not_passed(void **state)
{
    static struct raster r;
    unsigned more = 0;
    (void)state;
    random_seed(5);
    for (int i = 0; i < 100000; i++) {
        r.fog.kind = FOG_LINEAR;
        r.fog_plan.kind = (uint8_t)random_between(FOGGED_EVENLY, FOGGED_BY_PIXEL);
        r.fog_plan.shown = (uint32_t)random_between(0, 65536) >> random_between(0, 8);
        r.fog_plan.error = (uint32_t)random_between(0, 500);
        r.plan_budget = (uint16_t)random_between(0, 8192);
        r.fog_allowed = r.plan_budget / 4;
        const double own = fogged_budget(&r) * (r.fog_plan.shown / 65536.);
        const double fog = r.fog_plan.error + (double)r.fog_allowed;
        if (own > 0 && own + fog > r.plan_budget)
            fail_msg("%.1f and %.1f of %d", own, fog, r.plan_budget);
        more += fogged_budget(&r) > r.plan_budget;
    }
    assert_true(more > 10000);
    r.fog_plan.kind = FOGGED_NOT;
    assert_int_equal(fogged_budget(&r), r.plan_budget);
}

static void fog_behind_the_far_plane_is_none(void **state)
{
    struct view_case v;
    (void)state;
    open_view(&v, 1, FOG_LINEAR, 1, 50, 50.5, 60);
    assert_int_equal(v.fog.kind, FOG_NONE);
    open_view(&v, 0, FOG_LINEAR, 1, 50, 51, 60);
    assert_int_equal(v.fog.kind, FOG_NONE);
    for (int perspective = 0; perspective < 2; perspective++) { /* at the far plane it is still nothing */
        open_view(&v, perspective, FOG_LINEAR, 1, 50, 50, 60);
        assert_int_equal(v.fog.kind, FOG_NONE);
    }
    open_view(&v, 1, FOG_LINEAR, 1, 50, 40, 60);
    assert_int_equal(v.fog.kind, FOG_LINEAR);
}

/* From `clear` on there is no fog, that depth included, whichever corner has it. */
static void a_corner_where_the_fog_begins_has_none(void **state)
{
    (void)state;
    for (int perspective = 0; perspective < 2; perspective++)
        for (int k = 0; k < 3; k++) {
            struct view_case v;
            struct fog_plan plan;
            open_view(&v, perspective, FOG_LINEAR, 1, 50, 10, 40);
            int32_t depth[3] = {v.fog.clear + 5, v.fog.clear + 5, v.fog.clear + 5};
            depth[k] = v.fog.clear;
            fog_choose(&v.fog, depth, 0, 0, &plan);
            assert_int_equal(plan.kind, FOGGED_NOT);
            assert_int_equal(plan.error, 0);
            assert_int_equal(plan.shown, 65536);
        }
}

/* From a wall of fog to the thinnest there is: no overflow, and still between
 * nothing and all. */
static void extremes_are_drawn(void **state)
{
    static const double nears[] = {1. / 256, 1, 32766}, fogs[][2] = {{0, 1. / 65536}, {0, 32767}, {32766, 32766.1}};
    (void)state;
    for (int perspective = 0; perspective < 2; perspective++)
        for (int n = 0; n < 3; n++)
            for (int i = 0; i < 6; i++) {
                struct view_case v;
                if (i < 3)
                    open_view(&v, perspective, FOG_LINEAR, nears[n], 32767, fogs[i][0], fogs[i][1]);
                else
                    open_view(&v, perspective, FOG_EXPONENTIAL, nears[n], 32767, i == 3 ? 16 : i == 4 ? 1 : 0x1p-24, 0);
                uint32_t before = 65536;
                for (uint32_t depth = DEPTH_FAR; v.fog.kind && depth <= DEPTH_NEAR; depth++) {
                    const uint32_t part = fog_part(&v.fog, depth << 16);
                    assert_true(part <= before + 1 && part <= 65536);
                    before = part;
                }
                if (i == 0 || i == 3)
                    assert_int_equal(fog_part(&v.fog, DEPTH_FAR << 16), 65536);
            }
}

/* Without perspective the part is linear, so that a triangle that leaves the fog at either end is off by no more than
 * it reaches beyond: a hundredth of what there is between. */
static void what_reaches_a_little_beyond_is_off_by_that(void **state)
{
    static const double distances[2][3] = {{46, 58.5, 71.5}, {20.5, 33.5, 46}};
    (void)state;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++) {
            struct view_case v;
            struct fog_plan plan;
            int32_t depth[3];
            open_view(&v, 0, FOG_LINEAR, 1, 101, 21, 71);
            for (int j = 0; j < 3; j++)
                depth[j] = DEPTH_FAR + (int32_t)closeness_at(&v, distances[i][(j + k) % 3]);
            fog_choose(&v.fog, depth, 700, 0, &plan);
            assert_int_equal(plan.kind, FOGGED_LINEARLY);
            assert_in_range(plan.error, v.fog.error + 653, v.fog.error + 658); /* 655.36; a depth is 2 */
        }
}

/* u of 0 to 3 * 2^-16: too little for a bow, which is then all that u changes
 * by. */
static void the_least_fog_there_is_is_planned_within_its_error(void **state)
{
    unsigned count[FOGGED_KINDS] = {0};
    (void)state;
    random_seed(6);
    for (int i = 0; i < 20000; i++) {
        struct view_case v;
        struct fog_plan plan;
        int32_t depth[3];
        if (i % 3 == 0)
            open_view(&v, 1, FOG_LINEAR, 1. / 256, 32767, 0, 32767);
        else if (i % 3 == 1)
            open_view(&v, 1, FOG_EXPONENTIAL, 1. / 256, 32767, 0x1p-17, 0);
        else /* half a step of depth behind the eye */
            open_view(&v, 0, FOG_EXPONENTIAL, 1. / 256, 16384, .01, 0);
        for (int k = 0; k < 3; k++)
            depth[k] = v.fog.divides ? DEPTH_FAR + (int32_t)random_magnitude(20, 65519)
                                     : DEPTH_NEAR - random_between(0, 60) * (k > 0);
        fog_choose(&v.fog, depth, v.fog.divides ? 0 : 64, 0, &plan);
        count[plan.kind]++;
        for (int j = 0; j < 30; j++) {
            const double a = random_fraction(), b = random_fraction() * (1 - a), at[3] = {a, b, 1 - a - b};
            const double closeness =
                at[0] * depth[0] + at[1] * depth[1] + at[2] * depth[2] - DEPTH_FAR + (v.fog.divides ? 1 : .5);
            const double truth = fmax(0, part_at(&v, distance_of(&v, closeness)));
            assert_true(fabs(planned(&v, &plan, depth, at) - truth) * 65536 <= plan.error + 3);
        }
    }
    assert_true(count[FOGGED_LINEARLY] > 100 && count[FOGGED_BY_PIXEL] > 1000 && count[FOGGED_NOT] > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(powers_of_two_fall_as_they_should),
        cmocka_unit_test(a_part_is_its_formula_within_what_is_written),
        cmocka_unit_test(the_error_written_is_nearly_reached),
        cmocka_unit_test(a_plan_is_within_its_error),
        cmocka_unit_test(a_run_is_within_its_error),
        cmocka_unit_test(what_is_left_out_cannot_show),
        cmocka_unit_test(the_budget_is_divided_not_passed),
        cmocka_unit_test(fog_behind_the_far_plane_is_none),
        cmocka_unit_test(a_corner_where_the_fog_begins_has_none),
        cmocka_unit_test(extremes_are_drawn),
        cmocka_unit_test(what_reaches_a_little_beyond_is_off_by_that),
        cmocka_unit_test(the_least_fog_there_is_is_planned_within_its_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* Numbers at the ends of their types and of their documented ranges: functions of fixed/ and geometry/, the powers, and
 * the plan's invariants, against 128-bit integers and double precision. */
#include "geometry/object.h"
#include "glint.h"
#include "plan/highlighted.h"
#include "plan/plan.h"
#include "shade/power.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "tests/unit/random.h"
#include "tests/unit/scene_case.h"

typedef __int128 wide;

static const int32_t ends[] = {
    INT32_MIN, INT32_MIN + 1, -(1 << 30) - 1, -(1 << 30), -65537,        -65536,        -1,       0, 1,
    65535,     65536,         (1 << 30) - 1,  1 << 30,    (1 << 30) + 1, INT32_MAX - 1, INT32_MAX};
#define ENDS (sizeof ends / sizeof *ends)

static void products_and_quotients_are_exact_at_every_end(void **state)
{
    (void)state;
    for (size_t i = 0; i < ENDS; i++)
        for (size_t j = 0; j < ENDS; j++) {
            const int32_t a = ends[i], b = ends[j];
            const uint32_t u = (uint32_t)a, v = (uint32_t)b;
            assert_int_equal(fx_mulhi_s32(a, b), (int32_t)((wide)a * b >> 32));
            assert_int_equal(fx_mulhi_s32_narrow(a, b), (int32_t)((wide)a * b >> 32));
            assert_int_equal(fx_mulhi_u32(u, v), (uint32_t)((wide)u * v >> 32));
            assert_int_equal(fx_mulhi_u32_narrow(u, v), (uint32_t)((wide)u * v >> 32));
            if (b) {
                const int64_t n[] = {a, (int64_t)a * 0x7fffffff, INT64_MAX, -INT64_MAX};
                for (int k = 0; k < 4; k++) {
                    assert_true(fx_divide_s64(n[k], b) == (int64_t)((wide)n[k] / b));
                    assert_true(fx_divide_u64((uint64_t)n[k], v) == (uint64_t)n[k] / v);
                }
                assert_true(fx_divide_u64(UINT64_MAX, (uint64_t)b) == UINT64_MAX / (uint64_t)b);
            }
            const int32_t most = (1 << 30) + (1 << 19);
            if (b > 0 && b <= 1 << 30 && a >= -most && a <= most) {
                int32_t q, r, q2, r2;
                fx_divmod_floor(a, b, &q, &r);
                fx_divmod_floor_narrow(a, b, &q2, &r2);
                assert_true(r >= 0 && r < b && (wide)q * b + r == a && q2 == q && r2 == r);
            }
        }
}

static void roots_shifts_and_angles_are_right_at_every_end(void **state)
{
    (void)state;
    for (size_t i = 0; i < ENDS; i++) {
        const uint32_t u = (uint32_t)ends[i];
        const uint64_t root = fx_root(u);
        assert_true(root * root <= u && (root + 1) * (root + 1) > u);
        if (u)
            assert_true(u >> (31 - fx_clz(u)) == 1 && fx_clz_narrow(u) == fx_clz(u));
        const double turn = u * 0x1p-32 * 2 * acos(-1);
        assert_true(fabs(fx_sin(u) - sin(turn) * 0x1p30) < 1.2 && fabs(fx_cos(u) - cos(turn) * 0x1p30) < 1.2);
        const double falls = 65536 * exp2(-(u / 65536.));
        assert_true(fabs(fx_exp2_minus(u) - falls) <= 7.5);
        for (unsigned bits = 1; bits < 16; bits++) {
            const int32_t shifted = ends[i] >> 4, most = (1 << bits) - 1;
            const uint32_t wanted = (uint32_t)(shifted < 0 ? 0 : shifted > most ? most : shifted);
            assert_int_equal(fx_saturated(u, bits, 4), wanted);
        }
        if (u >> 31)
            assert_true(fabs(fx_recip_norm(u) - 0x1p63 / u) <= 2 && fx_recip_norm(u) >= 1u << 31);
        if (u >> 30)
            assert_true(fabs(fx_rsqrt_norm(u) / (0x1p46 / sqrt(u)) - 1) < 0x1p-20);
    }
}

/* Of every form, at bases from INT32_MIN to INT32_MAX: 0 below 0, 1 above 1. The free forms are max(0, 1 - (n / g)(1 -
 * s))^g. */
static void a_power_of_any_base_is_between_0_and_1(void **state)
{
    static const unsigned exponents[] = {1, 2, 3, 20, 199, 200, 1022, 1023};
    static const struct {
        const struct glint_power *form;
        double g;
    } forms[] = {{&glint_power_4, 4}, {&glint_power_8, 8}, {&glint_power_16, 16}};
    double table_off = 0, free_off = 0;
    (void)state;
    for (size_t e = 0; e < sizeof exponents / sizeof *exponents; e++) {
        struct fx_power table;
        const unsigned n = exponents[e];
        fx_power_build(&table, n);
        for (size_t i = 0; i < 4 * ENDS; i++) {
            const int32_t near[] = {0, 1, 3, 1 << 12};
            const int64_t moved = (int64_t)ends[i / 4] + near[i % 4];
            const int32_t s = (int32_t)(moved > INT32_MAX ? INT32_MAX : moved);
            const double base = s * 0x1p-30, held = base < 0 ? 0 : base > 1 ? 1 : base, truth = pow(held, n);
            table_off = fmax(table_off, fabs(fx_power(&table, s) / 32768. - truth));
            assert_true(fabs(fx_power_exact(n, s) - truth * 32768) <= .5001);
            int32_t exact = s;
            glint_power_exact.run(n, &exact, 1);
            assert_int_equal(exact, fx_power_exact(n, s));
            for (size_t f = 0; f < 3; f++) {
                const double foot = held > 0 ? fmax(0, 1 - n / forms[f].g * (1 - held)) : 0;
                int32_t value = s;
                forms[f].form->run(n, &value, 1);
                assert_true(value >= 0 && value <= 32768);
                free_off = fmax(free_off, fabs(value / 32768. - pow(foot, forms[f].g)));
            }
        }
    }
    print_message("the table is off by %.2f/255, a free form from its own formula by %.2f\n", 255 * table_off,
                  255 * free_off);
    assert_true(255 * table_off < .5 && 255 * free_off < .1);
}

/* Vectors at the ends of what object_unit(), object_towards() and vector_normalise() take. */
static void vectors_at_the_ends_are_unit_and_point_their_way(void **state)
{
    static const int32_t parts[] = {-((1 << 30) - 1), -(1 << 29), -32769, -1, 0, 1, 3, 65535, 1 << 28, (1 << 30) - 1};
    enum { PARTS = sizeof parts / sizeof *parts };
    double q14 = 0, q30 = 0;
    (void)state;
    for (int i = 1; i < PARTS * PARTS * PARTS; i++) {
        const int32_t v[3] = {parts[i % PARTS], parts[i / PARTS % PARTS], parts[i / PARTS / PARTS]};
        const double length = sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
        q14_t unit[3];
        q30_t fine[3];
        object_unit(v, unit);
        vector_normalise(v, fine);
        for (int k = 0; k < 3; k++) {
            q14 = fmax(q14, fabs(unit[k] - (length > 0 ? v[k] / length : k == 2) * 16384));
            q30 = fmax(q30, fabs(fine[k] - (length > 0 ? v[k] / length : k == 2) * 0x1p30));
        }
    }
    print_message("unit vectors are off by %.2f of Q14, %.2f of Q30\n", q14, q30);
    assert_true(q14 <= 2 && q30 <= 16);
}

/* Numbers beyond 2^127 are compared by their sign alone: a product of a 128-bit and a 64-bit number. */
static int sign(long double x)
{
    return (x > 0) - (x < 0);
}

/* H1 and H2 with light, eye, place and normal at the ends of their ranges, zeros among them: H1's sign is exact; H2's
 * is, but that what differs by 2^-25 of its sides or less may count as 0; by 2^-27 or less it does. */
static void highlight_conditions_have_their_signs_at_every_end(void **state)
{
    static const int32_t at[] = {-(1 << 28), -(1 << 28) + 1, -32768, -1, 0, 1, 32767, 1 << 28};
    static const int32_t place[] = {-32768, -1, 0, 1, 32767}, normal[] = {-(1 << 25), -1, 0, 1, 1 << 25};
    long zeros[2] = {0, 0};
    (void)state;
    random_seed(6);
    for (int i = 0; i < 200000; i++) {
        struct object_state object = {0};
        struct highlighted_point point;
        int64_t l[3], v[3];
        wide h1 = 0;
        long double ln = 0, vn = 0, ll = 0, vv = 0;
        object.light[0].source.near = object.eye.near = 1;
        for (int k = 0; k < 3; k++) {
            object.light[0].source.at[k] = at[random_between(0, 7)];
            object.eye.at[k] = at[random_between(0, 7)];
            point.place[k] = place[random_between(0, 4)];
            point.normal[k] = normal[random_between(0, 4)];
            l[k] = object.light[0].source.at[k] - point.place[k];
            v[k] = object.eye.at[k] - point.place[k];
            ln += (long double)l[k] * point.normal[k];
            vn += (long double)v[k] * point.normal[k];
            ll += (long double)l[k] * l[k];
            vv += (long double)v[k] * v[k];
        }
        for (int k = 0; k < 3; k++) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            h1 += ((wide)l[a] * v[b] - (wide)l[b] * v[a]) * point.normal[k];
        }
        const struct highlighted_conditions got = highlighted_at(&object, 0, &point);
        assert_int_equal(got.h1, (h1 > 0) - (h1 < 0));
        assert_int_equal(got.away, ln < 0 && vn < 0);
        assert_int_equal(got.towards, ln > 0 && vn > 0);
        zeros[0] += h1 == 0;
        if (ll == 0 || vv == 0) {
            assert_int_equal(got.h2, 0);
            continue;
        }
        const long double left = vn * fabsl(vn) * ll, right = ln * fabsl(ln) * vv;
        zeros[1] += got.h2 == 0;
        if (fabsl(left - right) > 0x1p-24L * fmaxl(fabsl(left), fabsl(right)) && got.h2 != sign(left - right))
            fail_msg("case %d: H2 is %d, not %d: vn %Lg, vv %Lg, ln %Lg, ll %Lg", i, got.h2, sign(left - right), vn, vv,
                     ln, ll);
        if (fabsl(left - right) < 0x1p-27L * fmaxl(fabsl(left), fabsl(right)))
            assert_int_equal(got.h2, 0);
    }
    print_message("%ld zeros of H1, %ld of H2\n", zeros[0], zeros[1]);
    assert_true(zeros[0] > 1000 && zeros[1] > 1000);
}

/* What the plan is given at the ends: it never allows more than the budget, and says nothing of what it leaves out. */
static void a_plan_of_any_numbers_keeps_its_budget(void **state)
{
    static const int16_t dot[] = {-16384, -16383, -1, 0, 1, 8192, 16382, 16383};
    static const uint16_t bend[] = {0, 1, 16384, 32768, 32769, 65535}, budget[] = {0, 1, 512, 65535},
                          light[] = {0, 1, 255, 65280}, exponents[] = {1, 2, 200, 1023};
    long rungs[PLAN_RUNGS] = {0};
    (void)state;
    random_seed(7);
    for (int i = 0; i < 300000; i++) {
        struct fx_power power;
        static struct fx_power built[4];
        int16_t record[3][2 * SCENE_MAX_LIGHTS];
        const uint16_t bends[3] = {bend[random_between(0, 5)], bend[random_between(0, 5)], bend[random_between(0, 5)]};
        struct plan_triangle t = {.bend = bends, .keep = random_between(0, 1)};
        const int e = random_between(0, 3);
        if (!built[e].exponent)
            fx_power_build(&built[e], exponents[e]);
        power = built[e];
        struct plan_surface s = {.power = &power,
                                 .budget = budget[random_between(0, 3)],
                                 .lights = (uint8_t)(random_between(0, 1) ? 1 : random_between(0, 8)),
                                 .spare = (uint16_t)random_between(0, 230),
                                 .lengths = (uint16_t)random_between(0, 1000),
                                 .duff_sum = UINT16_MAX,
                                 .full = light[random_between(0, 3)],
                                 .foot = (int16_t)(16384 - (16384 >> power.octave))};
        for (unsigned l = 0; l < s.lights; l++) {
            s.light[l].diffuse = light[random_between(0, 3)];
            s.light[l].specular = light[random_between(0, 3)];
            s.highlights |= s.light[l].specular != 0;
        }
        for (int k = 0; k < 3; k++) {
            for (unsigned d = 0; d < 2 * SCENE_MAX_LIGHTS; d++)
                record[k][d] = dot[random_between(0, 7)];
            t.lights[k] = record[k];
        }
        t.shift = random_between(0, 2) ? 0 : (uint32_t)random_between(0, 65536);
        struct shade_plan plan;
        memset(&plan, 0, sizeof plan);
        plan_triangle(&plan, &s, &t);
        assert_true(plan.rung < PLAN_RUNGS);
        assert_true(plan.error <= s.budget);
        const unsigned all = (1u << s.lights) - 1;
        assert_true(!((plan.diffuse | plan.specular | plan.hidden_lights | plan.hidden_highlights |
                       plan.dropped_highlights | plan.diffuse_bent | plan.specular_bent) &
                      ~all));
        rungs[plan.rung]++;
    }
    for (int r = 0; r < PLAN_RUNGS; r++)
        if (rungs[r] < 20)
            fail_msg("rung %d is taken %ld times", r, rungs[r]);
}

/* A light in the corner of the world that is turned out of it, seen by an object in the opposite one. */
static void a_light_at_the_end_of_the_world_is_where_it_is(void **state)
{
    static struct scene_vertex vertices[3] = {
        {{-32767, 0, 0}, {0, 0, 16384}}, {{32767, 0, 0}, {0, 0, 16384}}, {{0, 32767, 0}, {0, 0, 16384}}};
    static struct scene_triangle triangle = {.corner = {0, 1, 2}};
    double worst = 0;
    (void)state;
    random_seed(8);
    for (int i = 0; i < 2000; i++) {
        struct scene_case c;
        const int32_t most = (1 << 30) - 1;
        scene_case_default(&c, 32, 32);
        c.mesh[0].vertices = vertices;
        c.mesh[0].triangles = &triangle;
        c.mesh[0].vertex_count = 3;
        c.mesh[0].triangle_count = 1;
        c.light[0].kind = LIGHT_POINT;
        c.light[0].motion.kind = MOTION_SPIN;
        c.light[0].motion.axis[2] = 1 << 30;
        c.light[0].motion.rate = 65536; /* a turn a second */
        for (int k = 0; k < 3; k++) {
            c.light[0].vector[k] = random_between(0, 1) ? most : -most;
            c.object[0].position[k] = random_between(0, 1) ? most : -most;
        }
        struct scene_header *scene = scene_case_blob(&c);
        struct object_state object = {.mesh = scene_meshes(scene)};
        struct view view;
        struct matrix to_eye = {{{1 << 30, 0, 0}, {0, 1 << 30, 0}, {0, 0, 1 << 30}}};
        const uint32_t time_ms = (uint32_t)random_between(0, 1000);
        struct pose pose = pose_at(scene, scene_objects(scene), time_ms);
        view_setup(&view, scene, 32, 32);
        object_light_setup(&object, scene, &view, &pose, &to_eye, time_ms);
        const double a = 2 * acos(-1) * time_ms / 1000, x = c.light[0].vector[0], y = c.light[0].vector[1];
        const double at[3] = {x * cos(a) - y * sin(a), x * sin(a) + y * cos(a), c.light[0].vector[2]};
        double way[3], got[3], length = 1e-9, own = 1e-9, cosine = 0;
        for (int k = 0; k < 3; k++) {
            way[k] = at[k] - c.object[0].position[k];
            got[k] = object.light[0].source.at[k];
            length += way[k] * way[k];
            own += got[k] * got[k];
            cosine += way[k] * got[k];
        }
        cosine /= sqrt(length * own);
        worst = fmax(worst, length > 1e6 ? sqrt(fmax(0, 1 - cosine * cosine)) : 0);
        if (length > 1e6 && !(cosine > .9999))
            fail_msg("case %d: the light is seen at a cosine of %.4f", i, cosine);
        free(scene);
    }
    print_message("directions are off by at most %.6f\n", worst);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_and_quotients_are_exact_at_every_end),
        cmocka_unit_test(roots_shifts_and_angles_are_right_at_every_end),
        cmocka_unit_test(a_power_of_any_base_is_between_0_and_1),
        cmocka_unit_test(vectors_at_the_ends_are_unit_and_point_their_way),
        cmocka_unit_test(highlight_conditions_have_their_signs_at_every_end),
        cmocka_unit_test(a_plan_of_any_numbers_keeps_its_budget),
        cmocka_unit_test(a_light_at_the_end_of_the_world_is_where_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

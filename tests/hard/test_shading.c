/* SPDX-License-Identifier: MIT */
/*
 * One triangle whose normals, light or exponent are hard on the shading, by each method, in each kind of loop (8-bit
 * grey, colours, with tables and by runs), against the formulas in double precision.
 */
#include "raster/raster.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "hard_case.h"

static const unsigned exponents[] = {1, 2, 20, 200, 1023};

/* Below this length a normal is no direction: what is drawn there is only asked to be some colour between the ambient
 * one and full intensity. */
#define SHORTEST (1 / 64.)

/* A picture in double precision, 1/255, by each formula, and what a pixel may be off by: half a step; a dot product's
 * three roundings to Q14 (surface.c: 3.1 of them in N.H) times the power's slope n, more where six samples or the
 * normal's length multiply them; the power's table; a quarter for coefficients. */
struct truth {
    double value[HARD_WAYS][HARD_SIDE * HARD_SIDE], allowed[HARD_WAYS][HARD_SIDE * HARD_SIDE];
    double least[HARD_WAYS], most[HARD_WAYS]; /* what is interpolated, before clamps: finished colours, or N.H */
};
static struct truth truth;

#define OUTSIDE (-1)
#define NOWHERE (-2) /* the normal is shorter than SHORTEST */

static void find_truth(const struct hard_case *h)
{
    struct hard_facts f;
    hard_facts(h, &f);
    const double longest = fmax(f.longer[0], fmax(f.longer[1], f.longer[2])),
                 roundings = 255 * (h->kd * 1.6 + h->ks * 3.1 * h->n) / 16384;
    for (int way = 0; way < HARD_WAYS; way++)
        truth.least[way] = truth.most[way] = 0;
    for (int i = 0; i < HARD_SIDE * HARD_SIDE; i++) {
        double l[3], length;
        const int inside = hard_inside(h, i % HARD_SIDE, i / HARD_SIDE, l);
        for (int way = 0; way < HARD_WAYS; way++) {
            double *value = &truth.value[way][i];
            *value = OUTSIDE;
            if (!inside)
                continue;
            double before;
            *value = hard_value(h, &f, (enum hard_way)way, l, &length, &before);
            truth.least[way] = fmin(truth.least[way], before);
            truth.most[way] = fmax(truth.most[way], before);
            *value = length < SHORTEST ? NOWHERE : 255 * hard_clamped(*value);
            const double grown = way == HARD_SIX || way == HARD_COLOR6 ? 2 * longest : 1 / length;
            truth.allowed[way][i] = .5 + .25 + h->ks * .5 + roundings * grown;
        }
    }
}

struct worst {
    double share[HARD_METHODS], off[HARD_METHODS];
};

/* The scene by every method in one configuration. */
static void check_in(const struct hard_case *h, const struct scene_header *scene, enum glint_format format, int tables,
                     const char *what, struct worst *worst)
{
    const unsigned channels = format == GLINT_RGB888 ? 3 : 1;
    for (unsigned m = 0; m < HARD_METHODS; m++) {
        const enum hard_way way = hard_ways[m].way;
        struct frame_case f = frame_case_small(HARD_SIDE, HARD_SIDE, format);
        f.config.method = hard_ways[m].method;
        f.config.tables = (uint8_t)tables;
        f.config.budget = GLINT_BUDGET(1, 1);
        const double more = (hard_ways[m].method == &glint_auto) + (tables ? 1.6 * h->ks : 0);
        uint8_t *picture = frame_case_picture(f, scene, 0, NULL);
        for (int i = 0; i < HARD_SIDE * HARD_SIDE; i++) {
            const double value = truth.value[way][i], got = picture[channels * i], off = fabs(got - value),
                         most = truth.allowed[way][i] + more;
            if (value == NOWHERE)
                assert_true(got >= 255 * h->ka - 1);
            if (value < 0)
                continue;
            if (off > most)
                fail_msg("%s, n %u, kd %.2f, ks %.2f, format %d, %d tables: %s is %.0f at %d, %d, not %.2f +- %.2f",
                         what, h->n, h->kd, h->ks, format, tables, hard_ways[m].name, got, i % HARD_SIDE, i / HARD_SIDE,
                         value, most);
            worst->share[m] = fmax(worst->share[m], off / most);
            if (h->n <= 20)
                worst->off[m] = fmax(worst->off[m], off);
        }
        free(picture);
    }
}

static void check(struct hard_case *h, const char *what, struct worst *worst)
{
    struct scene_header *scene = hard_scene(h);
    find_truth(h);
    check_in(h, scene, GLINT_GREY8, 0, what, worst);
    check_in(h, scene, GLINT_GREY8, 1, what, worst);
    check_in(h, scene, GLINT_RGB888, 0, what, worst);
    check_in(h, scene, GLINT_RGB888, 1, what, worst);
    free(scene);
}

/* With each exponent, diffuse light alone, the highlight alone, and both up to full intensity. */
static void check_materials(struct hard_case *h, const char *what, struct worst *worst)
{
    for (size_t i = 0; i < sizeof exponents / sizeof *exponents; i++) {
        static const double parts[][2] = {{15 / 16., 0}, {0, 15 / 16.}, {.5, 7 / 16.}};
        for (int p = i ? 1 : 0; p < 3; p++) {
            h->n = exponents[i];
            h->kd = parts[p][0];
            h->ks = parts[p][1];
            check(h, what, worst);
        }
    }
}

static void say(const char *what, const struct worst *worst)
{
    print_message("%s: off in 1/255 for n <= 20, and of what is allowed for all:", what);
    for (unsigned m = 0; m < HARD_METHODS; m++)
        print_message(" %s %.2f %.2f", hard_ways[m].name, worst->off[m], worst->share[m]);
    print_message("\n");
}

/* Eight lights: along the axis, aside, grazing, below, and from behind. */
static const double lights[][3] = {{0, 0, 1},    {.5, .2, 1},   {-1, .3, .4},  {.2, -1, .1},
                                   {1, 0, -.02}, {.1, .9, -.3}, {-.6, 0, -.8}, {0, 0, -1}};
#define LIGHTS (sizeof lights / sizeof *lights)

static void take_light(struct hard_case *h, size_t i)
{
    hard_light(h, lights[i][0], lights[i][1], lights[i][2]);
}

/* Normals that lean by `angle` degrees from one to the next, the third between them, seen from a side or not. */
static void lean(struct hard_case *h, double angle, int way)
{
    const double half = angle / 2 * acos(-1) / 180, turned = way * .7;
    for (int k = 0; k < 3; k++) {
        const double a = k == 2 ? turned : (k ? half : -half) + turned;
        hard_normal(h, k, sin(a), k == 2 ? .3 * way : 0, cos(a));
    }
}

static void check_angle(double angle, const char *what)
{
    struct worst worst = {0};
    struct hard_case h;
    hard_large(&h);
    for (int way = 0; way < 3; way++)
        for (size_t i = 0; i < LIGHTS; i++) {
            lean(&h, angle, way);
            take_light(&h, i);
            check_materials(&h, what, &worst);
        }
    say(what, &worst);
}

static void normals_at_90_degrees_are_shaded_as_their_formulas_say(void **state)
{
    (void)state;
    check_angle(90, "90 degrees");
}

static void normals_at_120_degrees_are_shaded_as_their_formulas_say(void **state)
{
    (void)state;
    check_angle(120, "120 degrees");
}

static void normals_at_179_9_degrees_are_shaded_as_their_formulas_say(void **state)
{
    (void)state;
    check_angle(179.9, "179.9 degrees");
}

static void opposite_normals_are_shaded_as_their_formulas_say(void **state)
{
    (void)state;
    check_angle(180, "180 degrees");
}

/* Whether a method asks nothing but the normals: the others bend equal ones too, if they do not stand on the triangle.
 */
static int asks_normals_alone(const struct glint_method *method)
{
    return method->id != GLINT_OVERVELD && method->id != GLINT_BIQUADRATIC;
}

/* Not only within what is allowed: no pixel differs from another. */
static void equal_normals_make_one_colour(void **state)
{
    struct worst worst = {0};
    (void)state;
    random_seed(1);
    for (int i = 0; i < 40; i++) {
        struct hard_case h;
        double n[3];
        hard_large(&h);
        random_direction(n, 3);
        for (int k = 0; k < 3; k++)
            hard_normal(&h, k, i ? n[0] : 0, i ? n[1] : 0, i ? n[2] : 1);
        take_light(&h, (size_t)i % LIGHTS);
        h.n = exponents[i % 5];
        h.kd = .5;
        h.ks = 7 / 16.;
        check(&h, "equal normals", &worst);
        struct scene_header *scene = hard_scene(&h);
        for (unsigned m = 0; m < glint_choice_count; m++) {
            struct frame_case f = frame_case_small(HARD_SIDE, HARD_SIDE, GLINT_GREY8);
            f.config.method = glint_choices[m].method;
            if (!asks_normals_alone(f.config.method))
                continue;
            uint8_t *picture = frame_case_picture(f, scene, 0, NULL);
            for (int p = 0; p < HARD_SIDE * HARD_SIDE; p++)
                if (picture[p] && picture[p] != picture[HARD_SIDE * HARD_SIDE / 2 + HARD_SIDE / 2])
                    fail_msg("case %d by %s: %d beside %d", i, glint_choices[m].name, picture[p],
                             picture[HARD_SIDE * HARD_SIDE / 2 + HARD_SIDE / 2]);
            free(picture);
        }
        free(scene);
    }
    say("equal normals", &worst);
}

/* The longest normal that a scene may have along a direction: N.N up to (1 + 2^-13)^2. */
static void longest(q14_t n[3], const double along[3])
{
    int32_t most = 0, best[3] = {0, 0, 0};
    for (int i = 0; i < 27 * 27 * 27; i++) {
        const int32_t v[3] = {(int32_t)lrint(along[0] * 16385) + i % 27 / 9 - 1,
                              (int32_t)lrint(along[1] * 16385) + i % 9 / 3 - 1,
                              (int32_t)lrint(along[2] * 16385) + i % 3 - 1};
        const int32_t square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (square > most && square <= (1 << 28) + (1 << 16) + 4) {
            most = square;
            memcpy(best, v, sizeof best);
        }
    }
    for (int i = 0; i < 3; i++)
        n[i] = (q14_t)best[i];
}

/* N.N > 1, the light along them: N.L and N.H pass 1, and are held at it. */
static void normals_a_little_too_long_are_as_bright_as_unit_ones(void **state)
{
    struct worst worst = {0};
    double most = 0;
    (void)state;
    random_seed(2);
    for (int i = 0; i < 12; i++) {
        struct hard_case h;
        double n[3] = {0, 0, 1};
        hard_large(&h);
        if (i)
            random_direction(n, 3);
        for (int k = 0; k < 3; k++)
            longest(h.vertex[k].normal, n);
        for (int k = 0; k < 3; k++)
            most = fmax(
                most, (pow(h.vertex[0].normal[0], 2) + pow(h.vertex[0].normal[1], 2) + pow(h.vertex[0].normal[2], 2)) /
                          0x1p28);
        if (i & 1)
            hard_light(&h, n[0], n[1], n[2]);
        else /* half-way to the eye is the normal */
            hard_light(&h, 2 * n[2] * n[0], 2 * n[2] * n[1], 2 * n[2] * n[2] - 1);
        check_materials(&h, "long normals", &worst);
    }
    print_message("N.N up to 1 + %.1f 2^-16\n", (most - 1) * 0x1p16);
    assert_true(most > 1 + 0x1p-13);
    say("long normals", &worst);
}

/* Where Ii = -Ij the edge's bulge is 0 whatever the angle, in X and through six samples: what shows is linear. */
static void antisymmetric_intensities_are_linear_along_their_edge(void **state)
{
    struct worst worst = {0};
    (void)state;
    for (int i = 0; i < 8; i++) {
        struct hard_case h;
        const double a = .2 + .17 * i;
        hard_large(&h);
        hard_normal(&h, 0, cos(a), 0, sin(a));
        hard_normal(&h, 1, cos(a), 0, -sin(a));
        hard_normal(&h, 2, 1, 0, 0);
        hard_light(&h, 0, 0, 1);
        check_materials(&h, "antisymmetric", &worst);
        hard_light(&h, 0, 0, -1);
        check_materials(&h, "antisymmetric", &worst);
    }
    say("antisymmetric intensities", &worst);
}

/* N.L is 0 at all corners, at two, and at one; and a hair to either side. */
static void a_light_at_the_terminator_adds_what_its_formula_says(void **state)
{
    struct worst worst = {0};
    (void)state;
    for (int i = 0; i < 27; i++) {
        struct hard_case h;
        const int rise[3] = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
        hard_large(&h);
        for (int k = 0; k < 3; k++)
            hard_normal(&h, k, cos(2. * k), sin(2. * k), rise[k] / 16384.);
        hard_light(&h, 0, 0, 1);
        check_materials(&h, "terminator", &worst);
        for (int k = 0; k < 3; k++)
            hard_normal(&h, k, k == 0 ? 1 : cos(2. * k), sin(2. * k), k == 0 ? 0 : rise[k] * .5);
        check_materials(&h, "terminator", &worst);
    }
    say("light at the terminator", &worst);
}

/* Two corners dark, all other samples bright; or one bright, the others dark: six samples make the colour pass 0 and 1,
 * by up to 1/4 and 1/8 there. */
static void a_colour_that_rings_is_clamped(void **state)
{
    struct worst worst = {0};
    double least = 0, most = 0;
    (void)state;
    random_seed(3);
    for (int i = 0; i < 60; i++) {
        struct hard_case h;
        const double a = random_real(.3, .55) * acos(-1), b = random_real(-.3, .3);
        hard_large(&h);
        h.ka = 0;
        h.kd = i & 1;
        h.ks = 1;
        h.n = i & 1 ? 1 : 50;
        hard_normal(&h, 0, sin(a), b, cos(a));
        hard_normal(&h, 1, -sin(a), b, cos(a));
        hard_normal(&h, 2, 0, 0, 1);
        hard_light(&h, 0, 0, 1);
        check(&h, "ringing", &worst);
        least = fmin(least, truth.least[HARD_COLOR6]);
        most = fmax(most, truth.most[HARD_COLOR6]);
    }
    print_message("colours before the clamp from %.3f to %.3f\n", least, most);
    assert_true(least < -.1 && most > 1.2);
    say("ringing colours", &worst);
}

/* N.H as near to 1 as there are numbers, over it by roundings, at a corner or within; and below 0 at another. What the
 * functions make of a base beyond 1 by more is test_extremes.c's. */
static void a_specular_base_around_0_and_1_is_clamped(void **state)
{
    struct worst worst = {0};
    double least = 0, most = 0;
    (void)state;
    random_seed(4);
    for (int i = 0; i < 100; i++) {
        struct hard_case h;
        const int wide = i & 1;
        hard_large(&h);
        for (int k = 0; k < 3; k++) {
            const double a = wide ? random_real(0, 1.8) : random_magnitude(1e-5, .1),
                         turn = 2.094 * k + random_real(-.3, .3);
            hard_normal(&h, k, sin(a) * cos(turn), sin(a) * sin(turn), cos(a));
        }
        hard_light(&h, 0, 0, 1);
        h.kd = .25;
        h.ks = 11 / 16.;
        h.n = exponents[i % 5];
        check(&h, "base around 0 and 1", &worst);
        least = fmin(least, fmin(truth.least[HARD_X], truth.least[HARD_SIX]));
        most = fmax(most, fmax(truth.most[HARD_X], truth.most[HARD_SIX]));
    }
    print_message("N.H from %.4f to %.6f\n", least, most);
    assert_true(least < -.1 && most > 1 - 0x1p-14);
    say("specular bases around 0 and 1", &worst);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_normals_make_one_colour),
        cmocka_unit_test(normals_a_little_too_long_are_as_bright_as_unit_ones),
        cmocka_unit_test(normals_at_90_degrees_are_shaded_as_their_formulas_say),
        cmocka_unit_test(normals_at_120_degrees_are_shaded_as_their_formulas_say),
        cmocka_unit_test(normals_at_179_9_degrees_are_shaded_as_their_formulas_say),
        cmocka_unit_test(opposite_normals_are_shaded_as_their_formulas_say),
        cmocka_unit_test(antisymmetric_intensities_are_linear_along_their_edge),
        cmocka_unit_test(a_light_at_the_terminator_adds_what_its_formula_says),
        cmocka_unit_test(a_colour_that_rings_is_clamped),
        cmocka_unit_test(a_specular_base_around_0_and_1_is_clamped),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

/* SPDX-License-Identifier: MIT */
/* The highlight test against double precision: conditions at a point, triangles missed. */
#include "highlight_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>

static void no_highlight_of_a_directional_light_is_missed(void **state)
{
    (void)state;
    long highlights = 0, passed = 0, missed = 0, unaimed = 0, tries = 1200000;
    random_seed(96);
    for (long i = 0; i < tries; i++) {
        double weight[3];
        random_corners(random_magnitude(.01, 2), 4096);
        far_at(&object.light[0].source);
        if (i % 4)
            aim_far_viewer();
        else
            far_at(&object.eye);
        int pass = passes();
        passed += pass;
        unaimed += pass && i % 4 == 0;
        if (!solve_far(weight) || !inside(weight))
            continue;
        highlights++;
        missed += !pass;
    }
    print_message("directional: %ld triangles, %ld highlights, %ld missed; %ld pass, of %ld aimed at random %ld\n",
                  tries, highlights, missed, passed, tries / 4, unaimed);
    assert_int_equal(missed, 0);
    assert_true(highlights > 150000);
    assert_true(passed < 3 * highlights && unaimed < tries / 4 / 5); /* a test that passes all would miss none */
}

/* Cases of a light or viewer so near that directions turn across the triangle. Misses: the conditions are then not
 * linear, and may change sign twice along an edge. */
static void few_highlights_of_near_lights_are_missed(void **state)
{
    (void)state;
    /* as measured over more cases, and half more */
    static const struct {
        double distance, misses;
    } rows[] = {{.5, .16}, {1, .06}, {2, .02}, {4, .006}, {16, .003}, {64, .001}};
    random_seed(97);
    for (size_t d = 0; d < sizeof rows / sizeof *rows; d++) {
        long highlights = 0, missed = 0, tries = 12000;
        for (long i = 0; i < tries; i++) {
            const int size = random_between(200, 8000);
            double best[3], reach = rows[d].distance * size * 2; /* of the triangle's extent */
            random_corners(random_magnitude(.02, .6), size);
            near_at(&object.light[0].source, reach);
            for (int j = 0; j < 3; j++)
                object.light[0].source.at[j] += (corner[0].place[j] + corner[1].place[j] + corner[2].place[j]) / 3;
            aim_viewer(i & 1 ? 0 : reach);
            if (!find_brightest(best))
                continue;
            highlights++;
            missed += !passes();
        }
        print_message("point light %4.1f extents away: %ld highlights, %ld missed\n", rows[d].distance, highlights,
                      missed);
        assert_true(highlights > 700);
        assert_true((double)missed <= rows[d].misses * (double)highlights);
    }
}

/* The conditions themselves: signs, and zeros only where rounding leaves them open. */
static void conditions_have_the_signs_of_their_formulas(void **state)
{
    (void)state;
    long zeros = 0;
    random_seed(98);
    for (int i = 0; i < 300000; i++) {
        const double one[3] = {1, 0, 0};
        double side[3];
        random_corners(1, 32767);
        if (i % 3)
            far_at(&object.light[0].source);
        else
            near_at(&object.light[0].source, random_magnitude(100, 0x1p28));
        if (i % 5)
            near_at(&object.eye, random_magnitude(100, 0x1p28));
        else
            far_at(&object.eye);
        struct real_point p = at_weights(one);
        struct highlighted_conditions at = highlighted_at(&object, 0, &corner[0]);
        cross(p.light, p.eye, side);
        double h1 = dot(side, p.normal), size = sqrt(dot(side, side)) * 16384;
        if (fabs(h1) > 1e-12 * size)
            assert_int_equal(at.h1, h1 < 0 ? -1 : 1);
        double ln = dot(p.light, p.normal), vn = dot(p.eye, p.normal);
        double l = ln / sqrt(dot(p.light, p.light)), v = vn / sqrt(dot(p.eye, p.eye));
        if (fabs(v - l) > 0x1p-27 * fabs(l))
            assert_int_equal(at.h2, v < l ? -1 : 1);
        else
            zeros += at.h2 == 0;
        assert_int_equal(at.away, ln < 0 && vn < 0);
    }
    assert_true(zeros < 10);
}

/* L, V and N in one plane, and N half-way: exact zeros, which are both signs. */
static void a_zero_counts_as_both_signs(void **state)
{
    (void)state;
    object = (struct object_state){0};
    object.light[0].source = (struct object_point){{9000, 0, 12000}, 0, 0};
    object.eye = (struct object_point){{-9000, 0, 12000}, 0, 0};
    for (int k = 0; k < 3; k++)
        corner[k] = (struct highlighted_point){{0, 0, 0}, {0, 0, 16384}};
    struct highlighted_signs s = highlighted_signs(&object, 1, &corner[0]);
    assert_int_equal(s.below1 & s.above1 & s.below2 & s.above2, 1);
    assert_true(passes()); /* all three alike: a flat triangle that mirrors the light */
    for (int k = 0; k < 3; k++)
        corner[k].normal[2] = -16384;
    assert_false(passes()); /* facing away at all three */
    corner[0].normal[2] = 16384;
    assert_true(passes());
    corner[0] = (struct highlighted_point){{0, 0, 0}, {0, 16384, 0}}; /* across both: neither is nearer */
    s = highlighted_signs(&object, 1, &corner[0]);
    assert_int_equal(s.below2 & s.above2, 1);
}

/* Far away and next to each other, so that their cosines differ by about as little as counts as equal. Which of them is
 * called the light changes the sign, and where it is 0 nothing. */
static void light_and_viewer_change_places_and_with_them_the_sign(void **state)
{
    long zeros = 0, signs = 0;
    (void)state;
    random_seed(100);
    object = (struct object_state){0};
    corner[0] = (struct highlighted_point){{0, 0, 0}, {0, 0, 0}};
    for (int i = 0; i < 100000; i++) {
        struct object_point light, eye;
        near_at(&light, 0x1p27);
        eye = light;
        for (int k = 0; k < 3; k++) {
            eye.at[k] += random_between(-4, 4);
            corner[0].normal[k] = random_between(-32767, 32767);
        }
        object.light[0].source = light;
        object.eye = eye;
        const struct highlighted_conditions one = highlighted_at(&object, 0, &corner[0]);
        object.light[0].source = eye;
        object.eye = light;
        const struct highlighted_conditions other = highlighted_at(&object, 0, &corner[0]);
        assert_int_equal(one.h1, -other.h1);
        assert_int_equal(one.h2, -other.h2);
        *(one.h2 ? &signs : &zeros) += 1;
    }
    print_message("%ld zeros, %ld signs\n", zeros, signs);
    assert_true(zeros > 100000 / 10 && signs > 100000 / 10);
}

/* It has no direction from there, so nothing speaks against a highlight. */
static void a_light_at_a_corner_counts_as_both_signs(void **state)
{
    (void)state;
    object = (struct object_state){0};
    object.eye = (struct object_point){{0, 0, 16384}, 0, 0};
    object.light[0].source = (struct object_point){{500, -700, 900}, 1, 0};
    corner[0] = (struct highlighted_point){{500, -700, 900}, {0, 0, 16384}};
    struct highlighted_signs s = highlighted_signs(&object, 1, &corner[0]);
    assert_int_equal(s.below1 & s.above1 & s.below2 & s.above2, 1);
    assert_int_equal(s.away, 0);
}

/* Any light that has its highlight there makes a triangle one, each in its own bit. */
static void every_light_has_its_own_bit(void **state)
{
    (void)state;
    random_seed(99);
    for (int i = 0; i < 20000; i++) {
        struct highlighted_signs all[3];
        unsigned wanted = 0;
        random_corners(.8, 2000);
        far_at(&object.eye);
        for (int l = 0; l < 8; l++)
            far_at(&object.light[l].source);
        for (int k = 0; k < 3; k++)
            all[k] = highlighted_signs(&object, 8, &corner[k]);
        for (int l = 0; l < 8; l++) {
            struct object_state one = object;
            object.light[0] = object.light[l];
            wanted |= (unsigned)passes() << l;
            object = one;
        }
        assert_int_equal(highlighted_lights(&all[0], &all[1], &all[2]), wanted);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_highlight_of_a_directional_light_is_missed),
        cmocka_unit_test(few_highlights_of_near_lights_are_missed),
        cmocka_unit_test(conditions_have_the_signs_of_their_formulas),
        cmocka_unit_test(a_zero_counts_as_both_signs),
        cmocka_unit_test(light_and_viewer_change_places_and_with_them_the_sign),
        cmocka_unit_test(a_light_at_a_corner_counts_as_both_signs),
        cmocka_unit_test(every_light_has_its_own_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

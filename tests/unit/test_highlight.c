/* SPDX-License-Identifier: MIT */
/* The highlight test against double precision: conditions at a point, triangles missed, and where the centre is found.
 */
#include "plan/summit.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

static struct object_state object;
static struct highlighted_point corner[3];

/* What the test is given, exactly: a direction in Q14 or a place. */
static void far_at(struct object_point *point)
{
    double v[3];
    random_direction(v, 3);
    for (int i = 0; i < 3; i++)
        point->at[i] = (int32_t)lrint(v[i] * 16384);
    point->near = 0;
}

static void near_at(struct object_point *point, double distance)
{
    double v[3];
    random_direction(v, 3);
    for (int i = 0; i < 3; i++)
        point->at[i] = (int32_t)lrint(v[i] * distance);
    point->near = 1;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void unit(double v[3])
{
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

static void way(const struct object_point *to, const double place[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = to->near ? to->at[i] - place[i] : to->at[i];
}

/* Place, normal, ways to light and viewer at weights of the corners. */
struct real_point {
    double place[3], normal[3], light[3], eye[3];
};

static struct real_point at_weights(const double weight[3])
{
    struct real_point p;
    for (int i = 0; i < 3; i++) {
        p.place[i] = p.normal[i] = 0;
        for (int k = 0; k < 3; k++) {
            p.place[i] += weight[k] * corner[k].place[i];
            p.normal[i] += weight[k] * corner[k].normal[i];
        }
    }
    way(&object.light[0].source, p.place, p.light);
    way(&object.eye, p.place, p.eye);
    return p;
}

/* The cosine of normal and half-way vector. */
static double cosine(const double weight[3])
{
    struct real_point p = at_weights(weight);
    double half[3];
    unit(p.normal);
    unit(p.light);
    unit(p.eye);
    for (int i = 0; i < 3; i++)
        half[i] = p.light[i] + p.eye[i];
    unit(half);
    return dot(p.normal, half);
}

/* A triangle as a mesh has them, the corners' normals within `spread` of one direction. */
static void random_corners(double spread, int size)
{
    double axis[3];
    int32_t middle[3];
    random_direction(axis, 3);
    for (int i = 0; i < 3; i++)
        middle[i] = random_between(size - 32768, 32767 - size);
    for (int k = 0; k < 3; k++) {
        double off[3], n[3];
        random_direction(off, 3);
        for (int i = 0; i < 3; i++) {
            n[i] = axis[i] + spread * off[i];
            corner[k].place[i] = middle[i] + random_between(-size, size);
        }
        unit(n);
        for (int i = 0; i < 3; i++)
            corner[k].normal[i] = (int32_t)lrint(n[i] * 16384);
    }
}

static int passes(void)
{
    struct highlighted_signs s[3];
    for (int k = 0; k < 3; k++)
        s[k] = highlighted_signs(&object, 1, &corner[k]);
    return highlighted_lights(&s[0], &s[1], &s[2]) == 1;
}

/* Where the normal is along the half-way vector of far light and viewer: weights, all >= 0 inside; 0 if nowhere. */
static int solve_far(double weight[3])
{
    const double centre[3] = {1 / 3., 1 / 3., 1 / 3.};
    struct real_point p = at_weights(centre);
    double half[3], n[3][3], side[3], sum = 0;
    unit(p.light);
    unit(p.eye);
    for (int i = 0; i < 3; i++)
        half[i] = p.light[i] + p.eye[i];
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            n[k][i] = corner[k].normal[i];
    cross(n[1], n[2], side);
    double det = dot(n[0], side);
    if (det == 0)
        return 0;
    for (int k = 0; k < 3; k++) {
        cross(n[(k + 1) % 3], n[(k + 2) % 3], side);
        weight[k] = dot(half, side) / det;
        sum += weight[k];
    }
    for (int k = 0; k < 3; k++)
        weight[k] /= sum;
    return sum > 0;
}

static int inside(const double weight[3])
{
    return weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0;
}

/* A viewer that sees the highlight somewhere about the triangle: the light's mirror image in a normal near it. */
static void aim_far_viewer(void)
{
    const double weight[3] = {random_real(-.5, 1), random_real(-.5, 1), random_real(-.5, 1)};
    struct real_point p = at_weights(weight);
    double v[3];
    unit(p.normal);
    unit(p.light);
    for (int i = 0; i < 3; i++)
        v[i] = 2 * dot(p.normal, p.light) * p.normal[i] - p.light[i];
    for (int i = 0; i < 3; i++)
        object.eye.at[i] = (int32_t)lrint(v[i] * 16384);
    object.eye.near = 0;
}

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

/* The brightest point inside, by trial: 1 if it is a highlight's centre, with normal and half-way vector as one. */
static int find_brightest(double best[3])
{
    double most = -2;
    for (int i = 1; i < 10; i++)
        for (int j = 1; i + j < 10; j++) {
            const double weight[3] = {i / 10., j / 10., 1 - i / 10. - j / 10.};
            double c = cosine(weight);
            if (c > most) {
                most = c;
                memcpy(best, weight, sizeof weight);
            }
        }
    for (double step = .05; step > 1e-5;) {
        static const int ways[6][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}};
        int better = 0;
        for (int w = 0; w < 6; w++) {
            double weight[3] = {best[0] + step * ways[w][0], best[1] + step * ways[w][1], 0};
            weight[2] = 1 - weight[0] - weight[1];
            double c = inside(weight) ? cosine(weight) : -2;
            if (c > most) {
                most = c;
                memcpy(best, weight, sizeof weight);
                better = 1;
            }
        }
        step = better ? step : step / 2;
    }
    struct real_point p = at_weights(best);
    return most > 1 - 1e-9 && dot(p.light, p.normal) > 0;
}

/* A viewer, far or near, that sees the light's mirror image about the middle. */
static void aim_viewer(double distance)
{
    const double weight[3] = {random_real(0, .6), random_real(0, .6), random_real(0, .6)};
    struct real_point p = at_weights(weight);
    double v[3];
    unit(p.normal);
    unit(p.light);
    object.eye.near = distance > 0;
    for (int i = 0; i < 3; i++) {
        v[i] = 2 * dot(p.normal, p.light) * p.normal[i] - p.light[i];
        object.eye.at[i] = (int32_t)lrint(distance > 0 ? p.place[i] + v[i] * distance : v[i] * 16384);
    }
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

static int find_peak(double weight[3], int *opposite)
{
    uint16_t q10[3] = {0, 0, 0};
    int found = (int)summit_find(&object, 0, corner, q10, opposite);
    if (found != SUMMIT_NONE)
        assert_int_equal(q10[0] + q10[1] + q10[2], SUMMIT_ONE);
    for (int k = 0; k < 3; k++)
        weight[k] = q10[k] / (double)SUMMIT_ONE;
    return found;
}

static void the_peak_of_a_directional_light_is_its_centre(void **state)
{
    (void)state;
    long found = 0, edges = 0;
    double worst = 0;
    random_seed(100);
    object.local = 0;
    for (int i = 0; i < 40000; i++) {
        double weight[3], peak[3];
        int opposite = -1;
        random_corners(random_real(.1, .6), 4096);
        far_at(&object.light[0].source);
        aim_far_viewer();
        for (int j = 0; j < 3; j++)
            object.light[0].towards[j] = (q14_t)object.light[0].source.at[j];
        int in = solve_far(weight) && weight[0] > .01 && weight[1] > .01 && weight[2] > .01;
        int place = find_peak(peak, &opposite);
        if (place == SUMMIT_EDGE) {
            assert_in_range(opposite, 0, 2);
            assert_true(peak[opposite] == 0);
            edges++;
        }
        if (!in)
            continue;
        found++;
        /* Where the conditions are nearly parallel, a SUMMIT_ONE-th of Q may put both ends on one side of H2: an edge
         * is then taken, at a place as bright. */
        worst = fmax(worst, 1 - cosine(peak));
    }
    print_message("directional: %ld centres, worst 1 - cos %.2g; %ld on edges\n", found, worst, edges);
    assert_true(found > 4000 && edges > 1000);
    assert_true(worst < 1e-5);
}

static void the_peak_of_a_near_light_is_its_centre(void **state)
{
    (void)state;
    long found = 0, off = 0;
    random_seed(101);
    object.local = 1;
    for (int i = 0; i < 12000; i++) {
        double best[3], peak[3];
        int opposite;
        random_corners(random_real(.1, .5), 4000);
        near_at(&object.light[0].source, 16000);
        for (int j = 0; j < 3; j++)
            object.light[0].source.at[j] += corner[0].place[j];
        aim_viewer(i & 1 ? 0 : 30000);
        if (!find_brightest(best) || best[0] < .05 || best[1] < .05 || best[2] < .05 || !passes())
            continue;
        found++;
        int place = find_peak(peak, &opposite);
        off += place != SUMMIT_INSIDE || cosine(peak) < 1 - 1e-4;
    }
    print_message("near: %ld centres, %ld not found within .8 degrees\n", found, off);
    assert_true(found > 900);
    assert_true(off * 80 <= found);
}

/* Light and viewer are mirrored at corner 2's normal, but for a little: the straight guess may be the corner itself. */
static void a_peak_in_a_corner_is_found_there(void **state)
{
    const uint16_t whole[3] = {0, 0, SUMMIT_ONE};
    (void)state;
    long found = 0;
    random_seed(102);
    object.local = 1;
    object.eye.near = object.light[0].source.near = 1;
    for (int i = 0; i < 20000; i++) {
        double n[3], to[3], weight[3];
        uint16_t at[3];
        int opposite;
        random_corners(.4, 4000);
        random_direction(to, 3);
        for (int k = 0; k < 3; k++)
            n[k] = corner[2].normal[k] / 16384.;
        for (int k = 0; k < 3; k++) {
            const double across = to[k] - dot(n, to) * n[k];
            object.eye.at[k] = corner[2].place[k] + (int32_t)lrint(20000 * (n[k] + across));
            object.light[0].source.at[k] =
                corner[2].place[k] + (int32_t)lrint(20000 * (n[k] - across)) + random_between(-30, 30);
        }
        if (summit_find(&object, 0, corner, at, &opposite) != SUMMIT_INSIDE || memcmp(at, whole, sizeof at) != 0)
            continue;
        found++;
        for (int k = 0; k < 3; k++)
            weight[k] = at[k] / (double)SUMMIT_ONE;
        assert_true(cosine(weight) > 1 - 1e-5);
    }
    assert_true(found > 500);
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
        cmocka_unit_test(the_peak_of_a_directional_light_is_its_centre),
        cmocka_unit_test(the_peak_of_a_near_light_is_its_centre),
        cmocka_unit_test(a_peak_in_a_corner_is_found_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

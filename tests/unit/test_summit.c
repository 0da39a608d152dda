/* SPDX-License-Identifier: MIT */
/* Where the centre of a highlight is found, against double precision. */
#include "highlight_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

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
        cmocka_unit_test(the_peak_of_a_directional_light_is_its_centre),
        cmocka_unit_test(the_peak_of_a_near_light_is_its_centre),
        cmocka_unit_test(a_peak_in_a_corner_is_found_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

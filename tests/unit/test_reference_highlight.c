/* SPDX-License-Identifier: MIT */
/* The highlight test in double precision, on triangles made around a highlight, and what the hybrids do with it. */
#include "random.h"
#include "reference/highlight.h"
#include "reference/method.h"
#include "scene/vec.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

enum { TRIANGLES = 300000 };

/* A light and a viewer far away: the half vector is where the highlight's normal points. */
static void far_view(struct decode_view *view, double half[3])
{
    memset(view, 0, sizeof *view);
    view->light_count = 1;
    do
        random_direction(view->lights[0].vector, 3);
    while (view->lights[0].vector[2] < -.9);
    for (int k = 0; k < 3; k++)
        half[k] = view->lights[0].vector[k] + (k == 2);
    vec_normalise(half);
}

/* Unit normals about `half`, up to `lean` from it a component. */
static void lean_from(const double half[3], double lean, struct decode_vertex corner[3])
{
    memset(corner, 0, 3 * sizeof *corner);
    for (unsigned v = 0; v < 3; v++) {
        for (unsigned k = 0; k < 3; k++)
            corner[v].normal[k] = half[k] + random_real(-lean, lean);
        vec_normalise(corner[v].normal);
    }
}

/* n0, n1, n2 with half = sum of positive multiples: the highlight's centre is inside exactly. */
static bool encloses(const struct decode_vertex corner[3], const double half[3])
{
    double side[3];
    for (unsigned v = 0; v < 3; v++) {
        double across[3];
        vec_cross(corner[v].normal, corner[(v + 1) % 3].normal, across);
        side[v] = vec_dot(across, half);
    }
    return (side[0] > 0 && side[1] > 0 && side[2] > 0) || (side[0] < 0 && side[1] < 0 && side[2] < 0);
}

/* H1 and H2 are linear in the normal where light and viewer are far away. Of the triangles without a highlight the test
 * lets pass those whose normals straddle both planes. */
static void a_highlight_of_a_far_light_is_never_missed(void **state)
{
    unsigned inside = 0, missed = 0, possible = 0;
    (void)state;
    random_seed(1);
    for (int i = 0; i < TRIANGLES; i++) {
        struct decode_view view;
        struct decode_vertex corner[3];
        double half[3];
        far_view(&view, half);
        lean_from(half, .5, corner);
        bool passes = highlight_possible(&view, corner), within = encloses(corner, half);
        possible += passes;
        inside += within;
        missed += within && !passes;
    }
    print_message("%d triangles, %u with the centre of a highlight, %u possible, %u missed\n", TRIANGLES, inside,
                  possible, missed);
    assert_true(inside > TRIANGLES / 10);
    assert_int_equal(missed, 0);
    assert_true(possible < 4 * inside);
}

/* Corners around a direction at right angles to where H1 holds; then a second light that reflects just there. */
static void a_highlight_aside_of_all_corners_is_refused(void **state)
{
    (void)state;
    random_seed(2);
    for (int i = 0; i < TRIANGLES / 10; i++) {
        struct decode_view view;
        struct decode_vertex corner[3] = {0};
        double half[3], across[3], along[3];
        far_view(&view, half);
        vec_cross(view.lights[0].vector, (double[]){0, 0, 1}, across);
        vec_normalise(across);
        vec_cross(across, half, along);
        for (unsigned v = 0; v < 3; v++) {
            static const double around[3][2] = {{.1, 0}, {-.05, .1}, {-.05, -.1}};
            for (unsigned k = 0; k < 3; k++)
                corner[v].normal[k] =
                    half[k] + across[k] + around[v][0] * along[k] + around[v][1] * (across[k] - half[k]);
            vec_normalise(corner[v].normal);
        }
        assert_false(highlight_possible(&view, corner));
        for (unsigned k = 0; k < 3; k++) /* |half + across|^2 = 2 */
            view.lights[1].vector[k] = half[2] * (half[k] + across[k]) - (k == 2);
        view.light_count = 2;
        assert_true(highlight_possible(&view, corner));
    }
}

/* A zero counts as both signs, and a triangle faces away only if all of its corners do. */
static void zeros_and_single_corners_count(void **state)
{
    struct decode_view view = {.light_count = 1, .lights = {{.vector = {0, 0, 1}}}};
    struct decode_vertex corner[3] = {{.normal = {0, .6, .8}}, {.normal = {0, .6, .8}}, {.normal = {0, .6, .8}}};
    (void)state;
    assert_true(highlight_possible(&view, corner)); /* light and viewer are one: both values are zero */
    for (unsigned v = 0; v < 3; v++)
        corner[v].normal[2] = -.8;
    assert_false(highlight_possible(&view, corner));
    corner[1].normal[2] = .8;
    assert_true(highlight_possible(&view, corner));
}

/* Two triangles share the vertices 1 and 2; the highlight is in the first. */
static void a_highlight_reaches_all_triangles_at_its_vertices(void **state)
{
    static const struct scene_triangle triangles[] = {
        {.corner = {0, 1, 2}}, {.corner = {2, 1, 3}}, {.corner = {3, 4, 5}}};
    struct decode_view view = {.light_count = 1, .lights = {{.vector = {.6, 0, .8}}}};
    struct decode_vertex vertices[6] = {{.normal = {0, -.6, .8}}, {.normal = {.79, .1, .6}}, {.normal = {0, .6, .8}},
                                        {.normal = {.6, .8, 0}},  {.normal = {0, 1, 0}},     {.normal = {-.6, .8, 0}}};
    bool reached[6] = {0};
    (void)state;
    highlight_mark(&view, triangles, 3, vertices, reached, 6);
    for (unsigned v = 0; v < 6; v++)
        assert_int_equal(reached[v], v < 3);
}

/* N.H at a place, both unit there. */
static double cosine_at(const struct decode_view *view, const struct decode_vertex corner[3], const double at[3])
{
    struct shading shading = {.view = view};
    struct decode_vertex v = shading_mix(corner, at);
    double dots[2];
    vec_normalise(v.normal);
    shading_dots(&shading, 0, v.position, v.normal, dots);
    return dots[1];
}

static void the_centre_of_a_far_lights_highlight_is_found(void **state)
{
    unsigned found = 0;
    (void)state;
    random_seed(3);
    for (int i = 0; i < TRIANGLES / 30; i++) {
        struct decode_view view;
        struct decode_vertex corner[3];
        double half[3];
        far_view(&view, half);
        lean_from(half, .5, corner);
        if (!encloses(corner, half))
            continue;
        struct peak peak = peak_find(&view, 0, corner);
        assert_int_equal(peak.kind, PEAK_INSIDE);
        assert_true(cosine_at(&view, corner, peak.at) > 1 - 1e-9); /* H2's square is flat where light meets viewer */
        found++;
    }
    assert_true(found > TRIANGLES / 300);
}

/* A light and a viewer some edges away. H1 then holds along a curve, which in 1 of 50 triangles leaves the triangle on
 * the way to the centre, where the straight guess stands. */
static void the_centre_of_a_near_lights_highlight_is_found(void **state)
{
    unsigned inside = 0, missed = 0;
    (void)state;
    random_seed(4);
    for (int i = 0; i < TRIANGLES / 30; i++) {
        struct decode_view view = {.local_viewer = true, .light_count = 1, .lights = {{.point = true}}};
        struct decode_vertex corner[3];
        lean_from((double[]){0, 0, 1}, .4, corner);
        for (unsigned v = 0; v < 3; v++) {
            static const double place[3][2] = {{-1, -1}, {1, -1}, {0, 1}};
            for (unsigned k = 0; k < 2; k++)
                corner[v].position[k] = place[v][k] + random_real(-.3, .3);
            corner[v].position[2] = -6;
        }
        for (unsigned k = 0; k < 3; k++)
            view.lights[0].vector[k] = k == 2 ? random_real(-2, 0) : random_real(-2, 2);
        struct peak peak = peak_find(&view, 0, corner);
        if (!highlight_under(&view, 0, corner) || peak.kind != PEAK_INSIDE)
            continue;
        double cosine = cosine_at(&view, corner, peak.at);
        missed += cosine < 1 - 1e-5;
        inside++;
    }
    print_message("%u highlights of near lights, %u not found to 1e-5 of N.H\n", inside, missed);
    assert_true(inside > TRIANGLES / 300);
    assert_true(missed < 3 * inside / 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_highlight_of_a_far_light_is_never_missed),
        cmocka_unit_test(a_highlight_aside_of_all_corners_is_refused),
        cmocka_unit_test(zeros_and_single_corners_count),
        cmocka_unit_test(the_centre_of_a_far_lights_highlight_is_found),
        cmocka_unit_test(the_centre_of_a_near_lights_highlight_is_found),
        cmocka_unit_test(a_highlight_reaches_all_triangles_at_its_vertices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

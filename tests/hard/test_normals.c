/* SPDX-License-Identifier: MIT */
/*
 * Quadratic normals where an edge is near one of the limits by which it is bent another way, or not at all: how far the
 * normal in its middle jumps there, by the renderer's numbers, and what the formula of section 3.1 says on either side.
 */
#include "shade/normal_quadratic.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "tests/unit/random.h"
#include "tests/unit/scene_case.h"

#define DEGREES (180 / acos(-1))

/* An edge along x in a triangle whose face looks along y and leans by `tilt` about the edge. */
struct edge {
    struct scene_vertex vertex[3];
    const struct scene_vertex *corner[3];
};

static void edge_setup(struct edge *e, double tilt)
{
    static const int16_t place[3][3] = {{-12000, 0, 0}, {12000, 0, 0}, {0, 0, 0}};
    for (int k = 0; k < 3; k++) {
        e->corner[k] = &e->vertex[k];
        for (int i = 0; i < 3; i++)
            e->vertex[k].position[i] = place[k][i];
    }
    e->vertex[2].position[1] = (int16_t)lrint(-20000 * sin(tilt));
    e->vertex[2].position[2] = (int16_t)lrint(-20000 * cos(tilt));
}

/* The unit normal in the middle of the edge, n = (n0 + n1) / 2 - b / 4; *bulge: |b|. */
static void middle_of(const struct edge *e, double out[3], double *bulge)
{
    struct normal_quadratic n;
    double length = 0, size = 0;
    normal_quadratic_lee_jen(e->corner, 1, &n);
    for (int i = 0; i < 3; i++) {
        const double b = n.bulge[i][0] * 0x1p-28;
        out[i] = (n.value[i][0] + n.value[i][1]) / 32768. - b / 4;
        length += out[i] * out[i];
        size += b * b;
    }
    for (int i = 0; i < 3; i++)
        out[i] /= sqrt(length);
    *bulge = sqrt(size);
}

static double between(const double a[3], const double b[3])
{
    const double x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    return atan2(sqrt(x * x + y * y + z * z), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * DEGREES;
}

/* Normals that lean by a0 and a1 from y in a plane that holds y and makes an angle with the edge whose cosine is
 * `along`: G is that part of the edge. */
static void lean_in_plane(struct edge *e, double along, double a0, double a1)
{
    const double across = sqrt(1 - along * along), a[2] = {a0, a1};
    for (int k = 0; k < 2; k++)
        scene_case_normal(e->vertex[k].normal, sin(a[k]) * along, cos(a[k]), sin(a[k]) * across);
}

/* |G| through |D| / 4: below, the face's plane takes the place of the normals'. The more the face looks as the normals
 * do, the less the direction changes. */
static void a_short_gamma_changes_hands_by_little_where_the_face_looks_as_the_normals(void **state)
{
    (void)state;
    for (int tilt = 0; tilt <= 30; tilt += 10) {
        double jump = 0, most = 0;
        for (int i = 1; i < 40; i++) {
            const double a0 = i / DEGREES, a1 = (41 - i) / 3. / DEGREES;
            struct edge e;
            double above[3], below[3], bulge;
            if (fabs(a0 - a1) < .1)
                continue; /* their plane is rounded by more than G moves here */
            edge_setup(&e, tilt / DEGREES);
            lean_in_plane(&e, .2515, a0, a1);
            middle_of(&e, above, &bulge);
            /* G along the normals' plane: |b| = 3 (sin a0 + sin a1) */
            assert_true(fabs(bulge - 3 * (sin(a0) + sin(a1))) < .02);
            lean_in_plane(&e, .2485, a0, a1);
            middle_of(&e, below, &bulge);
            jump = fmax(jump, between(above, below));
            most = fmax(most, bulge);
        }
        print_message("face %d degrees off: the middle normal jumps by up to %.1f degrees, bulges up to %.2f\n", tilt,
                      jump, most);
        assert_true(jump < .5 + 1.8 * tilt);
    }
}

/* All of G from |D| down to nothing: there the edge leans against neither normal and is linear, to which it comes
 * without a step. */
static void gamma_to_nothing_ends_linear(void **state)
{
    double largest = 0, before[3] = {0, 0, 0}, step = 0;
    (void)state;
    for (int i = 4000; i >= 0; i--) {
        struct edge e;
        double middle[3], bulge;
        edge_setup(&e, 0);
        lean_in_plane(&e, i / 4000., .5, .3);
        middle_of(&e, middle, &bulge);
        if (i < 4000)
            step = fmax(step, between(before, middle));
        memcpy(before, middle, sizeof before);
        largest = fmax(largest, bulge);
        if (i == 0)
            assert_true(bulge == 0);
    }
    print_message("G from |D| to 0: bulges up to %.2f, the largest step of 4000 is %.2f degrees\n", largest, step);
    assert_true(largest <= 6 && largest > 2 && step < 1);
}

/* Normals that come together until their plane is none (2^-10): the face's takes its place, and the bulge stays. What
 * the middle moves by is what their rounding to 2^-14 turns a plane of 2^-10 by. */
static void normals_that_become_parallel_keep_their_bulge(void **state)
{
    double jump = 0, off = 0;
    (void)state;
    for (int i = 2; i < 60; i++) {
        const double lean = i / DEGREES;
        double before[3] = {0, 0, 0};
        for (int j = 0; j < 60; j++) {
            const double apart = .003 * (60 - j) / 60;
            struct edge e;
            double middle[3], bulge;
            edge_setup(&e, 0);
            lean_in_plane(&e, .8, lean + apart / 2, lean - apart / 2);
            middle_of(&e, middle, &bulge);
            off = fmax(off, fabs(bulge - 6 * sin(lean)));
            if (j)
                jump = fmax(jump, between(before, middle));
            memcpy(before, middle, sizeof before);
        }
    }
    print_message("parallel normals: the bulge is off by up to %.3f, the middle moves by up to %.2f degrees a step\n",
                  off, jump);
    assert_true(jump < 10 && off < .3);
}

/* One product goes through 0 while the other stands: at 2^-12 and below the edge is linear, above it bends by all that
 * the other leans. That jump is the paper's test itself, eq. 6. */
static void one_zero_product_makes_an_edge_linear(void **state)
{
    (void)state;
    for (int lean = 0; lean <= 60; lean += 15) {
        const double other = sin(lean / DEGREES);
        double jump = 0, linear[3] = {0, 0, 0};
        for (int raw = -8; raw <= 8; raw++) {
            struct edge e;
            double middle[3], bulge;
            edge_setup(&e, 0);
            lean_in_plane(&e, 1, 0, lean / DEGREES);
            e.vertex[0].normal[0] = (q14_t)raw;
            middle_of(&e, middle, &bulge);
            if (raw <= 4 || lean == 0) { /* 4 / 2^14 is 2^-12 */
                assert_true(bulge == 0);
                memcpy(linear, middle, sizeof linear);
            } else {
                assert_true(fabs(bulge - 3 * (other + raw / 16384.)) < .002);
                jump = fmax(jump, between(linear, middle));
            }
        }
        print_message("the other leans by %d degrees: the middle normal jumps by %.1f\n", lean, jump);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_short_gamma_changes_hands_by_little_where_the_face_looks_as_the_normals),
        cmocka_unit_test(gamma_to_nothing_ends_linear),
        cmocka_unit_test(normals_that_become_parallel_keep_their_bulge),
        cmocka_unit_test(one_zero_product_makes_an_edge_linear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

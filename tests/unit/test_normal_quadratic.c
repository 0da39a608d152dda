/* SPDX-License-Identifier: MIT */
/* Quadratic normals against the paper's formula in double precision, edge by edge and over the triangle. */
#include "shade/normal_quadratic.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "scene_case.h"

enum kind { ARCH, PLANE, FACE, LINEAR, DOUBTFUL, KINDS };

struct triangle {
    struct scene_vertex vertex[3];
    const struct scene_vertex *corner[3];
};

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double length(const double v[3])
{
    return sqrt(dot(v, v));
}

static void edge_of(const struct triangle *t, int e, double n0[3], double n1[3], double edge[3])
{
    const struct scene_vertex *a = t->corner[e], *b = t->corner[(e + 1) % 3];
    for (int i = 0; i < 3; i++) {
        n0[i] = a->normal[i] / 16384.;
        n1[i] = b->normal[i] / 16384.;
        edge[i] = b->position[i] - a->position[i];
    }
}

/* Eq. 8. */
static void bulge_along(const double n0[3], const double n1[3], const double g[3], double out[3])
{
    double scale = 3 * (dot(n0, g) + dot(n1, g)) / dot(g, g);
    for (int i = 0; i < 3; i++)
        out[i] = scale * g[i];
}

/* v projected on the plane of a and b; the length of their product. */
static double project(const double a[3], const double b[3], const double v[3], double out[3])
{
    double across[3], size;
    cross(a, b, across);
    size = length(across);
    for (int i = 0; i < 3; i++)
        out[i] = v[i] - (size > 0 ? dot(v, across) / (size * size) * across[i] : 0);
    return size;
}

static int near_limit(double x, double limit)
{
    return fabs(x - limit) < 1e-4 * limit;
}

/* The bulge as sections 3.1 and 3.2 have it; DOUBTFUL where rounding may decide. */
static enum kind lee_jen(const struct triangle *t, int e, double out[3])
{
    double n0[3], n1[3], edge[3], g[3], side[3], skip[3], face[3];
    memset(out, 0, 3 * sizeof *out);
    edge_of(t, e, n0, n1, edge);
    double lean0 = dot(n0, edge) / length(edge), lean1 = dot(n1, edge) / length(edge);
    if (near_limit(fabs(lean0), 0x1p-12) || near_limit(fabs(lean1), 0x1p-12))
        return DOUBTFUL;
    if (fmin(lean0, lean1) < 0x1p-12 && fmax(lean0, lean1) > -0x1p-12)
        return ARCH;
    double apart = project(n0, n1, edge, g), share = length(g) / length(edge);
    if (near_limit(apart, 0x1p-10) || (apart > 0x1p-10 && near_limit(share, .25)))
        return DOUBTFUL;
    if (apart > 0x1p-10 && share > .25) {
        bulge_along(n0, n1, g, out);
        return PLANE;
    }
    edge_of(t, (e + 1) % 3, skip, skip, side);
    cross(edge, side, face);
    for (double size = length(face), *f = face; f < face + 3; f++)
        *f /= size;
    /* whole numbers: exact */
    apart = project(fabs(dot(n0, edge)) >= fabs(dot(n1, edge)) ? n0 : n1, face, edge, g);
    if (near_limit(apart, 0x1p-10))
        return DOUBTFUL;
    if (apart < 0x1p-10)
        return LINEAR;
    bulge_along(n0, n1, g, out);
    for (int i = 0; i < 3; i++)
        out[i] *= fmin(1, 16 * length(g) / length(edge));
    return FACE;
}

static void turn(double v[3], const double from[3], double most)
{
    double by[3];
    random_direction(by, 3);
    for (int i = 0; i < 3; i++)
        v[i] = from[i] + most * by[i];
}

/* Corners anywhere in the mesh's reach, or near each other; normals anywhere, near each other, the same, or near the
 * triangle's. Triangles with an angle of less than about 3 degrees are passed over: their own normal is a matter of
 * rounding. */
static void random_triangle(struct triangle *t)
{
    double p[3][3], base[3], n[3], a[3], b[3], face[3], sine;
    do {
        double reach = random_magnitude(100, 32767);
        for (int k = 0; k < 3; k++) {
            t->corner[k] = &t->vertex[k];
            for (int i = 0; i < 3; i++) {
                t->vertex[k].position[i] = (int16_t)lrint(random_real(-reach, reach));
                p[k][i] = t->vertex[k].position[i];
            }
        }
        for (int i = 0; i < 3; i++) {
            a[i] = p[1][i] - p[0][i];
            b[i] = p[2][i] - p[0][i];
        }
        cross(a, b, face);
        sine = length(face) / fmax(dot(a, a), fmax(dot(b, b), dot(a, a) + dot(b, b) - 2 * dot(a, b)));
    } while (!(sine > .05));
    random_direction(base, 3);
    if (random_between(0, 3) == 0)
        for (int i = 0; i < 3; i++)
            base[i] = face[i] / length(face);
    double spread = random_between(0, 3) ? random_magnitude(1e-4, 2) : 0;
    turn(base, base, random_between(0, 1) ? random_magnitude(1e-4, .5) : 0);
    for (int k = 0; k < 3; k++) {
        turn(n, base, spread);
        scene_case_normal(t->vertex[k].normal, n[0], n[1], n[2]);
    }
}

static void check_bulge(const struct normal_quadratic *n, int e, const double wanted[3], double most)
{
    for (int axis = 0; axis < 3; axis++)
        if (fabs(n->bulge[axis][e] * 0x1p-28 - wanted[axis]) > most)
            fail_msg("component %d of edge %d bulges by %.7f, not %.7f", axis, e, n->bulge[axis][e] * 0x1p-28,
                     wanted[axis]);
}

static void bulges_of_overveld_are_the_formula_s(void **state)
{
    (void)state;
    random_seed(11);
    for (int i = 0; i < 100000; i++) {
        struct triangle t;
        struct normal_quadratic n;
        random_triangle(&t);
        normal_quadratic_overveld(t.corner, &n);
        for (int e = 0; e < 3; e++) {
            double n0[3], n1[3], edge[3], wanted[3];
            edge_of(&t, e, n0, n1, edge);
            bulge_along(n0, n1, edge, wanted);
            check_bulge(&n, e, wanted, 0x1p-21); /* 6 of unit vectors within 2^-26 */
            for (int axis = 0; axis < 3; axis++)
                assert_int_equal(n.value[axis][e], t.vertex[e].normal[axis]);
        }
    }
}

static void bulges_of_lee_and_jen_are_the_formula_s(void **state)
{
    long count[KINDS] = {0};
    (void)state;
    random_seed(12);
    for (int i = 0; i < 300000; i++) {
        struct triangle t;
        struct normal_quadratic n;
        int bent = 0;
        random_triangle(&t);
        int said = normal_quadratic_lee_jen(t.corner, 7, &n);
        for (int e = 0; e < 3; e++) {
            double wanted[3];
            enum kind kind = lee_jen(&t, e, wanted);
            count[kind]++;
            bent |= kind == PLANE || kind == FACE || kind == DOUBTFUL;
            /* Directions of vectors of 2^-10 and more that err by 2^-26: 6 times 2^-16, twice that by the face's. */
            if (kind != DOUBTFUL)
                check_bulge(&n, e, wanted, kind == PLANE ? 0x1p-15 : kind == FACE ? 0x1p-12 : 0);
        }
        assert_true(bent || !said);
    }
    print_message("edges: %ld arch, %ld by their normals, %ld by the face's, %ld parallel to it, %ld on a limit\n",
                  count[ARCH], count[PLANE], count[FACE], count[LINEAR], count[DOUBTFUL]);
    for (int kind = 0; kind < DOUBTFUL; kind++)
        assert_true(count[kind] > 200);
    assert_true(count[DOUBTFUL] < 2000);
}

/* What the bulge is for (eq. 4 and 7): over the edge, the normal's part along G is 0 in the mean. */
static void normals_have_no_mean_part_along_a_zigzag_edge(void **state)
{
    long count = 0;
    (void)state;
    random_seed(13);
    for (int i = 0; i < 50000; i++) {
        struct triangle t;
        struct normal_quadratic n;
        random_triangle(&t);
        normal_quadratic_lee_jen(t.corner, 7, &n);
        for (int e = 0; e < 3; e++) {
            double n0[3], n1[3], edge[3], wanted[3], mean = 0;
            if (lee_jen(&t, e, wanted) != PLANE)
                continue;
            edge_of(&t, e, n0, n1, edge);
            for (int axis = 0; axis < 3; axis++) /* b lies in the plane of the normals: along G as along the edge */
                mean += ((n0[axis] + n1[axis]) / 2 - n.bulge[axis][e] * 0x1p-28 / 6) * edge[axis] / length(edge);
            assert_true(fabs(mean) < 0x1p-17);
            count++;
        }
    }
    assert_true(count > 10000);
}

/* The paper's Fig. 3: a quad whose normals turn only about y. Its diagonal keeps them in that plane, and at its middle
 * has the same normal as the sides along x; the edge itself for G takes them out of it. */
static void a_serpentine_quad_turns_about_one_axis_along_its_diagonal_too(void **state)
{
    struct triangle t = {.vertex = {{{-8000, -8000, 0}, {0}}, {{8000, -8000, 0}, {0}}, {{8000, 8000, 0}, {0}}}};
    struct normal_quadratic n, o;
    (void)state;
    for (int k = 0; k < 3; k++) {
        t.corner[k] = &t.vertex[k];
        scene_case_normal(t.vertex[k].normal, k ? .5 : .7, 0, 1);
    }
    assert_int_equal(normal_quadratic_lee_jen(t.corner, 7, &n), 1);
    normal_quadratic_overveld(t.corner, &o);
    for (int e = 0; e < 3; e++)
        assert_true(abs(n.bulge[1][e]) < 1 << 8); /* roundings */
    assert_true(abs(o.bulge[1][2]) > 1 << 28);
    for (int axis = 0; axis < 3; axis++) {
        assert_int_equal(n.bulge[axis][1], 0); /* along y both are upright */
        assert_true(abs(n.bulge[axis][0] - n.bulge[axis][2]) < 1 << 12);
    }
    assert_true(n.bulge[0][0] > 3 << 28);
}

static void upright_and_arch_edges_are_linear(void **state)
{
    /* leans of the two ends along x, Q14 */
    static const struct {
        int16_t lean[2];
        int bent;
    } cases[] = {{{0, 0}, 0},    {{4000, -4000}, 0}, {{-4000, 4000}, 0}, {{4000, 0}, 0},       {{0, -4000}, 0},
                 {{4000, 3}, 0}, {{3, 3000}, 0},     {{-3, -5000}, 0},   {{4000, 8}, 1},       {{-8, -4000}, 1},
                 {{9, 9}, 0},    {{20, 20}, 1},      {{4000, 3000}, 1},  {{-16000, -9000}, 1}, {{16000, 1000}, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct triangle t = {.vertex = {{{-9000, 0, 0}, {0}}, {{9000, 0, 0}, {0}}, {{0, 9000, 0}, {0, 0, 16384}}}};
        struct normal_quadratic n;
        for (int k = 0; k < 3; k++) {
            t.corner[k] = &t.vertex[k];
            if (k < 2) {
                t.vertex[k].normal[0] = cases[i].lean[k];
                t.vertex[k].normal[2] = (q14_t)lrint(sqrt(16384. * 16384 - cases[i].lean[k] * cases[i].lean[k]));
            }
        }
        normal_quadratic_lee_jen(t.corner, 7, &n);
        if ((n.bulge[0][0] != 0) != cases[i].bent)
            fail_msg("leans %d and %d: bulge %d", cases[i].lean[0], cases[i].lean[1], n.bulge[0][0]);
    }
}

/* Where no face has a part in it, and but for roundings: 6 times 2^-26, and those of a plane known to 2^-16. */
static void an_edge_bends_alike_in_both_its_triangles(void **state)
{
    long count = 0;
    (void)state;
    random_seed(14);
    for (int i = 0; i < 50000; i++) {
        struct triangle t, u;
        struct normal_quadratic n, m;
        double skip[3];
        random_triangle(&t);
        random_triangle(&u);
        u.vertex[1] = t.vertex[0];
        u.vertex[0] = t.vertex[1];
        int plane = lee_jen(&t, 0, skip) == PLANE;
        normal_quadratic_overveld(t.corner, &n);
        normal_quadratic_overveld(u.corner, &m);
        for (int pass = 0; pass <= plane; pass++) {
            for (int axis = 0; axis < 3; axis++)
                assert_true(abs(n.bulge[axis][0] - m.bulge[axis][0]) <= (pass ? 1 << 13 : 1 << 7));
            normal_quadratic_lee_jen(t.corner, 7, &n);
            normal_quadratic_lee_jen(u.corner, 7, &m);
            count += plane;
        }
    }
    assert_true(count > 2000);
}

static double value_at(const struct normal_quadratic *n, const double l[3], double out[3])
{
    for (int axis = 0; axis < 3; axis++) {
        out[axis] = 0;
        for (int k = 0; k < 3; k++)
            out[axis] += n->value[axis][k] / 16384. * l[k] - n->bulge[axis][k] * 0x1p-28 * l[k] * l[(k + 1) % 3];
    }
    return length(out);
}

static void random_weights(double l[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += l[k] = -log(random_fraction() + 1e-12);
    for (int k = 0; k < 3; k++)
        l[k] /= sum;
}

static void normals_are_at_most_seven_sixths_long(void **state)
{
    double longest = 0, most = 0;
    (void)state;
    random_seed(15);
    for (int i = 0; i < 40000; i++) {
        struct triangle t;
        struct normal_quadratic n;
        random_triangle(&t);
        if (i & 1)
            normal_quadratic_overveld(t.corner, &n);
        else
            normal_quadratic_lee_jen(t.corner, 7, &n);
        for (int j = 0; j < 20; j++) {
            double l[3], v[3];
            random_weights(l);
            longest = fmax(longest, value_at(&n, l, v));
        }
        for (int e = 0; e < 3; e++)
            most = fmax(most, length((double[3]){n.bulge[0][e], n.bulge[1][e], n.bulge[2][e]}) * 0x1p-28);
    }
    print_message("the longest normal %.4f, the largest bulge %.4f\n", longest, most);
    assert_true(longest < 7 / 6. * (1 + 0x1p-13));
    assert_true(longest > .999);
    assert_true(most <= 6 * (1 + 0x1p-12));
    assert_true(most > 5.5);
}

static void pieces_have_the_normals_of_their_triangle(void **state)
{
    (void)state;
    random_seed(16);
    for (int i = 0; i < 50000; i++) {
        struct triangle t;
        struct normal_quadratic whole, piece;
        uint16_t w[3][3];
        double l[3], at[3] = {0, 0, 0}, wanted[3], got[3];
        struct shade_input in = {.weight = (const uint16_t(*)[3])w};
        random_triangle(&t);
        if (i & 1)
            normal_quadratic_overveld(t.corner, &whole);
        else
            normal_quadratic_lee_jen(t.corner, 7, &whole);
        for (int k = 0; k < 3; k++) {
            random_weights(l);
            w[k][0] = (uint16_t)lrint(l[0] * 32767);
            w[k][1] = (uint16_t)lrint(l[1] * (32767 - w[k][0]));
            w[k][2] = (uint16_t)(32768 - w[k][0] - w[k][1]);
        }
        piece = whole;
        normal_quadratic_restrict(&in, &piece);
        random_weights(l);
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 3; j++)
                at[j] += l[k] * w[k][j] / 32768.;
        value_at(&whole, at, wanted);
        value_at(&piece, l, got);
        for (int axis = 0; axis < 3; axis++) /* two roundings of Q14 */
            assert_true(fabs(got[axis] - wanted[axis]) < 0x1p-13);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bulges_of_overveld_are_the_formula_s),
        cmocka_unit_test(bulges_of_lee_and_jen_are_the_formula_s),
        cmocka_unit_test(normals_have_no_mean_part_along_a_zigzag_edge),
        cmocka_unit_test(a_serpentine_quad_turns_about_one_axis_along_its_diagonal_too),
        cmocka_unit_test(upright_and_arch_edges_are_linear),
        cmocka_unit_test(an_edge_bends_alike_in_both_its_triangles),
        cmocka_unit_test(normals_are_at_most_seven_sixths_long),
        cmocka_unit_test(pieces_have_the_normals_of_their_triangle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

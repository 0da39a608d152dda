/* SPDX-License-Identifier: MIT */
/* What each method makes of one triangle, against the formulas it is built from, on random triangles and lights. */
#include "random.h"
#include "reference/method.h"
#include "scene/vec.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

enum { TRIANGLES = 300 };

/* Rounding of a few hundred operations on values near 1. */
static const double exact = 1e-12;

struct fixture {
    struct decode_view view;
    struct decode_vertex corner[3];
    double bend[3];
    double place[3][2];
    struct shading shading;
};

static void assert_close(double a, double b, double limit)
{
    if (!(fabs(a - b) <= limit))
        fail_msg("%.15f is not %.15f", a, b);
}

static void start(struct fixture *f, bool near)
{
    memset(f, 0, sizeof *f);
    f->view.perspective = f->view.local_viewer = near;
    f->view.light_count = 2;
    for (unsigned l = 0; l < f->view.light_count; l++) {
        struct decode_light *light = f->view.lights + l;
        light->point = near;
        random_direction(light->vector, 3);
        light->vector[2] = fabs(light->vector[2]);
        for (unsigned c = 0; c < 3; c++)
            light->colour[c] = random_real(.1, .4);
    }
}

static void finish(struct fixture *f)
{
    static const struct decode_material material = {
        .ambient = {.1, .1, .1}, .diffuse = {.6, .5, .4}, .specular = {.3, .3, .3}, .shininess = 12};
    for (unsigned e = 0; e < 3; e++)
        f->bend[e] = (1 - vec_dot(f->corner[e].normal, f->corner[(e + 1) % 3].normal)) / 2;
    shading_material(&f->shading, &f->view, &material, 3);
    f->shading.tolerance = 4 / 255.;
    f->shading.edges = 7;
}

/* A triangle in front of the eye, and somewhere in the picture, whose unit normals lean up to `lean` from the viewer's
 * direction, a component. With `near`, point lights and a near viewer in perspective, else all is far away. */
static void make(struct fixture *f, bool near, double lean)
{
    start(f, near);
    for (unsigned v = 0; v < 3; v++) {
        static const double place[3][2] = {{-1, -1}, {1, -1}, {0, 1}};
        struct decode_vertex *corner = f->corner + v;
        for (unsigned k = 0; k < 2; k++) {
            f->place[v][k] = random_real(-20, 20) + (k ? -60 : 60) * place[v][k];
            corner->position[k] = place[v][k] + random_real(-.4, .4);
            corner->normal[k] = random_real(-lean, lean);
        }
        corner->position[2] = random_real(-8, -4);
        corner->normal[2] = 1;
        vec_normalise(corner->normal);
    }
    finish(f);
}

static void set(struct fixture *f, enum reference_method method)
{
    shading_setup(&f->shading, methods + method, f->corner, f->bend, f->place);
}

static void colour(struct fixture *f, const double at[3], double out[3])
{
    f->shading.method->pixel(&f->shading, at, out);
}

/* Phong's colour there. */
static void truth(struct fixture *f, const double at[3], double out[3])
{
    struct decode_vertex v = shading_mix(f->corner, at);
    vec_normalise(v.normal);
    shading_point(&f->shading, v.position, v.normal, out);
}

static void assert_colour(const double a[3], const double b[3], double limit)
{
    for (unsigned c = 0; c < 3; c++)
        assert_close(a[c], b[c], limit);
}

static void a_name_finds_its_method(void **state)
{
    (void)state;
    for (int m = 0; m < REFERENCE_METHODS; m++)
        assert_int_equal(method_find(methods[m].name), m);
    assert_int_equal(method_find("pong"), -1);
}

static void every_method_is_true_at_the_corners(void **state)
{
    (void)state;
    random_seed(1);
    for (int i = 0; i < TRIANGLES; i++) {
        struct fixture f;
        make(&f, i % 2, .5);
        for (int m = 0; m < REFERENCE_METHODS; m++) {
            f.shading.highlight = i % 3;
            set(&f, (enum reference_method)m);
            for (unsigned v = 0; v < 3; v++) {
                double at[3] = {v == 0, v == 1, v == 2}, a[3], b[3];
                colour(&f, at, a);
                truth(&f, at, b);
                assert_colour(a, b, exact);
            }
        }
    }
}

static void six_samples_are_true_in_the_middles_of_the_edges(void **state)
{
    static const enum reference_method six[] = {REFERENCE_SIX, REFERENCE_COLOR6, REFERENCE_DUFF, REFERENCE_PHONG};
    (void)state;
    random_seed(2);
    for (int i = 0; i < TRIANGLES; i++) {
        struct fixture f;
        make(&f, i % 2, .5);
        for (size_t m = 0; m < sizeof six / sizeof *six; m++) {
            set(&f, six[m]);
            for (unsigned e = 0; e < 3; e++) {
                double at[3] = {.5, .5, .5}, a[3], b[3];
                at[e] = 0;
                colour(&f, at, a);
                truth(&f, at, b);
                assert_colour(a, b, exact);
            }
        }
    }
}

/* Eq. 33: L12.(N1 + N2)(5 - N1.N2)/8, L12 unit at the middle; and in between, the order-free form of eq. 32. */
static void x_is_the_papers_quadratic(void **state)
{
    (void)state;
    random_seed(3);
    for (int i = 0; i < TRIANGLES; i++) {
        struct fixture f;
        make(&f, i % 2, .5);
        set(&f, REFERENCE_X);
        for (unsigned l = 0; l < f.view.light_count; l++) {
            const double *I = f.shading.dot[l][0].corner, at[3] = {.5, .3, .2};
            double phi = quadratic_linear(I, at);
            for (unsigned e = 0; e < 3; e++) {
                unsigned j = (e + 1) % 3;
                double half[3] = {0}, dots[2], cosine = vec_dot(f.corner[e].normal, f.corner[j].normal);
                half[e] = half[j] = .5;
                struct decode_vertex middle = shading_mix(f.corner, half);
                for (unsigned k = 0; k < 3; k++)
                    middle.normal[k] *= (5 - cosine) / 4;
                shading_dots(&f.shading, l, middle.position, middle.normal, dots);
                assert_close(quadratic_value(&f.shading.dot[l][0], half), dots[0], exact);
                assert_close(quadratic_value(&f.shading.dot[l][1], half), dots[1], exact);
                phi -= (I[e] + I[j]) * (cosine - 1) / 2 * at[e] * at[j];
            }
            if (i % 2 == 0)
                assert_close(quadratic_value(&f.shading.dot[l][0], at), phi, exact);
        }
    }
}

static void duffs_denominator_is_the_length_of_the_normal(void **state)
{
    (void)state;
    random_seed(4);
    for (int i = 0; i < TRIANGLES; i++) {
        struct fixture f;
        double at[3] = {random_fraction() / 2, random_fraction() / 2, 0}, a[3], b[3];
        at[2] = 1 - at[0] - at[1];
        make(&f, false, .9);
        set(&f, REFERENCE_DUFF);
        struct decode_vertex v = shading_mix(f.corner, at);
        assert_close(quadratic_value(&f.shading.square, at), vec_dot(v.normal, v.normal), exact);
        colour(&f, at, a);
        truth(&f, at, b);
        assert_colour(a, b, exact);
    }
}

/* The middle normal of edge e. */
static void middle_normal(const struct fixture *f, unsigned e, double out[3])
{
    double half[3] = {.5, .5, .5};
    half[(e + 2) % 3] = 0;
    for (unsigned k = 0; k < 3; k++)
        out[k] = quadratic_value(&f->shading.normal[k], half);
}

/* Eq. 4: the mean of the normal along the edge is perpendicular to it. Simpson's rule is exact for a quadratic. */
static void overvelds_normals_are_perpendicular_to_the_edge_on_average(void **state)
{
    (void)state;
    random_seed(5);
    for (int i = 0; i < TRIANGLES; i++) {
        struct fixture f;
        make(&f, false, .5);
        set(&f, REFERENCE_OVERVELD);
        for (unsigned e = 0; e < 3; e++) {
            const struct decode_vertex *a = f.corner + e, *b = f.corner + (e + 1) % 3;
            double edge[3], middle[3];
            vec_sub(b->position, a->position, edge);
            middle_normal(&f, e, middle);
            assert_close(vec_dot(a->normal, edge) + 4 * vec_dot(middle, edge) + vec_dot(b->normal, edge), 0, exact * 9);
        }
    }
}

/* Arch edges keep the mean of their normals; zigzag edges get eq. 7, or eq. 4 within the plane of the face and a
 * normal; both kinds are met. */
static void biquadratic_turns_zigzag_edges_only(void **state)
{
    unsigned arches = 0, zigzags = 0, faded = 0;
    (void)state;
    random_seed(6);
    for (int i = 0; i < TRIANGLES; i++) {
        struct fixture f;
        make(&f, false, .5);
        set(&f, REFERENCE_BIQUADRATIC);
        for (unsigned e = 0; e < 3; e++) {
            const struct decode_vertex *a = f.corner + e, *b = f.corner + (e + 1) % 3;
            double edge[3], middle[3], bent[3];
            vec_sub(b->position, a->position, edge);
            middle_normal(&f, e, middle);
            for (unsigned k = 0; k < 3; k++)
                bent[k] = middle[k] - (a->normal[k] + b->normal[k]) / 2;
            if (vec_dot(a->normal, edge) * vec_dot(b->normal, edge) <= 0) {
                assert_close(vec_length(bent), 0, exact);
                arches++;
                continue;
            }
            assert_true(vec_length(bent) > 1e-6);
            zigzags++;
            if (fabs(vec_dot(bent, edge)) < vec_length(bent) * vec_length(edge) / 16) {
                faded++; /* G is short */
                continue;
            }
            /* bent is along G: the mean normal is perpendicular to it */
            assert_close(vec_dot(a->normal, bent) + 4 * vec_dot(middle, bent) + vec_dot(b->normal, bent), 0, 1e-9);
        }
    }
    assert_true(faded < TRIANGLES / 8);
    assert_true(arches > TRIANGLES / 4 && zigzags > TRIANGLES / 4);
}

/* The paper's Fig. 3: a serpentine sheet whose normals turn about y alone, cut along its diagonal. */
static void biquadratic_normals_stay_in_the_plane_of_a_serpentine(void **state)
{
    static const double place[3][3] = {{0, 0, -5}, {1, 0, -5}, {1, 1, -5}};
    struct fixture f;
    double middle[3];
    (void)state;
    start(&f, false);
    for (unsigned v = 0; v < 3; v++) {
        memcpy(f.corner[v].position, place[v], sizeof place[v]);
        f.corner[v].normal[0] = .6;
        f.corner[v].normal[2] = .8;
    }
    finish(&f);
    set(&f, REFERENCE_BIQUADRATIC);
    middle_normal(&f, 0, middle); /* along x: (n, x) = .6, b = 3.6 x, the middle n - b/4 */
    assert_colour(middle, (double[]){-.3, 0, .8}, exact);
    middle_normal(&f, 1, middle); /* along y: straight */
    assert_colour(middle, (double[]){.6, 0, .8}, exact);
    middle_normal(&f, 2, middle); /* the diagonal, like the other */
    assert_colour(middle, (double[]){-.3, 0, .8}, exact);
    set(&f, REFERENCE_OVERVELD);
    middle_normal(&f, 2, middle); /* leaves the plane, and misses the serpentine's middle */
    assert_colour(middle, (double[]){.15, -.45, .8}, exact);
}

static void flat_triangles_stay_flat(void **state)
{
    (void)state;
    random_seed(7);
    for (int i = 0; i < TRIANGLES; i++) {
        static const enum reference_method quadratic[] = {REFERENCE_OVERVELD, REFERENCE_BIQUADRATIC};
        struct fixture f;
        double first[3], second[3], middle[3];
        make(&f, true, .5);
        vec_sub(f.corner[1].position, f.corner[0].position, first);
        vec_sub(f.corner[2].position, f.corner[0].position, second);
        for (unsigned v = 0; v < 3; v++) {
            vec_cross(first, second, f.corner[v].normal);
            vec_normalise(f.corner[v].normal);
        }
        for (unsigned m = 0; m < 2; m++) {
            set(&f, quadratic[m]);
            for (unsigned e = 0; e < 3; e++) {
                middle_normal(&f, e, middle);
                assert_colour(middle, f.corner[0].normal, exact);
            }
        }
    }
}

/* At the end of a row the normal is the edge's: there scan and six samples agree in the middle of an edge. */
static void rows_begin_and_end_with_the_edges_normals(void **state)
{
    (void)state;
    random_seed(8);
    for (int i = 0; i < TRIANGLES; i++) {
        struct fixture f;
        double at[3] = {.5, .5, .5}, a[3], b[3];
        make(&f, i % 2, .5);
        at[i % 3] = 0;
        set(&f, REFERENCE_OVERVELD);
        colour(&f, at, a);
        set(&f, REFERENCE_OVERVELD_SCAN);
        colour(&f, at, b);
        assert_colour(a, b, exact);
    }
}

/* The largest difference of two methods over random places, in 1/255. */
static double largest(enum reference_method method, double tolerance, double area, enum reference_method like)
{
    double most = 0;
    random_seed(9);
    for (int i = 0; i < 10 * TRIANGLES; i++) {
        struct fixture f;
        double at[3] = {random_fraction(), random_fraction(), random_fraction()}, sum = at[0] + at[1] + at[2];
        double a[3], b[3];
        for (unsigned k = 0; k < 3; k++)
            at[k] /= sum;
        make(&f, i % 2, .5);
        f.shading.tolerance = tolerance;
        for (unsigned v = 0; v < 3; v++) /* one of that area */
            for (unsigned k = 0; k < 2; k++)
                f.place[v][k] = (v == k + 1) * sqrt(2 * area);
        f.shading.part_area = 32;
        f.shading.highlight = true;
        set(&f, like);
        colour(&f, at, a);
        set(&f, method);
        colour(&f, at, b);
        for (unsigned c = 0; c < 3; c++)
            most = fmax(most, 255 * fabs(b[c] - a[c]));
    }
    return most;
}

/* At 1/32 of the edges a quadratic is as good as the truth but for the crease where a light sets; the line is not. */
static void subdivision_ends_at_the_truth(void **state)
{
    const double limit = 32 * 1024;
    double whole = largest(REFERENCE_COLOR6, 0, 0, REFERENCE_PHONG);
    double centre = largest(REFERENCE_SUBDIVIDE_CENTRE, 0, 0, REFERENCE_PHONG);
    double size = largest(REFERENCE_SUBDIVIDE_RECURSIVE, 0, limit, REFERENCE_PHONG);
    double regular = largest(REFERENCE_SUBDIVIDE_REGULAR, 0, limit, REFERENCE_PHONG);
    double linear = largest(REFERENCE_GOURAUD, 0, 0, REFERENCE_PHONG);
    (void)state;
    print_message("largest error in 1/255: quadratic %.3f of %.1f, linear %.3f of %.1f\n", centre, whole, size, linear);
    assert_true(centre < .1 && whole > 10);
    assert_true(size < .3 && linear > 30);
    assert_true(regular == size);
}

static void what_is_small_or_right_is_left_whole(void **state)
{
    (void)state;
    assert_true(largest(REFERENCE_SUBDIVIDE_CENTRE, 1, 0, REFERENCE_COLOR6) < exact);
    assert_true(largest(REFERENCE_SUBDIVIDE_RECURSIVE, 0, 32, REFERENCE_GOURAUD) < 255 * exact);
    assert_true(largest(REFERENCE_SUBDIVIDE_RECURSIVE, 0, 33, REFERENCE_GOURAUD) > 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_name_finds_its_method),
        cmocka_unit_test(every_method_is_true_at_the_corners),
        cmocka_unit_test(six_samples_are_true_in_the_middles_of_the_edges),
        cmocka_unit_test(x_is_the_papers_quadratic),
        cmocka_unit_test(duffs_denominator_is_the_length_of_the_normal),
        cmocka_unit_test(overvelds_normals_are_perpendicular_to_the_edge_on_average),
        cmocka_unit_test(biquadratic_turns_zigzag_edges_only),
        cmocka_unit_test(biquadratic_normals_stay_in_the_plane_of_a_serpentine),
        cmocka_unit_test(flat_triangles_stay_flat),
        cmocka_unit_test(rows_begin_and_end_with_the_edges_normals),
        cmocka_unit_test(subdivision_ends_at_the_truth),
        cmocka_unit_test(what_is_small_or_right_is_left_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

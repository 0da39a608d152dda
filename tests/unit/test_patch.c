/* SPDX-License-Identifier: MIT */
#include "import/normals.h"
#include "import/patch.h"
#include "scene/reader.h"
#include "scene/vec.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"

struct net {
    double at[PATCH_POINTS][3];
};

/* In [-1, 1]. */
static double uniform(void)
{
    return random_between(-1000000, 1000000) * 1e-6;
}

/* A bumpy sheet: regular, and turned towards +z everywhere. */
static void sheet(struct net *net)
{
    for (int i = 0; i < PATCH_POINTS; i++) {
        net->at[i][0] = i % 4 + .2 * uniform();
        net->at[i][1] = i / 4 + .2 * uniform();
        net->at[i][2] = .5 * uniform();
    }
}

/* A quarter of a dome: the first row is the pole, the last a circle. Turning it by quarters leaves the surface. */
static void dome(struct net *net, int turns)
{
    static const double radius[4] = {0, .56, 1, 1}, height[4] = {1, 1, .56, 0};
    for (int i = 0; i < PATCH_POINTS; i++) {
        static const double x[4] = {1, 1, .56, 0};
        const int row = i / 4, column = i % 4;
        net->at[i][0] = radius[row] * x[column];
        net->at[i][1] = radius[row] * -x[3 - column];
        net->at[i][2] = height[row];
    }
    for (; turns > 0; turns--) {
        const struct net old = *net;
        for (int i = 0; i < PATCH_POINTS; i++)
            memcpy(net->at[i], old.at[i % 4 * 4 + 3 - i / 4], sizeof old.at[0]);
    }
}

static struct model_mesh *add(struct model *model, const struct net *net, unsigned segments)
{
    struct model_mesh *mesh = model_add_mesh(model, "m");
    patch_add(mesh, net->at, segments);
    return mesh;
}

/* De Casteljau on four points `stride` apart: the point at t, and the derivative. */
static void casteljau(const double (*p)[3], int stride, double t, double point[3], double derivative[3])
{
    for (int k = 0; k < 3; k++) {
        double c[4];
        for (int i = 0; i < 4; i++)
            c[i] = p[i * stride][k];
        for (int level = 3; level > 1; level--)
            for (int i = 0; i < level; i++)
                c[i] += t * (c[i + 1] - c[i]);
        derivative[k] = 3 * (c[1] - c[0]);
        point[k] = c[0] + t * (c[1] - c[0]);
    }
}

/* Point and unit normal of the surface at (u, v). */
static void surface(const struct net *net, double u, double v, double point[3], double normal[3])
{
    double rows[4][3], columns[4][3], unused[3], du[3], dv[3];
    for (int i = 0; i < 4; i++) {
        casteljau(net->at + 4 * i, 1, u, rows[i], unused);
        casteljau(net->at + i, 4, v, columns[i], unused);
    }
    casteljau((const double(*)[3])rows, 1, v, point, dv);
    casteljau((const double(*)[3])columns, 1, u, point, du);
    vec_cross(du, dv, normal);
    assert_true(vec_normalise(normal));
}

static double distance(const double a[3], const double b[3])
{
    double d[3];
    vec_sub(a, b, d);
    return vec_length(d);
}

static void vertices_and_normals_are_those_of_the_surface(void **state)
{
    (void)state;
    random_seed(1);
    for (unsigned segments = 1; segments <= 9; segments++) {
        struct model model = {0};
        struct net net;
        sheet(&net);
        const struct model_mesh *mesh = add(&model, &net, segments);
        assert_int_equal(mesh->vertex_count, (segments + 1) * (segments + 1));
        assert_int_equal(mesh->triangle_count, 2 * segments * segments);
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            double point[3], normal[3];
            surface(&net, mesh->vertices[i].uv[0], mesh->vertices[i].uv[1], point, normal);
            assert_true(distance(mesh->vertices[i].position, point) < 1e-14); /* coordinates to 3.2: 4 ulps and less */
            assert_true(distance(mesh->vertices[i].normal, normal) < 1e-14);
        }
        model_free(&model);
    }
}

/* The index of point i of a side, 0..3 counter-clockwise, from either end. */
static int side_point(int side, bool back, int i)
{
    const int at = back ? 3 - i : i;
    return side == 0 ? at : side == 1 ? 4 * at + 3 : side == 2 ? 15 - at : 12 - 4 * at;
}

static bool mesh_has(const struct model_mesh *mesh, const double position[3])
{
    for (size_t i = 0; i < mesh->vertex_count; i++)
        if (!memcmp(mesh->vertices[i].position, position, 3 * sizeof *position))
            return true;
    return false;
}

static void a_shared_side_has_equal_bits_whichever_way_it_runs(void **state)
{
    (void)state;
    random_seed(2);
    for (int way = 0; way < 32; way++) {
        const int side_a = way % 4, side_b = way / 4 % 4;
        struct model a = {0}, b = {0};
        struct net net_a, net_b;
        sheet(&net_a);
        sheet(&net_b);
        for (int i = 0; i < 4; i++)
            memcpy(net_b.at[side_point(side_b, way & 16, i)], net_a.at[side_point(side_a, false, i)],
                   sizeof net_a.at[0]);
        const unsigned segments = 4 + (unsigned)way % 3;
        const struct model_mesh *mesh_a = add(&a, &net_a, segments);
        const struct model_mesh *mesh_b = add(&b, &net_b, segments);
        unsigned shared = 0;
        for (size_t i = 0; i < mesh_a->vertex_count; i++)
            shared += mesh_has(mesh_b, mesh_a->vertices[i].position);
        assert_int_equal(shared, segments + 1);
        model_free(&a);
        model_free(&b);
    }
}

/* How many triangles of the mesh have an edge from position a to b. */
static unsigned count_edge(const struct model_mesh *mesh, const double a[3], const double b[3])
{
    unsigned count = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        const uint32_t *corner = mesh->triangles[i / 3].corner;
        const struct model_vertex *from = &mesh->vertices[corner[i % 3]];
        const struct model_vertex *to = &mesh->vertices[corner[(i + 1) % 3]];
        count += distance(from->position, a) == 0 && distance(to->position, b) == 0;
    }
    return count;
}

static void a_pole_costs_no_triangle_and_leaves_no_gap(void **state)
{
    (void)state;
    for (int turns = 0; turns < 4; turns++)
        for (unsigned segments = 2; segments <= 8; segments += 2) {
            struct model model = {0};
            struct net net;
            dome(&net, turns);
            const struct model_mesh *mesh = add(&model, &net, segments);
            unsigned border = 0;
            assert_int_equal(mesh->triangle_count, 2 * segments * segments);
            for (size_t i = 0; i < mesh->triangle_count; i++) {
                const uint32_t *corner = mesh->triangles[i].corner;
                double face[3];
                assert_true(normals_face(mesh, &mesh->triangles[i], face));
                for (int e = 0; e < 3; e++) {
                    const struct model_vertex *a = &mesh->vertices[corner[e]];
                    const struct model_vertex *b = &mesh->vertices[corner[(e + 1) % 3]];
                    assert_true(vec_dot(face, a->normal) > .7); /* at most 45 degrees with two segments */
                    assert_int_equal(count_edge(mesh, a->position, b->position), 1);
                    border += count_edge(mesh, b->position, a->position) == 0;
                }
            }
            assert_int_equal(border, 3 * segments + 2); /* its three sides, two of them with the pole's ring */
            model_free(&model);
        }
}

static void the_normal_at_a_pole_is_the_limit(void **state)
{
    (void)state;
    for (int turns = 0; turns < 4; turns++) {
        struct model model = {0};
        unsigned poles = 0;
        struct net net;
        dome(&net, turns);
        const struct model_mesh *mesh = add(&model, &net, 4);
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            const struct model_vertex *v = &mesh->vertices[i];
            assert_true(fabs(vec_length(v->normal) - 1) < 1e-15);
            assert_true(vec_dot(v->normal, v->position) > .9); /* outwards */
            if (v->position[2] == 1) {
                assert_true(distance(v->normal, (double[]){0, 0, 1}) < 1e-15);
                poles++;
            }
        }
        assert_int_equal(poles, 5);
        model_free(&model);
    }
}

static void a_cones_tip_has_a_normal_for_each_direction(void **state)
{
    (void)state;
    static const double x[4] = {1, 1, .56, 0};
    struct model model = {0};
    struct net net;
    for (int i = 0; i < PATCH_POINTS; i++) { /* from the base up: the pole is the last row */
        const double radius = (3 - i / 4) / 3.;
        memcpy(net.at[i], (double[]){radius * x[i % 4], radius * x[3 - i % 4], 1 - radius}, sizeof net.at[i]);
    }
    const struct model_mesh *mesh = add(&model, &net, 4);
    unsigned tips = 0;
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const struct model_vertex *v = &mesh->vertices[i];
        const double slope = v->normal[2] / hypot(v->normal[0], v->normal[1]);
        assert_true(fabs(slope - 1) < .02); /* the four points' circle is no closer to one than that */
        tips += v->position[2] == 1;
    }
    assert_int_equal(tips, 5);
    model_free(&model);
}

static void a_second_pole_faces_outwards_too(void **state)
{
    (void)state;
    struct model model = {0};
    struct net net;
    dome(&net, 0);
    for (int i = 8; i < PATCH_POINTS; i++) { /* below the equator the same again */
        memcpy(net.at[i], net.at[i == 8 || i == 12 ? 4 : 4 + i % 4], sizeof net.at[i]);
        net.at[i][2] = -1;
        if (i >= 12)
            net.at[i][0] = net.at[i][1] = 0;
    }
    const struct model_mesh *mesh = add(&model, &net, 4);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        if (fabs(mesh->vertices[i].position[2]) == 1)
            assert_true(distance(mesh->vertices[i].normal, mesh->vertices[i].position) < 1e-15);
    model_free(&model);
}

/* Where two points coincide at a corner one tangent vanishes there; along the other side it does not. */
static void a_corner_of_two_equal_points_takes_the_limit_along_its_side(void **state)
{
    (void)state;
    random_seed(3);
    for (int c = 0; c < 8; c++) {
        const int u = c & 1, v = c >> 1 & 1, along_u = c >> 2;
        const double step = 1e-7;
        struct model model = {0};
        struct net net;
        double point[3], normal[3];
        sheet(&net);
        const int corner = 12 * v + 3 * u, beside = along_u ? corner + (v ? -4 : 4) : corner + (u ? -1 : 1);
        memcpy(net.at[beside], net.at[corner], sizeof net.at[corner]);
        surface(&net, along_u ? fabs(u - step) : u, along_u ? v : fabs(v - step), point, normal);
        const struct model_mesh *mesh = add(&model, &net, 1);
        assert_true(distance(mesh->vertices[2 * u + v].normal, normal) < 1e2 * step); /* its curvature is below 100 */
        model_free(&model);
    }
}

static void an_odd_pole_has_triangles_without_area(void **state)
{
    (void)state;
    struct model model = {0};
    struct net net;
    dome(&net, 0);
    const struct model_mesh *mesh = add(&model, &net, 3);
    unsigned empty = 0;
    double face[3];
    for (size_t i = 0; i < mesh->triangle_count; i++)
        empty += !normals_face(mesh, &mesh->triangles[i], face);
    assert_int_equal(mesh->triangle_count, 18);
    assert_int_equal(empty, 3);
    model_free(&model);
}

static void a_point_has_no_normal(void **state)
{
    (void)state;
    struct model model = {0};
    const struct net net = {0};
    const struct model_mesh *mesh = add(&model, &net, 2);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        assert_true(vec_length(mesh->vertices[i].normal) == 0);
    model_free(&model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_and_normals_are_those_of_the_surface),
        cmocka_unit_test(a_shared_side_has_equal_bits_whichever_way_it_runs),
        cmocka_unit_test(a_pole_costs_no_triangle_and_leaves_no_gap),
        cmocka_unit_test(the_normal_at_a_pole_is_the_limit),
        cmocka_unit_test(a_cones_tip_has_a_normal_for_each_direction),
        cmocka_unit_test(a_second_pole_faces_outwards_too),
        cmocka_unit_test(a_corner_of_two_equal_points_takes_the_limit_along_its_side),
        cmocka_unit_test(an_odd_pole_has_triangles_without_area),
        cmocka_unit_test(a_point_has_no_normal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

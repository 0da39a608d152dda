/* SPDX-License-Identifier: MIT */
#include "import/patch.h"

#include "scene/vec.h"

#include <string.h>

struct patch {
    struct model_mesh *mesh;
    double net[4][4][3]; /* row, column */
    unsigned steps;      /* a side's length: 2 a segment, since a pole's ring lies between two rows */
    uint32_t first;      /* vertex (0, 0); they stand column by column */
};

/* The cubic through c[0] and c[3] at i / n, the same bits from either end: the weights are quotients of whole numbers,
 * exactly 0 and 1 at the ends, and the sum pairs what changes places. */
static double cubic(const double c[4], double i, double n)
{
    const double j = n - i, cube = n * n * n;
    if (c[0] == c[1] && c[1] == c[2] && c[2] == c[3])
        return c[0];
    return (c[0] * (j * j * j / cube) + c[3] * (i * i * i / cube)) +
           (c[1] * (3 * j * j * i / cube) + c[2] * (3 * j * i * i / cube));
}

/* Its derivative; exactly 0 where the points coincide. */
static double slope(const double c[4], double i, double n)
{
    const double j = n - i;
    return 3 * ((c[1] - c[0]) * (j * j) + (c[2] - c[1]) * (2 * i * j) + (c[3] - c[2]) * (i * i)) / (n * n);
}

/* A tangent that vanishes grows from 0 along the mixed derivative as one walks away from its side: forwards from the
 * first, backwards to the last. */
static void replace_zero(double tangent[3], const double mixed[3], bool last)
{
    if (tangent[0] == 0 && tangent[1] == 0 && tangent[2] == 0)
        for (int k = 0; k < 3; k++)
            tangent[k] = last ? -mixed[k] : mixed[k];
}

/* The vertex at (i, j) / steps. */
static uint32_t add_vertex(const struct patch *p, unsigned i, unsigned j)
{
    double position[3], normal[3], du[3], dv[3], duv[3];
    for (int k = 0; k < 3; k++) {
        double along[4], across[4];
        for (int row = 0; row < 4; row++) {
            const double c[4] = {p->net[row][0][k], p->net[row][1][k], p->net[row][2][k], p->net[row][3][k]};
            along[row] = cubic(c, i, p->steps);
            across[row] = slope(c, i, p->steps);
        }
        position[k] = cubic(along, j, p->steps);
        du[k] = cubic(across, j, p->steps);
        dv[k] = slope(along, j, p->steps);
        duv[k] = slope(across, j, p->steps);
    }
    replace_zero(du, duv, 2 * j > p->steps);
    replace_zero(dv, duv, 2 * i > p->steps);
    vec_cross(du, dv, normal);
    vec_normalise(normal);
    uint32_t index = model_add_vertex(p->mesh, position, normal, (double)i / p->steps, (double)j / p->steps);
    memcpy(p->mesh->vertices[index].tangent, du, sizeof du);
    return index;
}

static void add_triangle(const struct patch *p, uint32_t a, uint32_t b, uint32_t c)
{
    model_add_triangle(p->mesh, a, b, c, 0);
}

/* The vertex that ends segment i of a row and j of a column. */
static uint32_t vertex(const struct patch *p, unsigned i, unsigned j)
{
    return p->first + i * (p->steps / 2 + 1) + j;
}

/* The first row of quads, all of whose upper corners are one point. */
static void add_pole(const struct patch *p)
{
    uint32_t left = add_vertex(p, 0, 1);
    for (unsigned i = 0; i + 2 <= p->steps / 2; i += 2) {
        uint32_t right = add_vertex(p, 2 * i + 4, 1), middle = vertex(p, i + 1, 1);
        add_triangle(p, vertex(p, i + 1, 0), right, left);
        add_triangle(p, left, middle, vertex(p, i, 1));
        add_triangle(p, left, right, middle);
        add_triangle(p, right, vertex(p, i + 2, 1), middle);
        left = right;
    }
}

static bool first_row_is_a_point(const struct patch *p)
{
    bool same = true;
    for (int column = 1; column < 4; column++)
        for (int k = 0; k < 3; k++)
            same = same && p->net[0][column][k] == p->net[0][0][k];
    return same;
}

/* By a quarter: the last column becomes the first row. */
static void rotate(struct patch *p)
{
    double old[4][4][3];
    memcpy(old, p->net, sizeof old);
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++)
            memcpy(p->net[row][column], old[column][3 - row], sizeof old[0][0]);
}

void patch_add(struct model_mesh *mesh, const double net[PATCH_POINTS][3], unsigned segments)
{
    struct patch p = {.mesh = mesh, .steps = 2 * segments, .first = (uint32_t)mesh->vertex_count};
    memcpy(p.net, net, sizeof p.net);
    bool pole = first_row_is_a_point(&p);
    for (int turn = 0; turn < 4 && !pole; turn++) { /* four turns, and it is as it was */
        rotate(&p);
        pole = first_row_is_a_point(&p);
    }
    pole = pole && segments % 2 == 0;
    for (unsigned i = 0; i <= segments; i++)
        for (unsigned j = 0; j <= segments; j++)
            add_vertex(&p, 2 * i, 2 * j);
    if (pole)
        add_pole(&p);
    for (unsigned i = 0; i < segments; i++)
        for (unsigned j = pole; j < segments; j++) {
            add_triangle(&p, vertex(&p, i, j), vertex(&p, i + 1, j), vertex(&p, i + 1, j + 1));
            add_triangle(&p, vertex(&p, i, j), vertex(&p, i + 1, j + 1), vertex(&p, i, j + 1));
        }
}

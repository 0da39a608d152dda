/* SPDX-License-Identifier: MIT */
/*
 * Methods that interpolate the normal and make it unit per pixel. The quadratics are those of "Improved quadratic
 * normal vector interpolation for realistic shading" (Lee and Jen): along an edge D from n0 to n1
 *   n(s) = n0 + (n1 - n0 - b) s + b s^2,  b = 3 (n0 + n1, G) / |G|^2 G  (eq. 1, 5, 8)
 * where G is D itself (van Overveld and Wyvill) or D projected on the plane of the two normals. In the middle that is
 * (n0 + n1)/2 - b/4; a triangle gets the quadratic through its corners and middles (eq. 9).
 */
#include "reference/method.h"

#include "scene/vec.h"

#include <math.h>
#include <string.h>

/* Unit normals whose cross product is shorter are parallel: packed ones are rounded to 2^-14, and the plane of a nearer
 * pair is mostly rounding. */
#define NORMAL_PARALLEL 0x1p-10
/* The cosine of a normal with an edge below which the two are perpendicular. */
#define NORMAL_UPRIGHT 0x1p-12
/* |G| / |D| below which the edge is nearly perpendicular to the plane of its normals. */
#define NORMAL_ACROSS .25
/* The same of the plane of a normal and the triangle's, below which the bulge fades with |G|. */
#define NORMAL_SHORT (1 / 16.)

/* n(s) on an edge with G as given and a part of the bulge; linear when that is zero. */
static void normal_along(const double n0[3], const double n1[3], const double g[3], double part, double s,
                         double out[3])
{
    double sum[3] = {n0[0] + n1[0], n0[1] + n1[1], n0[2] + n1[2]}, square = vec_dot(g, g);
    double scale = square > 0 ? part * 3 * vec_dot(sum, g) / square : 0;
    for (int k = 0; k < 3; k++)
        out[k] = n0[k] + (n1[k] - n0[k]) * s - scale * g[k] * s * (1 - s);
}

static void normal_edge(const struct shading *shading, unsigned e, double edge[3])
{
    vec_sub(shading->corner[(e + 1) % 3].position, shading->corner[e].position, edge);
}

static void normal_setup_middle(struct shading *shading, unsigned e, const double middle[3])
{
    for (unsigned k = 0; k < 3; k++)
        quadratic_middle(&shading->normal[k], e, middle[k]);
}

void normal_setup_linear(struct shading *shading)
{
    for (unsigned v = 0; v < 3; v++)
        for (unsigned k = 0; k < 3; k++)
            shading->normal[k].corner[v] = shading->corner[v].normal[k];
    for (unsigned k = 0; k < 3; k++)
        memset(shading->normal[k].bulge, 0, sizeof shading->normal[k].bulge);
}

void normal_setup_overveld(struct shading *shading)
{
    normal_setup_linear(shading);
    for (unsigned e = 0; e < 3; e++) {
        double edge[3], middle[3];
        normal_edge(shading, e, edge);
        normal_along(shading->corner[e].normal, shading->corner[(e + 1) % 3].normal, edge, 1, .5, middle);
        normal_setup_middle(shading, e, middle);
    }
}

/* The surface between the ends has an inflection: both normals lean the same way along the edge (section 3.1). */
static bool normal_zigzag(const double n0[3], const double n1[3], const double edge[3])
{
    double upright = NORMAL_UPRIGHT * vec_length(edge), lean0 = vec_dot(n0, edge), lean1 = vec_dot(n1, edge);
    return fmin(lean0, lean1) > upright || fmax(lean0, lean1) < -upright;
}

/* `edge` projected on the plane of a and b; false if they are parallel. */
static bool normal_project(const double a[3], const double b[3], const double edge[3], double out[3])
{
    double across[3];
    vec_cross(a, b, across);
    if (vec_length(across) < NORMAL_PARALLEL)
        return false;
    vec_normalise(across);
    double off = vec_dot(edge, across);
    for (int k = 0; k < 3; k++)
        out[k] = edge[k] - off * across[k];
    return true;
}

/* G (section 3.2): the edge projected on the plane of its normals. Where these are parallel or the edge is nearly
 * perpendicular to that plane, the triangle's normal takes the place of the one that leans less along the edge, so that
 * b goes to zero when both become the triangle's; where G is short then too, it fades with it, so that it ends at 0
 * where its direction does. Returns which part of the bulge counts; 0: linear. */
static double normal_direction(const struct shading *shading, unsigned e, double out[3])
{
    const double *n0 = shading->corner[e].normal, *n1 = shading->corner[(e + 1) % 3].normal;
    double edge[3], next[3], face[3];
    normal_edge(shading, e, edge);
    if (!normal_zigzag(n0, n1, edge))
        return 0;
    if (normal_project(n0, n1, edge, out) && vec_length(out) >= NORMAL_ACROSS * vec_length(edge))
        return 1;
    normal_edge(shading, (e + 1) % 3, next);
    vec_cross(edge, next, face);
    vec_normalise(face);
    if (!normal_project(fabs(vec_dot(n0, edge)) > fabs(vec_dot(n1, edge)) ? n0 : n1, face, edge, out))
        return 0;
    return fmin(1, vec_length(out) / (NORMAL_SHORT * vec_length(edge)));
}

/* Linear but for its zigzag edges. */
void normal_setup_biquadratic(struct shading *shading)
{
    normal_setup_linear(shading);
    for (unsigned e = 0; e < 3; e++) {
        double direction[3] = {0, 0, 0}, middle[3];
        const double part = shading->edges >> e & 1u ? normal_direction(shading, e, direction) : 0;
        if (part == 0)
            continue;
        normal_along(shading->corner[e].normal, shading->corner[(e + 1) % 3].normal, direction, part, .5, middle);
        normal_setup_middle(shading, e, middle);
    }
}

void normal_pixel(const struct shading *shading, const double at[3], double colour[3])
{
    struct decode_vertex v = shading_mix(shading->corner, at);
    for (unsigned k = 0; k < 3; k++)
        v.normal[k] = quadratic_value(&shading->normal[k], at);
    vec_normalise(v.normal);
    shading_point(shading, v.position, v.normal, colour);
}

/* Where the row of pixels through `at` meets the triangle's outline, `t` away: before it (sign -1) or behind it (1).
 * There the normal is the edge's, not made unit: the original counts no root in its set-up. */
static double normal_crossing(const struct shading *shading, const double at[3], double sign, struct decode_vertex *v)
{
    double t = INFINITY, fall[3], edge[3]; /* of the coordinates on the way, to some scale */
    unsigned out = 0;                      /* the coordinate that becomes zero there */
    for (unsigned i = 0; i < 3; i++) {
        fall[i] = sign * (shading->place[(i + 1) % 3][1] - shading->place[(i + 2) % 3][1]);
        if (fall[i] > 0 && at[i] / fall[i] < t) {
            t = at[i] / fall[i];
            out = i;
        }
    }
    unsigned e = (out + 1) % 3;
    const struct decode_vertex *a = shading->corner + e, *b = shading->corner + (e + 1) % 3;
    double s = at[(e + 1) % 3] - t * fall[(e + 1) % 3];
    normal_edge(shading, e, edge);
    normal_along(a->normal, b->normal, edge, 1, s, v->normal);
    for (int k = 0; k < 3; k++)
        v->position[k] = a->position[k] + s * edge[k];
    return t;
}

/* van Overveld and Wyvill: one quadratic along each edge, and one along each row between the normals of the edges. */
void normal_pixel_scan(const struct shading *shading, const double at[3], double colour[3])
{
    struct decode_vertex from, to, v = shading_mix(shading->corner, at);
    double before = normal_crossing(shading, at, -1, &from), behind = normal_crossing(shading, at, 1, &to), span[3];
    double s = before + behind > 0 ? before / (before + behind) : 0;
    vec_sub(to.position, from.position, span);
    normal_along(from.normal, to.normal, span, 1, s, v.normal);
    vec_normalise(v.normal);
    shading_point(shading, v.position, v.normal, colour);
}

/* SPDX-License-Identifier: MIT */
#include "import/shape.h"

#include "scene/vec.h"

#include <math.h>
#include <string.h>

static const double turn = 6.283185307179586476925286766559;

/* (columns + 1) x (rows + 1) vertices from `first` on, column by column, become quads of two triangles. `flip` is for
 * grids whose columns x rows point inwards. */
static void quads(struct model_mesh *mesh, uint32_t first, unsigned columns, unsigned rows, bool flip)
{
    for (unsigned i = 0; i < columns; i++)
        for (unsigned j = 0; j < rows; j++) {
            uint32_t a = first + i * (rows + 1) + j, d = a + 1; /* (i, j) and (i, j + 1) */
            uint32_t b = a + rows + 1, c = b + 1;               /* (i + 1, j) and (i + 1, j + 1) */
            model_add_triangle(mesh, a, flip ? c : b, flip ? b : c, 0);
            model_add_triangle(mesh, a, flip ? d : c, flip ? c : d, 0);
        }
}

static void set_axis(double v[3], enum shape_axis axis)
{
    const double x = v[0], y = v[1], z = v[2];
    memcpy(v, axis == SHAPE_Y ? (double[]){x, z, y} : (double[]){z, x, y}, sizeof(double[3]));
}

/* Turns what was added since `vertex` and `triangle`, made around z, to the axis. Y is a reflection, so the corners
 * change their order; the diagonals stay. */
static void orient(struct model_mesh *mesh, size_t vertex, size_t triangle, enum shape_axis axis)
{
    if (axis == SHAPE_Z)
        return;
    for (size_t i = vertex; i < mesh->vertex_count; i++) { /* none: there may be no array */
        struct model_vertex *v = &mesh->vertices[i];
        set_axis(v->position, axis);
        set_axis(v->normal, axis);
        set_axis(v->tangent, axis);
    }
    for (size_t i = triangle; axis == SHAPE_Y && i < mesh->triangle_count; i++) {
        uint32_t *corner = mesh->triangles[i].corner, b = corner[1];
        corner[1] = corner[2];
        corner[2] = b;
    }
}

/* Adds a vertex and its tangent: around the axis at angle u. */
static void add_round(struct model_mesh *mesh, const double position[3], const double normal[3], double angle, double u,
                      double v)
{
    const double tangent[3] = {-sin(angle), cos(angle), 0};
    uint32_t index = model_add_vertex(mesh, position, normal, u, v);
    memcpy(mesh->vertices[index].tangent, tangent, sizeof tangent);
}

void shape_torus(struct model_mesh *mesh, enum shape_axis axis, double radius, double tube, unsigned rings,
                 unsigned sides)
{
    size_t vertex = mesh->vertex_count, triangle = mesh->triangle_count;
    for (unsigned i = 0; i <= rings; i++)
        for (unsigned j = 0; j <= sides; j++) {
            double u = turn * (i % rings) / rings, v = turn * (j % sides) / sides, r = radius + tube * cos(v);
            const double position[3] = {r * cos(u), r * sin(u), tube * sin(v)};
            const double normal[3] = {cos(v) * cos(u), cos(v) * sin(u), sin(v)};
            add_round(mesh, position, normal, u, (double)i / rings, (double)j / sides);
        }
    quads(mesh, (uint32_t)vertex, rings, sides, false);
    orient(mesh, vertex, triangle, axis);
}

void shape_sphere(struct model_mesh *mesh, enum shape_axis axis, double radius, unsigned slices, unsigned stacks)
{
    size_t vertex = mesh->vertex_count, triangle = mesh->triangle_count;
    for (unsigned i = 0; i <= slices; i++)
        for (unsigned j = 0; j <= stacks; j++) {
            double u = turn * (i % slices) / slices, v = turn / 2 * j / stacks;
            double s = j == stacks ? 0 : sin(v); /* the poles are points */
            const double normal[3] = {s * cos(u), s * sin(u), cos(v)};
            const double position[3] = {radius * normal[0], radius * normal[1], radius * normal[2]};
            add_round(mesh, position, normal, u, (double)i / slices, 1 - (double)j / stacks);
        }
    quads(mesh, (uint32_t)vertex, slices, stacks, true);
    orient(mesh, vertex, triangle, axis);
}

void shape_plane(struct model_mesh *mesh, enum shape_axis axis, const double size[2], unsigned segments)
{
    size_t vertex = mesh->vertex_count, triangle = mesh->triangle_count;
    for (unsigned i = 0; i <= segments; i++)
        for (unsigned j = 0; j <= segments; j++) {
            double u = (double)i / segments, v = (double)j / segments;
            const double position[3] = {size[0] * (u - .5), size[1] * (v - .5), 0};
            model_add_vertex(mesh, position, (const double[3]){0, 0, 1}, u, v);
        }
    quads(mesh, (uint32_t)vertex, segments, segments, false);
    orient(mesh, vertex, triangle, axis);
}

/* The outward unit normal (radial, axial) of the segment from point i on; false if it has no length. */
static bool segment_normal(const double (*profile)[2], size_t i, double out[3])
{
    out[0] = profile[i + 1][1] - profile[i][1];
    out[1] = profile[i][0] - profile[i + 1][0];
    out[2] = 0;
    return vec_normalise(out);
}

/* The normal at an end of a segment: with its neighbour's, if the two meet at less than the crease. */
static void end_normal(const double (*profile)[2], size_t points, size_t segment, size_t end, double crease,
                       double out[3])
{
    double own[3], other[3];
    const size_t last = points - 1;
    const bool closed = profile[0][0] == profile[last][0] && profile[0][1] == profile[last][1];
    segment_normal(profile, segment, own);
    memcpy(out, own, sizeof own);
    bool has_other = true;
    if (profile[end][0] == 0) /* the mirror image across the axis */
        memcpy(other, (double[]){-own[0], own[1], 0}, sizeof other);
    else if (closed || (end > 0 && end < last)) /* the segment before this one's start or after its end */
        has_other = segment_normal(profile, (segment + (segment == end ? last - 1 : 1)) % last, other);
    else
        has_other = false;
    if (has_other && vec_dot(own, other) > cos(crease))
        for (int k = 0; k < 2; k++)
            out[k] = own[k] + other[k];
}

void shape_revolve(struct model_mesh *mesh, enum shape_axis axis, const double (*profile)[2], size_t points,
                   unsigned slices, double crease)
{
    size_t vertex = mesh->vertex_count, triangle = mesh->triangle_count;
    double along[3];
    for (size_t s = 0; s + 1 < points; s++) {
        if (!segment_normal(profile, s, along))
            continue;
        uint32_t first = (uint32_t)mesh->vertex_count;
        for (unsigned i = 0; i <= slices; i++)
            for (size_t end = s; end <= s + 1; end++) {
                double u = turn * (i % slices) / slices, n[3];
                end_normal(profile, points, s, end, crease, n);
                vec_normalise(n);
                const double position[3] = {profile[end][0] * cos(u), profile[end][0] * sin(u), profile[end][1]};
                const double normal[3] = {n[0] * cos(u), n[0] * sin(u), n[1]};
                add_round(mesh, position, normal, u, (double)i / slices, (double)end / (double)(points - 1));
            }
        quads(mesh, first, slices, 1, false);
    }
    orient(mesh, vertex, triangle, axis);
}

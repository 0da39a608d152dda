/* SPDX-License-Identifier: MIT */
#include "reference/highlight.h"

#include "scene/vec.h"

#include <math.h>
#include <string.h>

/* The corners' values lie on both sides of zero, which itself counts as both. */
static bool highlight_between(const double value[3])
{
    return fmin(value[0], fmin(value[1], value[2])) <= 0 && fmax(value[0], fmax(value[1], value[2])) >= 0;
}

/* x|x| / |v|^2: the signed square of a cosine, for x = v.n and one n. */
static double highlight_square(const double v[3], double x)
{
    return x * fabs(x) / vec_dot(v, v);
}

struct highlight_sides highlight_sides(const struct decode_view *view, unsigned light,
                                       const struct decode_vertex *vertex)
{
    const struct decode_light *from = view->lights + light;
    const double *p = vertex->position, *n = vertex->normal;
    double to_light[3] = {from->vector[0], from->vector[1], from->vector[2]}, to_viewer[3] = {0, 0, 1}, across[3];
    if (from->point)
        vec_sub(from->vector, p, to_light);
    if (view->local_viewer)
        vec_sub((double[3]){0, 0, 0}, p, to_viewer);
    vec_cross(to_light, to_viewer, across);
    double lit = vec_dot(to_light, n), seen = vec_dot(to_viewer, n);
    return (struct highlight_sides){.h1 = vec_dot(across, n),
                                    .h2 = highlight_square(to_viewer, seen) - highlight_square(to_light, lit),
                                    .faces = lit >= 0 || seen >= 0};
}

bool highlight_under(const struct decode_view *view, unsigned light, const struct decode_vertex corner[3])
{
    double h1[3], h2[3];
    bool faces = false;
    for (unsigned v = 0; v < 3; v++) {
        struct highlight_sides sides = highlight_sides(view, light, corner + v);
        h1[v] = sides.h1;
        h2[v] = sides.h2;
        faces = faces || sides.faces;
    }
    return faces && highlight_between(h1) && highlight_between(h2);
}

bool highlight_possible(const struct decode_view *view, const struct decode_vertex corner[3])
{
    for (unsigned l = 0; l < view->light_count; l++)
        if (highlight_under(view, l, corner))
            return true;
    return false;
}

void highlight_mark(const struct decode_view *view, const struct scene_triangle *triangles, uint32_t count,
                    const struct decode_vertex *vertices, bool *reached, uint32_t vertex_count)
{
    memset(reached, 0, vertex_count * sizeof *reached);
    for (uint32_t t = 0; t < count; t++) {
        struct decode_vertex corner[3];
        for (unsigned i = 0; i < 3; i++)
            corner[i] = vertices[triangles[t].corner[i]];
        for (unsigned i = 0; highlight_possible(view, corner) && i < 3; i++)
            reached[triangles[t].corner[i]] = true;
    }
}

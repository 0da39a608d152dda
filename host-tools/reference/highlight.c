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

static bool highlight_under(const struct decode_view *view, const struct decode_light *light,
                            const struct decode_vertex corner[3])
{
    double plane[3], half[3];
    bool faces = false;
    for (int i = 0; i < 3; i++) {
        const double *p = corner[i].position, *n = corner[i].normal;
        double to_light[3] = {light->vector[0], light->vector[1], light->vector[2]}, to_viewer[3] = {0, 0, 1},
               across[3];
        if (light->point)
            vec_sub(light->vector, p, to_light);
        if (view->local_viewer)
            vec_sub((double[3]){0, 0, 0}, p, to_viewer);
        vec_cross(to_light, to_viewer, across);
        double lit = vec_dot(to_light, n), seen = vec_dot(to_viewer, n);
        plane[i] = vec_dot(across, n);
        half[i] = highlight_square(to_viewer, seen) - highlight_square(to_light, lit);
        faces = faces || lit >= 0 || seen >= 0;
    }
    return faces && highlight_between(plane) && highlight_between(half);
}

bool highlight_possible(const struct decode_view *view, const struct decode_vertex corner[3])
{
    for (unsigned l = 0; l < view->light_count; l++)
        if (highlight_under(view, view->lights + l, corner))
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

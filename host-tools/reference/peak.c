/* SPDX-License-Identifier: MIT */
#include "reference/peak.h"

#include "reference/highlight.h"
#include "reference/shading.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>

#define PEAK_HALVINGS    40
#define PEAK_REFINEMENTS 3

struct peak_search {
    const struct decode_view *view;
    const struct decode_vertex *corner;
    unsigned light;
};

/* On which side of a condition. */
static bool peak_below(const struct peak_search *s, const double at[3], bool second)
{
    struct decode_vertex v = shading_mix(s->corner, at);
    struct highlight_sides sides = highlight_sides(s->view, s->light, &v);
    return (second ? sides.h2 : sides.h1) < 0;
}

/* Where a condition changes from u's side to v's, which is the other. */
static void peak_solve(const struct peak_search *s, const double u[3], const double v[3], bool second, double out[3])
{
    double low = 0, high = 1;
    bool side = peak_below(s, u, second);
    for (int i = 0; i < PEAK_HALVINGS; i++) {
        double t = (low + high) / 2;
        for (int k = 0; k < 3; k++)
            out[k] = u[k] + t * (v[k] - u[k]);
        if (peak_below(s, out, second) == side)
            low = t;
        else
            high = t;
    }
}

/* P again: H1 along the line from corner a, where the edges of Q and R meet, through P; then H2 from there to Q or R.
 */
static void peak_refine(const struct peak_search *s, double ends[2][3], unsigned a, double at[3])
{
    double from[3] = {a == 0, a == 1, a == 2}, across[3], on[3];
    if (at[a] >= 1)
        return;
    for (unsigned k = 0; k < 3; k++)
        across[k] = k == a ? 0 : at[k] / (1 - at[a]);
    if (peak_below(s, from, false) == peak_below(s, across, false))
        return; /* the curve leaves the triangle between */
    peak_solve(s, from, across, false, on);
    const double *end = ends[peak_below(s, on, true) == peak_below(s, ends[0], true)];
    if (peak_below(s, on, true) != peak_below(s, end, true))
        peak_solve(s, on, end, true, at);
}

static double peak_cosine(const struct peak_search *s, const double at[3])
{
    struct decode_vertex v = shading_mix(s->corner, at);
    struct shading shading = {.view = s->view};
    double dots[2];
    vec_normalise(v.normal);
    shading_dots(&shading, s->light, v.position, v.normal, dots);
    return dots[1];
}

struct peak peak_find(const struct decode_view *view, unsigned light, const struct decode_vertex corner[3])
{
    const struct peak_search s = {view, corner, light};
    static const double at[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct peak peak = {.kind = PEAK_NONE};
    double ends[2][3];
    bool side[3];
    for (unsigned v = 0; v < 3; v++)
        side[v] = peak_below(&s, at[v], false);
    if (side[0] == side[1] && side[1] == side[2])
        return peak;
    unsigned a = side[1] == side[2] ? 0 : side[0] == side[2] ? 1 : 2, b = (a + 1) % 3, c = (a + 2) % 3;
    peak_solve(&s, at[a], at[b], false, ends[0]);
    peak_solve(&s, at[a], at[c], false, ends[1]);
    if (peak_below(&s, ends[0], true) != peak_below(&s, ends[1], true)) {
        peak.kind = PEAK_INSIDE;
        peak_solve(&s, ends[0], ends[1], true, peak.at);
        for (int i = 0; i < PEAK_REFINEMENTS; i++)
            peak_refine(&s, ends, a, peak.at);
        return peak;
    }
    bool second = peak_cosine(&s, ends[0]) < peak_cosine(&s, ends[1]);
    peak.kind = PEAK_EDGE;
    memcpy(peak.at, ends[second], sizeof peak.at);
    return peak;
}

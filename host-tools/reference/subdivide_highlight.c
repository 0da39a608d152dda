/* SPDX-License-Identifier: MIT */
/*
 * Highlight subdivision ("Improved Specular Highlights with Adaptive Shading", 3.1): a new corner at the highlight's
 * centre splits a triangle into 3, or where that lies outside, one on an edge into 2; a neighbour without one takes its
 * brightest corner instead. Then the edges that meet there are halved towards it while the colour in their middle is
 * not what linear interpolation makes of it.
 */
#include "reference/highlight.h"
#include "reference/method.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>

/* How often an edge is halved at most, and the pixels, one way or the other, below which it is not. */
#define SUBDIVIDE_HALVINGS 5
#define SUBDIVIDE_LENGTH   4
/* The difference that counts, as a part of the true colour (section 4). */
#define SUBDIVIDE_THRESHOLD .3

/* A place in the triangle, and the true colour there. */
struct subdivide_corner {
    double at[3], colour[3];
};

static struct subdivide_corner subdivide_at(const struct shading *shading, const double at[3])
{
    struct decode_vertex v = shading_mix(shading->corner, at);
    struct subdivide_corner corner = {.at = {at[0], at[1], at[2]}};
    vec_normalise(v.normal);
    shading_point(shading, v.position, v.normal, corner.colour);
    return corner;
}

static double subdivide_brightness(const struct shading *shading, const double at[3])
{
    struct subdivide_corner corner = subdivide_at(shading, at);
    double sum = 0;
    for (unsigned c = 0; c < shading->channels; c++)
        sum += corner.colour[c];
    return sum;
}

/* The brightest of the lights that can have one here; the brightest corner if none has. */
void subdivide_setup_highlight(struct shading *shading)
{
    static const double corner[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct peak *peak = &shading->peak;
    if (!shading->highlight) {
        shading->method = methods + REFERENCE_GOURAUD;
        shading->method->setup(shading);
        return;
    }
    peak->kind = PEAK_NONE;
    for (unsigned l = 0; l < shading->view->light_count; l++) {
        if (!highlight_under(shading->view, l, shading->corner))
            continue;
        struct peak found = peak_find(shading->view, l, shading->corner);
        if (found.kind != PEAK_NONE && (peak->kind == PEAK_NONE || subdivide_brightness(shading, found.at) >
                                                                       subdivide_brightness(shading, peak->at)))
            *peak = found;
    }
    if (peak->kind != PEAK_NONE)
        return;
    memcpy(peak->at, corner[0], sizeof peak->at);
    for (unsigned v = 1; v < 3; v++)
        if (subdivide_brightness(shading, corner[v]) > subdivide_brightness(shading, peak->at))
            memcpy(peak->at, corner[v], sizeof peak->at);
}

/* Barycentric coordinates of `at` in the part a, b, c; the smallest of them. Outside it is negative, in a part without
 * area -infinity. */
static double subdivide_inside(const struct subdivide_corner part[3], const double at[3], double out[3])
{
    double across[3], least = INFINITY;
    vec_cross(part[1].at, part[2].at, across);
    double whole = vec_dot(part[0].at, across);
    if (fabs(whole) < 1e-12)
        return -INFINITY;
    for (unsigned k = 0; k < 3; k++) {
        vec_cross(part[(k + 1) % 3].at, part[(k + 2) % 3].at, across);
        out[k] = vec_dot(at, across) / whole;
        least = fmin(least, out[k]);
    }
    return least;
}

/* Halves the edge from the peak to `end`; false if it is left whole. */
static bool subdivide_halve(const struct shading *shading, const struct subdivide_corner *peak,
                            const struct subdivide_corner *end, struct subdivide_corner *middle)
{
    double at[3], length[2] = {0, 0};
    bool differs = false;
    for (unsigned k = 0; k < 3; k++) {
        at[k] = (peak->at[k] + end->at[k]) / 2;
        for (unsigned i = 0; i < 2; i++)
            length[i] += (peak->at[k] - end->at[k]) * shading->place[k][i];
    }
    if (fabs(length[0]) < SUBDIVIDE_LENGTH && fabs(length[1]) < SUBDIVIDE_LENGTH)
        return false;
    *middle = subdivide_at(shading, at);
    for (unsigned c = 0; c < shading->channels; c++)
        differs = differs || fabs((peak->colour[c] + end->colour[c]) / 2 - middle->colour[c]) >
                                 SUBDIVIDE_THRESHOLD * middle->colour[c];
    return differs;
}

/* The part of a peak and two corners in which `at` lies: what a new corner cuts off, or what is left at the peak. */
static void subdivide_narrow(const struct shading *shading, struct subdivide_corner part[3], const double at[3])
{
    unsigned left[3] = {0, SUBDIVIDE_HALVINGS, SUBDIVIDE_HALVINGS};
    double inside[3];
    while (left[1] || left[2]) {
        for (unsigned k = 1; k < 3; k++) {
            struct subdivide_corner middle;
            if (!left[k])
                continue;
            if (!subdivide_halve(shading, &part[0], &part[k], &middle)) {
                left[k] = 0;
                continue;
            }
            const struct subdivide_corner cut[3] = {middle, part[1], part[2]};
            if (subdivide_inside(cut, at, inside) >= 0) {
                memcpy(part, cut, sizeof cut);
                return;
            }
            part[k] = middle;
            left[k]--;
        }
    }
}

void subdivide_pixel_highlight(const struct shading *shading, const double at[3], double colour[3])
{
    const struct subdivide_corner peak = subdivide_at(shading, shading->peak.at);
    struct subdivide_corner found[3] = {peak, peak, peak};
    double inside[3] = {1, 0, 0}, most = -INFINITY;
    for (unsigned e = 0; e < 3; e++) {
        double ends[2][3] = {{e == 0, e == 1, e == 2}, {e == 2, e == 0, e == 1}};
        struct subdivide_corner part[3] = {peak, subdivide_at(shading, ends[0]), subdivide_at(shading, ends[1])};
        double least = subdivide_inside(part, at, inside);
        if (least > most) {
            most = least;
            memcpy(found, part, sizeof found);
        }
    }
    subdivide_narrow(shading, found, at);
    subdivide_inside(found, at, inside);
    for (unsigned c = 0; c < shading->channels; c++)
        colour[c] = inside[0] * found[0].colour[c] + inside[1] * found[1].colour[c] + inside[2] * found[2].colour[c];
}

/* SPDX-License-Identifier: MIT */
/*
 * Methods that treat a part of a mesh better: smaller triangles, or another method. A pixel finds the small triangle it
 * lies in by walking down from the whole one, so that nothing is stored and no pixel is lost where sizes meet.
 */
#include "reference/method.h"

#include "scene/vec.h"

#include <math.h>
#include <string.h>

/* How often an edge is halved at most. */
#define SUBDIVIDE_DEPTH 5

/* Into the quarter where `at` lies: that of a corner, or the one between the middles of the edges. Normals are halved
 * as they are: a part's are those of the whole triangle, linear in the picture, and its limit is phong-screen. */
static void subdivide_descend(struct shading *part, double at[3])
{
    struct decode_vertex middle[3];
    for (unsigned e = 0; e < 3; e++)
        middle[e] = shading_middle(part->corner, e);
    for (unsigned i = 0; i < 3; i++) {
        if (at[i] < .5)
            continue;
        part->corner[(i + 1) % 3] = middle[i];
        part->corner[(i + 2) % 3] = middle[(i + 2) % 3];
        for (unsigned k = 0; k < 3; k++)
            at[k] = 2 * at[k] - (k == i);
        return;
    }
    const double between[3] = {1 - 2 * at[2], 1 - 2 * at[0], 1 - 2 * at[1]};
    memcpy(part->corner, middle, sizeof middle);
    memcpy(at, between, sizeof between);
}

/* In pixels. */
static double subdivide_area(const struct shading *shading)
{
    const double *a = shading->place[0], *b = shading->place[1], *c = shading->place[2];
    return fabs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

/* Pseudo-Phong: linear colours in parts of at most `part_area`. */
void subdivide_pixel_size(const struct shading *shading, const double at[3], double colour[3])
{
    struct shading part = *shading;
    double inside[3] = {at[0], at[1], at[2]}, area = subdivide_area(shading);
    for (unsigned depth = 0; depth < SUBDIVIDE_DEPTH && area > shading->part_area; depth++, area /= 4)
        subdivide_descend(&part, inside);
    colour_setup_part(&part, false);
    colour_pixel(&part, inside, colour);
}

/* "Quadratic Interpolation in Hardware Rendering", section 3: is the quadratic wrong in the triangle's centre by more
 * than the tolerance? */
static bool subdivide_off_centre(const struct shading *part)
{
    static const double centre[3] = {1 / 3., 1 / 3., 1 / 3.};
    struct decode_vertex v = shading_mix(part->corner, centre);
    double colour[3], error = 0;
    vec_normalise(v.normal);
    shading_point(part, v.position, v.normal, colour);
    for (unsigned c = 0; c < part->channels; c++)
        error = fmax(error, fabs(colour[c] - quadratic_value(&part->colour[c], centre)));
    return error > part->tolerance;
}

void subdivide_pixel_centre(const struct shading *shading, const double at[3], double colour[3])
{
    struct shading part = *shading;
    double inside[3] = {at[0], at[1], at[2]};
    for (unsigned depth = 0; depth < SUBDIVIDE_DEPTH && subdivide_off_centre(&part); depth++) {
        subdivide_descend(&part, inside);
        colour_setup_part(&part, true);
    }
    colour_pixel(&part, inside, colour);
}

/* The triangle's method from here on. */
static void subdivide_choose(struct shading *shading, enum reference_method method)
{
    shading->method = methods + method;
    shading->method->setup(shading);
}

void subdivide_setup_regular(struct shading *shading)
{
    subdivide_choose(shading, shading->highlight ? REFERENCE_SUBDIVIDE_RECURSIVE : REFERENCE_GOURAUD);
}

void subdivide_setup_hybrid_phong(struct shading *shading)
{
    subdivide_choose(shading, shading->highlight ? REFERENCE_PHONG : REFERENCE_GOURAUD);
}

void subdivide_setup_hybrid_x(struct shading *shading)
{
    subdivide_choose(shading, shading->highlight ? REFERENCE_X : REFERENCE_GOURAUD);
}

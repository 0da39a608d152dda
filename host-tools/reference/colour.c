/* SPDX-License-Identifier: MIT */
/* Methods that interpolate finished colour. */
#include "reference/method.h"

#include "scene/vec.h"

#include <math.h>

/* Normals of the mesh are taken as packed, others made unit. */
static void colour_corners(struct shading *shading, bool packed)
{
    for (unsigned v = 0; v < 3; v++) {
        struct decode_vertex corner = shading->corner[v];
        double colour[3];
        if (!packed)
            vec_normalise(corner.normal);
        shading_point(shading, corner.position, corner.normal, colour);
        for (unsigned c = 0; c < shading->channels; c++) {
            shading->colour[c].corner[v] = colour[c];
            shading->colour[c].bulge[v] = 0;
        }
    }
}

static void colour_middles(struct shading *shading)
{
    for (unsigned e = 0; e < 3; e++) {
        struct decode_vertex middle = shading_middle(shading->corner, e);
        double colour[3];
        vec_normalise(middle.normal);
        shading_point(shading, middle.position, middle.normal, colour);
        for (unsigned c = 0; c < shading->channels; c++)
            quadratic_middle(&shading->colour[c], e, colour[c]);
    }
}

/* Gouraud: the corners' colours, linear. */
void colour_setup_linear(struct shading *shading)
{
    colour_corners(shading, true);
}

/* "Quadratic Interpolation in Hardware Rendering", section 2: the middles' colours too, with true unit normals. */
void colour_setup_quadratic(struct shading *shading)
{
    colour_corners(shading, true);
    colour_middles(shading);
}

void colour_setup_part(struct shading *shading, bool quadratic)
{
    colour_corners(shading, false);
    if (quadratic)
        colour_middles(shading);
}

/* A quadratic through six samples in 0..1 can reach from -1/3 to 4/3. */
void colour_pixel(const struct shading *shading, const double at[3], double colour[3])
{
    for (unsigned c = 0; c < shading->channels; c++)
        colour[c] = fmin(1, fmax(0, quadratic_value(&shading->colour[c], at)));
}

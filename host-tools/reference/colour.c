/* SPDX-License-Identifier: MIT */
/* Methods that interpolate finished colour. */
#include "reference/method.h"

#include "scene/vec.h"

#include <math.h>

/* Gouraud: the corners' colours, linear. */
void colour_setup_linear(struct shading *shading)
{
    for (unsigned v = 0; v < 3; v++) {
        double colour[3];
        shading_point(shading, shading->corner[v].position, shading->corner[v].normal, colour);
        for (unsigned c = 0; c < shading->channels; c++) {
            shading->colour[c].corner[v] = colour[c];
            shading->colour[c].bulge[v] = 0;
        }
    }
}

/* "Quadratic Interpolation in Hardware Rendering", section 2: the middles' colours too, with true unit normals. */
void colour_setup_quadratic(struct shading *shading)
{
    colour_setup_linear(shading);
    for (unsigned e = 0; e < 3; e++) {
        struct decode_vertex middle = shading_middle(shading->corner, e);
        double colour[3];
        vec_normalise(middle.normal);
        shading_point(shading, middle.position, middle.normal, colour);
        for (unsigned c = 0; c < shading->channels; c++)
            quadratic_middle(&shading->colour[c], e, colour[c]);
    }
}

/* A quadratic through six samples in 0..1 can reach from -1/3 to 4/3. */
void colour_pixel(const struct shading *shading, const double at[3], double colour[3])
{
    for (unsigned c = 0; c < shading->channels; c++)
        colour[c] = fmin(1, fmax(0, quadratic_value(&shading->colour[c], at)));
}

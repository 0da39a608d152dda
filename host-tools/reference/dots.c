/* SPDX-License-Identifier: MIT */
/* Methods that interpolate N.L and N.H of each light; clamp and power per pixel. */
#include "reference/method.h"

#include "scene/vec.h"

#include <math.h>

static void dots_setup_corners(struct shading *shading)
{
    for (unsigned l = 0; l < shading->view->light_count; l++) {
        for (unsigned v = 0; v < 3; v++) {
            double dots[2];
            shading_dots(shading, l, shading->corner[v].position, shading->corner[v].normal, dots);
            shading->dot[l][0].corner[v] = dots[0];
            shading->dot[l][1].corner[v] = dots[1];
        }
    }
}

static void dots_setup_middle(struct shading *shading, unsigned e, const struct decode_vertex *middle)
{
    for (unsigned l = 0; l < shading->view->light_count; l++) {
        double dots[2];
        shading_dots(shading, l, middle->position, middle->normal, dots);
        quadratic_middle(&shading->dot[l][0], e, dots[0]);
        quadratic_middle(&shading->dot[l][1], e, dots[1]);
    }
}

/* X-shading (eq. 27): in the middle of an edge the normal (N1 + N2)(5 - N1.N2)/8. */
void dots_setup_x(struct shading *shading)
{
    dots_setup_corners(shading);
    for (unsigned e = 0; e < 3; e++) {
        struct decode_vertex middle = shading_middle(shading->corner, e);
        for (int k = 0; k < 3; k++)
            middle.normal[k] *= 1 + shading->bend[e] / 2;
        dots_setup_middle(shading, e, &middle);
    }
}

/* X-shading, eq. 1-6: the true unit normal. */
void dots_setup_six(struct shading *shading)
{
    dots_setup_corners(shading);
    for (unsigned e = 0; e < 3; e++) {
        struct decode_vertex middle = shading_middle(shading->corner, e);
        vec_normalise(middle.normal);
        dots_setup_middle(shading, e, &middle);
    }
}

void dots_pixel(const struct shading *shading, const double at[3], double colour[3])
{
    double dots[SCENE_MAX_LIGHTS][2];
    for (unsigned l = 0; l < shading->view->light_count; l++)
        for (unsigned d = 0; d < 2; d++)
            dots[l][d] = quadratic_value(&shading->dot[l][d], at);
    shading_colour(shading, dots, colour);
}

/* Duff: the dot products of the linear normal N and its squared length, which is a quadratic exactly. With the middle
 * normal as it is the products are linear where light and viewer are far away, and else a quadratic. */
void dots_setup_duff(struct shading *shading)
{
    dots_setup_corners(shading);
    for (unsigned v = 0; v < 3; v++)
        shading->square.corner[v] = vec_dot(shading->corner[v].normal, shading->corner[v].normal);
    for (unsigned e = 0; e < 3; e++) {
        struct decode_vertex middle = shading_middle(shading->corner, e);
        dots_setup_middle(shading, e, &middle);
        quadratic_middle(&shading->square, e, vec_dot(middle.normal, middle.normal));
    }
}

void dots_pixel_duff(const struct shading *shading, const double at[3], double colour[3])
{
    double dots[SCENE_MAX_LIGHTS][2], square = quadratic_value(&shading->square, at);
    double scale = square > 0 ? 1 / sqrt(square) : 0; /* opposite normals may meet in zero */
    for (unsigned l = 0; l < shading->view->light_count; l++)
        for (unsigned d = 0; d < 2; d++)
            dots[l][d] = scale * quadratic_value(&shading->dot[l][d], at);
    shading_colour(shading, dots, colour);
}

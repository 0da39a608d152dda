/* SPDX-License-Identifier: MIT */
#include "reference/shading.h"

#include "scene/vec.h"

#include <math.h>
#include <string.h>

/* The directions towards the light and half-way to the viewer, unit, at a point. */
static void shading_directions(const struct decode_view *view, const struct decode_light *light, const double point[3],
                               double towards[2][3])
{
    double viewer[3] = {0, 0, 1};
    memcpy(towards[0], light->vector, sizeof towards[0]);
    if (light->point) {
        vec_sub(light->vector, point, towards[0]);
        vec_normalise(towards[0]);
    }
    if (view->local_viewer) {
        for (int i = 0; i < 3; i++)
            viewer[i] = -point[i];
        vec_normalise(viewer);
    }
    for (int i = 0; i < 3; i++)
        towards[1][i] = towards[0][i] + viewer[i];
    vec_normalise(towards[1]);
}

static void shading_dots(const struct decode_view *view, unsigned light, const double point[3], const double normal[3],
                         double dots[2])
{
    double towards[2][3];
    shading_directions(view, view->lights + light, point, towards);
    dots[0] = vec_dot(normal, towards[0]);
    dots[1] = vec_dot(normal, towards[1]);
}

/* The colour for the dot products of every light. Clamped here, after interpolation: a dot product between corners may
 * rightly be negative, and interpolated it may pass 1. */
static void shading_colour(const struct shading *shading, double dots[][2], double colour[3])
{
    for (unsigned c = 0; c < shading->channels; c++)
        colour[c] = shading->ambient[c];
    for (unsigned l = 0; l < shading->view->light_count; l++) {
        double diffuse = fmax(0, dots[l][0]);
        double specular = dots[l][1] > 0 ? pow(fmin(1, dots[l][1]), shading->shininess) : 0;
        for (unsigned c = 0; c < shading->channels; c++)
            colour[c] += shading->diffuse[l][c] * diffuse + shading->specular[l][c] * specular;
    }
    for (unsigned c = 0; c < shading->channels; c++)
        colour[c] = fmin(1, colour[c]);
}

static void shading_mix(const double at[3][3], const double weight[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = weight[0] * at[0][i] + weight[1] * at[1][i] + weight[2] * at[2][i];
}

/* The dot products at the middle of the edge from corner i to j. X (eq. 16): with the normal
 * (N1 + N2)(5 - N1.N2)/8; six: with the true unit normal. */
static void shading_middle(const struct shading *shading, unsigned light, unsigned i, unsigned j, double bend,
                           double dots[2])
{
    const struct decode_vertex *a = shading->corner + i, *b = shading->corner + j;
    double point[3], normal[3];
    for (int k = 0; k < 3; k++) {
        point[k] = (a->position[k] + b->position[k]) / 2;
        normal[k] = (a->normal[k] + b->normal[k]) / 2;
    }
    if (shading->method == REFERENCE_SIX)
        vec_normalise(normal);
    else
        for (int k = 0; k < 3; k++)
            normal[k] *= 1 + bend / 2;
    shading_dots(shading->view, light, point, normal, dots);
}

static void shading_setup_dots(struct shading *shading, unsigned light, const double bend[3])
{
    for (unsigned v = 0; v < 3; v++) {
        double dots[2];
        shading_dots(shading->view, light, shading->corner[v].position, shading->corner[v].normal, dots);
        shading->dot[light][0][v] = dots[0];
        shading->dot[light][1][v] = dots[1];
    }
    for (unsigned e = 0; e < 3; e++) {
        unsigned i = e, j = (e + 1) % 3;
        double dots[2];
        shading_middle(shading, light, i, j, bend[e], dots);
        for (unsigned d = 0; d < 2; d++)
            shading->bulge[light][d][e] = 4 * (dots[d] - (shading->dot[light][d][i] + shading->dot[light][d][j]) / 2);
    }
}

void shading_channels(const double rgb[3], unsigned channels, double *out)
{
    if (channels == 1)
        out[0] = .299 * rgb[0] + .587 * rgb[1] + .114 * rgb[2];
    else
        memcpy(out, rgb, 3 * sizeof *out);
}

static void shading_setup_colours(struct shading *shading, const struct decode_material *material)
{
    shading_channels(material->ambient, shading->channels, shading->ambient);
    for (unsigned l = 0; l < shading->view->light_count; l++) {
        double diffuse[3], specular[3];
        for (unsigned c = 0; c < 3; c++) {
            diffuse[c] = material->diffuse[c] * shading->view->lights[l].colour[c];
            specular[c] = material->specular[c] * shading->view->lights[l].colour[c];
        }
        shading_channels(diffuse, shading->channels, shading->diffuse[l]);
        shading_channels(specular, shading->channels, shading->specular[l]);
    }
    shading->shininess = material->shininess;
}

void shading_setup(struct shading *shading, const struct decode_view *view, const struct decode_material *material,
                   unsigned channels, enum reference_method method, const struct decode_vertex corner[3],
                   const double bend[3])
{
    shading->view = view;
    shading->channels = channels;
    shading->method = method;
    memcpy(shading->corner, corner, sizeof shading->corner);
    shading_setup_colours(shading, material);
    if (method == REFERENCE_PHONG)
        return;
    for (unsigned l = 0; l < view->light_count; l++)
        shading_setup_dots(shading, l, bend);
    for (unsigned v = 0; v < 3 && method == REFERENCE_GOURAUD; v++) {
        double dots[SCENE_MAX_LIGHTS][2];
        for (unsigned l = 0; l < view->light_count; l++) {
            dots[l][0] = shading->dot[l][0][v];
            dots[l][1] = shading->dot[l][1][v];
        }
        shading_colour(shading, dots, shading->colour[v]);
    }
}

static void shading_phong(const struct shading *shading, const double space[3], double dots[][2])
{
    const struct decode_vertex *corner = shading->corner;
    double position[3], normal[3];
    for (int i = 0; i < 3; i++) {
        position[i] = normal[i] = 0;
        for (int v = 0; v < 3; v++) {
            position[i] += space[v] * corner[v].position[i];
            normal[i] += space[v] * corner[v].normal[i];
        }
    }
    vec_normalise(normal);
    for (unsigned l = 0; l < shading->view->light_count; l++)
        shading_dots(shading->view, l, position, normal, dots[l]);
}

/* The quadratic through the corners and the middles of the edges. */
static double shading_quadratic(const double dot[3], const double bulge[3], const double at[3])
{
    return at[0] * dot[0] + at[1] * dot[1] + at[2] * dot[2] + at[0] * at[1] * bulge[0] + at[1] * at[2] * bulge[1] +
           at[2] * at[0] * bulge[2];
}

void shading_pixel(const struct shading *shading, const double screen[3], const double space[3], double colour[3])
{
    double dots[SCENE_MAX_LIGHTS][2];
    if (shading->method == REFERENCE_GOURAUD) {
        shading_mix(shading->colour, screen, colour);
        return;
    }
    if (shading->method == REFERENCE_PHONG)
        shading_phong(shading, space, dots);
    else
        for (unsigned l = 0; l < shading->view->light_count; l++)
            for (unsigned d = 0; d < 2; d++)
                dots[l][d] = shading_quadratic(shading->dot[l][d], shading->bulge[l][d], screen);
    shading_colour(shading, dots, colour);
}

/* SPDX-License-Identifier: MIT */
#include "reference/shading.h"

#include "reference/bump.h"
#include "reference/method.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>

void shading_channels(const double rgb[3], unsigned channels, double *out)
{
    if (channels == 1)
        out[0] = .299 * rgb[0] + .587 * rgb[1] + .114 * rgb[2];
    else
        memcpy(out, rgb, 3 * sizeof *out);
}

void shading_material(struct shading *shading, const struct decode_view *view, const struct decode_material *material,
                      unsigned channels)
{
    shading->view = view;
    shading->texel[0] = shading->texel[1] = shading->texel[2] = 1;
    shading->channels = channels;
    shading->shininess = material->shininess;
    shading->bumped = material->bump.head != NULL;
    shading_channels(material->ambient, channels, shading->ambient);
    for (unsigned l = 0; l < view->light_count; l++) {
        double diffuse[3], specular[3];
        for (unsigned c = 0; c < 3; c++) {
            diffuse[c] = material->diffuse[c] * view->lights[l].colour[c];
            specular[c] = material->specular[c] * view->lights[l].colour[c];
        }
        shading_channels(diffuse, channels, shading->diffuse[l]);
        shading_channels(specular, channels, shading->specular[l]);
    }
}

void shading_setup(struct shading *shading, const struct method *method, const struct decode_vertex corner[3],
                   const double bend[3], double place[3][2])
{
    shading->method = method;
    memcpy(shading->corner, corner, sizeof shading->corner);
    memcpy(shading->bend, bend, sizeof shading->bend);
    memcpy(shading->place, place, sizeof shading->place);
    shading->bumped = shading->bumped && method->bump != BUMP_NONE;
    if (shading->bumped)
        bump_setup(shading, method->bump);
    else
        method->setup(shading);
}

void shading_directions(const struct decode_view *view, const struct decode_light *light, const double point[3],
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

void shading_dots(const struct shading *shading, unsigned light, const double position[3], const double normal[3],
                  double dots[2])
{
    double towards[2][3];
    shading_directions(shading->view, shading->view->lights + light, position, towards);
    dots[0] = vec_dot(normal, towards[0]);
    dots[1] = vec_dot(normal, towards[1]);
}

void shading_colour(const struct shading *shading, double dots[][2], double colour[3])
{
    for (unsigned c = 0; c < shading->channels; c++)
        colour[c] = shading->texel[c] * shading->ambient[c];
    for (unsigned l = 0; l < shading->view->light_count; l++) {
        double diffuse = fmax(0, dots[l][0]);
        double specular = dots[l][1] > 0 ? pow(fmin(1, dots[l][1]), shading->shininess) : 0;
        for (unsigned c = 0; c < shading->channels; c++)
            colour[c] += shading->texel[c] * shading->diffuse[l][c] * diffuse + shading->specular[l][c] * specular;
    }
    for (unsigned c = 0; c < shading->channels; c++)
        colour[c] = fmin(1, colour[c]);
}

void shading_point(const struct shading *shading, const double position[3], const double normal[3], double colour[3])
{
    double dots[SCENE_MAX_LIGHTS][2];
    for (unsigned l = 0; l < shading->view->light_count; l++)
        shading_dots(shading, l, position, normal, dots[l]);
    shading_colour(shading, dots, colour);
}

struct decode_vertex shading_mix(const struct decode_vertex corner[3], const double at[3])
{
    struct decode_vertex v;
    for (int k = 0; k < 3; k++) {
        v.position[k] = at[0] * corner[0].position[k] + at[1] * corner[1].position[k] + at[2] * corner[2].position[k];
        v.normal[k] = at[0] * corner[0].normal[k] + at[1] * corner[1].normal[k] + at[2] * corner[2].normal[k];
    }
    return v;
}

struct decode_vertex shading_middle(const struct decode_vertex corner[3], unsigned e)
{
    const struct decode_vertex *a = corner + e, *b = corner + (e + 1) % 3;
    struct decode_vertex v;
    for (int k = 0; k < 3; k++) {
        v.position[k] = (a->position[k] + b->position[k]) / 2;
        v.normal[k] = (a->normal[k] + b->normal[k]) / 2;
    }
    return v;
}

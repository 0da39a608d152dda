/* SPDX-License-Identifier: MIT */
#include "reference/bump.h"

#include "reference/texture.h"
#include "scene/texel.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>

/* x and y of a texel, as it has them, times a weight. */
static void bump_texel(const struct decode_texture *map, double column, double row, double weight, double xy[2])
{
    const uint32_t texel = texture_nearest(map, column, row);
    xy[0] += weight * ((int)(texel >> 8 & 0xff) - 128);
    xy[1] += weight * ((int)(texel & 0xff) - 128);
}

void bump_normal(const struct decode_texture *map, double u, double v, double normal[3])
{
    const struct scene_texture *head = map->head;
    const uint16_t *rises = scene_at(map->scene, head->palette);
    double x = ldexp(u, head->log2_width) + map->nudge[0], y = ldexp(v, head->log2_height) + map->nudge[1],
           xy[2] = {0, 0}, at;
    if (head->flags & TEXTURE_BILINEAR) {
        const double column = floor(x - .5), row = floor(y - .5), right = x - .5 - column, up = y - .5 - row;
        bump_texel(map, column, row, (1 - right) * (1 - up), xy);
        bump_texel(map, column + 1, row, right * (1 - up), xy);
        bump_texel(map, column, row + 1, (1 - right) * up, xy);
        bump_texel(map, column + 1, row + 1, right * up, xy);
        at = fmax(0, (xy[0] * xy[0] + xy[1] * xy[1]) / 128 - .5); /* entries are for the middles of their steps */
    } else {
        bump_texel(map, x, y, 1, xy);
        at = floor((xy[0] * xy[0] + xy[1] * xy[1]) / 128);
    }
    const uint16_t *rise = rises + (int)at;
    normal[0] = ldexp(xy[0] * head->steepness, -21);
    normal[1] = ldexp(xy[1] * head->steepness, -21);
    normal[2] = ldexp(rise[0] + (rise[1] - rise[0]) * (at - floor(at)), -14);
}

/* Both directions of a light in the frame of a vertex. */
static void bump_turn(const struct shading *shading, unsigned light, const struct decode_vertex *vertex,
                      double out[2][3])
{
    double towards[2][3], across[3];
    shading_directions(shading->view, shading->view->lights + light, vertex->position, towards);
    vec_cross(vertex->normal, vertex->tangent, across);
    for (int which = 0; which < 2; which++) {
        out[which][0] = vec_dot(vertex->tangent, towards[which]);
        out[which][1] = vertex->sign * vec_dot(across, towards[which]);
        out[which][2] = vec_dot(vertex->normal, towards[which]);
    }
}

/* The frame in the middle of an edge, of its ends' averages. */
static struct decode_vertex bump_middle(const struct shading *shading, unsigned e, bool upright)
{
    const struct decode_vertex *a = shading->corner + e, *b = shading->corner + (e + 1) % 3;
    struct decode_vertex v = shading_middle(shading->corner, e);
    vec_normalise(v.normal);
    for (int k = 0; k < 3; k++)
        v.tangent[k] = (a->tangent[k] + b->tangent[k]) / 2;
    vec_normalise(v.tangent);
    const double lean = upright ? vec_dot(v.normal, v.tangent) : 0;
    for (int k = 0; k < 3; k++)
        v.tangent[k] -= lean * v.normal[k];
    vec_normalise(v.tangent);
    v.sign = a->sign;
    return v;
}

static void bump_setup_edge(struct shading *shading, unsigned light, unsigned e, enum bump_kind kind)
{
    double middle[2][3] = {{0, 0, 0}, {0, 0, 0}};
    struct decode_vertex frame;
    if (kind == BUMP_FRAMES || kind == BUMP_UPRIGHT) {
        frame = bump_middle(shading, e, kind == BUMP_UPRIGHT);
        bump_turn(shading, light, &frame, middle);
    }
    for (int which = 0; which < 2; which++) {
        struct quadratic *q = shading->turned[light][which];
        for (int k = 0; k < 3 && kind == BUMP_QUADRATIC; k++)
            middle[which][k] = q[k].corner[e] + q[k].corner[(e + 1) % 3];
        if (kind == BUMP_QUADRATIC)
            vec_normalise(middle[which]);
        for (int k = 0; k < 3; k++)
            quadratic_middle(&q[k], e, middle[which][k]);
    }
}

void bump_setup(struct shading *shading, enum bump_kind kind)
{
    for (unsigned l = 0; l < shading->view->light_count; l++) {
        memset(shading->turned[l], 0, sizeof shading->turned[l]);
        for (unsigned v = 0; v < 3; v++) {
            double turned[2][3];
            bump_turn(shading, l, shading->corner + v, turned);
            for (int which = 0; which < 2; which++)
                for (int k = 0; k < 3; k++)
                    shading->turned[l][which][k].corner[v] = turned[which][k];
        }
        for (unsigned e = 0; e < 3 && kind >= BUMP_QUADRATIC; e++)
            bump_setup_edge(shading, l, e, kind);
    }
}

void bump_pixel(const struct shading *shading, enum bump_kind kind, const double at[3], double colour[3])
{
    double dots[SCENE_MAX_LIGHTS][2];
    for (unsigned l = 0; l < shading->view->light_count; l++)
        for (int which = 0; which < 2; which++) {
            double v[3];
            for (int k = 0; k < 3; k++)
                v[k] = quadratic_value(&shading->turned[l][which][k], at);
            if (kind == BUMP_UNIT)
                vec_normalise(v);
            dots[l][which] = vec_dot(v, shading->relief);
        }
    shading_colour(shading, dots, colour);
}

/* SPDX-License-Identifier: MIT */
#include "reference/bump.h"

#include "reference/texture.h"
#include "scene/texel.h"
#include "scene/vec.h"

#include <math.h>
#include <string.h>

void bump_normal(const struct decode_texture *map, double u, double v, double normal[3])
{
    const struct scene_texture *head = map->head;
    const uint32_t texel =
        texture_nearest(map, ldexp(u, head->log2_width) + map->nudge[0], ldexp(v, head->log2_height) + map->nudge[1]);
    const uint16_t *rises = scene_at(map->scene, head->palette);
    const int x = (int)(texel >> 8 & 0xff) - 128, y = (int)(texel & 0xff) - 128;
    normal[0] = ldexp(x * head->steepness, -21);
    normal[1] = ldexp(y * head->steepness, -21);
    normal[2] = ldexp(rises[(x * x + y * y) >> 7], -14);
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
    double middle[2][3];
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

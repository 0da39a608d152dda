/* SPDX-License-Identifier: MIT */
#include "shade/shade.h"
#include "tests/setups/setup.h"

int setup_renderer(const struct setup_case *c, struct polynomial *out)
{
    /* with another light on the triangle, a bend limit of 0: whatever bends is quadratic */
    static const struct surface surface = {.channels = 1, .lights = 1, .light = {{.diffuse = {1}, .diffuse_most = 1}}};
    static const struct object_state object; /* light and eye are far */
    const struct scene_triangle triangle = {.bend = {c->bend[2], c->bend[1], c->bend[0]}};
    int16_t lights[3][2] = {{c->lights[0][0]}, {c->lights[1][0]}, {c->lights[2][0]}};
    const struct shade_input in = {.place = {c->place[0], c->place[1], c->place[2]},
                                   .lights = {lights[0], lights[1], lights[2]},
                                   .triangle = &triangle,
                                   .object = &object,
                                   .surface = &surface,
                                   .no_plan = 1};
    struct shade_setup setup;
    setup.depth.exact = 0;
    setup.quadratic = setup.specular_lights = 0;
    setup.diffuse_lights = 2;
    if (!plane_setup(&setup.plane, in.place, SETUP_SIZE, SETUP_SIZE))
        return 0;
    shade_x(&setup, &in);
    *out = setup.channel[0].p;
    return !setup.channel[0].exact;
}

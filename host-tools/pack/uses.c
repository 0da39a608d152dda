/* SPDX-License-Identifier: MIT */
#include "pack/uses.h"

#include "glint.h"

#include <math.h>
#include <string.h>

const struct uses_name uses_names[] = {{USES_TEXTURE, "texture"},
                                       {USES_BUMP, "bump"},
                                       {USES_FOG, "fog"},
                                       {USES_TWO_SIDED, "two-sided"},
                                       {USES_SPECULAR, "specular"},
                                       {USES_POINT_LIGHT, "point-light"},
                                       {USES_LOCAL_VIEWER, "local-viewer"},
                                       {USES_PERSPECTIVE, "perspective"},
                                       {USES_ORTHOGRAPHIC, "orthographic"},
                                       {USES_SPIN, "spin"},
                                       {USES_KEYS, "keys"},
                                       {USES_SEVERAL_LIGHTS, "several-lights"},
                                       {USES_RGB565, "rgb565"},
                                       {USES_RGB888, "rgb888"},
                                       {USES_GREY8, "grey8"},
                                       {USES_GREY4, "grey4"},
                                       {USES_DITHER, "dither"},
                                       {USES_POWERS, "powers"},
                                       {0, NULL}};

void uses_print(FILE *out, uint32_t uses)
{
    if (!uses)
        fputs(" none", out);
    for (const struct uses_name *n = uses_names; n->name; n++)
        if (uses & n->bit)
            fprintf(out, " %s", n->name);
}

bool uses_method(uint32_t uses, const char *name)
{
    const char *const ending = strrchr(name, '-');
    if (!strncmp(name, "bump-", 5))
        return uses & USES_BUMP;
    return !ending || strcmp(ending, "-perspective") != 0 || uses & USES_PERSPECTIVE;
}

void uses_print_methods(FILE *out, uint32_t uses)
{
    for (unsigned i = 0; i < glint_choice_count; i++)
        if (uses_method(uses, glint_choices[i].name))
            fprintf(out, " %s", glint_choices[i].name);
}

/* How far a far light stands on the eye's side: the cosine of its angle to the view, -1..1. */
static double uses_facing(const struct scene_light *light, const struct scene_camera *camera)
{
    const double w = ldexp(camera->rotation[0], -30), x = ldexp(camera->rotation[1], -30),
                 y = ldexp(camera->rotation[2], -30), z = ldexp(camera->rotation[3], -30);
    if (light->kind == LIGHT_POINT || light->motion.kind != MOTION_NONE)
        return 0;
    return ldexp(light->vector[0] * 2 * (x * z - w * y) + light->vector[1] * 2 * (y * z + w * x) +
                     light->vector[2] * (w * w - x * x - y * y + z * z),
                 -30);
}

void uses_order_lights(struct scene_light *lights, unsigned count, const struct scene_camera *camera)
{
    for (unsigned i = 1; i < count; i++) {
        const struct scene_light light = lights[i];
        unsigned at = i;
        for (; at && uses_facing(&lights[at - 1], camera) < uses_facing(&light, camera); at--)
            lights[at] = lights[at - 1];
        lights[at] = light;
    }
}

static uint32_t find_one(const char *name, size_t length)
{
    for (const struct uses_name *n = uses_names; n->name; n++)
        if (n->bit & ~USES_EFFECTS && strlen(n->name) == length && !strncmp(n->name, name, length))
            return n->bit;
    return 0;
}

uint32_t uses_find(const char *names)
{
    uint32_t uses = 0;
    for (;; names++) {
        const size_t length = strcspn(names, ",");
        const uint32_t bit = find_one(names, length);
        if (!bit)
            return 0;
        uses |= bit;
        names += length;
        if (!*names)
            return uses;
    }
}

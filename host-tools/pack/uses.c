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
                                       {USES_CLIPPING, "clipping"},
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

/* Whether a ball keeps to its side of a plane at this distance from its middle, by a margin for what is rounded. */
static bool uses_within(double distance, double reach)
{
    return distance - reach > (fabs(distance) + reach) / 512;
}

/* Whether a ball is inside the view. */
static bool uses_seen(const struct scene_camera *c, const q16_t position[3], double reach)
{
    const double w = ldexp(c->rotation[0], -30), x = ldexp(c->rotation[1], -30), y = ldexp(c->rotation[2], -30),
                 z = ldexp(c->rotation[3], -30);
    const double matrix[3][3] = {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                                 {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                                 {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
    const double half[2] = {c->reference_width / 2., c->reference_height / 2.}, focal = ldexp(c->focal, -16);
    double eye[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            eye[i] += matrix[i][j] * ldexp((double)position[j] - c->position[j], -16);
    bool seen = uses_within(-eye[2] - ldexp(c->near_plane, -16), reach) &&
                uses_within(ldexp(c->far_plane, -16) + eye[2], reach);
    for (int i = 0; i < 2; i++) /* from the view's sides: planes through the eye, or along the view */
        seen = seen && (c->kind == CAMERA_PERSPECTIVE
                            ? uses_within((half[i] * -eye[2] - focal * fabs(eye[i])) / hypot(half[i], focal), reach)
                            : uses_within(half[i] / focal - fabs(eye[i]), reach));
    return seen;
}

/* How far a mesh reaches from its object's origin. */
static double uses_reach(const struct scene_header *s, const struct scene_mesh *mesh)
{
    const struct scene_vertex *vertex = scene_at(s, mesh->vertices);
    double most = 0;
    for (uint32_t i = 0; i < mesh->vertex_count; i++, vertex++) {
        double squared = 0;
        for (int k = 0; k < 3; k++)
            squared += pow(ldexp(mesh->centre[k], -16) + ldexp((double)vertex->position[k] * mesh->extent, -31), 2);
        most = fmax(most, sqrt(squared));
    }
    return most;
}

uint32_t uses_clipping(const struct scene_header *s)
{
    for (unsigned i = 0; i < s->object_count; i++) {
        const struct scene_object *object = &scene_objects(s)[i];
        const struct scene_mesh *mesh = &scene_meshes(s)[object->mesh];
        const struct scene_key *key = scene_keys(s) + object->motion.first_key;
        const double size = uses_reach(s, mesh);
        /* Keys are mixed, and the view is convex: between two it holds the ball if it does at both. */
        bool seen = object->motion.kind == MOTION_KEYS ||
                    uses_seen(&s->camera, object->position, size * ldexp(object->scale, -16));
        for (unsigned k = 0; k < object->motion.key_count; k++)
            seen = seen && uses_seen(&s->camera, key[k].position, size * ldexp(key[k].scale, -16));
        if (!seen)
            return USES_CLIPPING;
    }
    return 0;
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

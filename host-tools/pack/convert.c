/* SPDX-License-Identifier: MIT */
#include "pack/convert.h"

#include <math.h>

int32_t convert_q(double value, int bits)
{
    double scaled = floor(ldexp(value, bits) + 0.5);
    return scaled >= INT32_MAX ? INT32_MAX : scaled <= INT32_MIN ? INT32_MIN : (int32_t)scaled;
}

static void to_q16(const double in[3], q16_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = convert_q(in[k], 16);
}

/* A unit vector or quaternion; products of many turns have drifted a little from length 1. */
static void to_unit(const double *in, q30_t *out, int count)
{
    double length = 0;
    for (int k = 0; k < count; k++)
        length += in[k] * in[k];
    for (int k = 0; k < count; k++)
        out[k] = convert_q(in[k] / sqrt(length), 30);
}

void convert_colour(const double in[3], uint16_t out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = (uint16_t)convert_q(in[k], 15);
}

struct scene_material convert_material(const struct model_material *in)
{
    struct scene_material out = {.ka = (uint16_t)convert_q(in->ka, 15),
                                 .kd = (uint16_t)convert_q(in->kd, 15),
                                 .ks = (uint16_t)convert_q(in->ks, 15),
                                 .shininess = (uint16_t)fmin(fmax(convert_q(in->shininess, 0), 1), 1023),
                                 .texture = SCENE_NO_TEXTURE,
                                 .bump = SCENE_NO_TEXTURE};
    out.flags = (uint16_t)((in->flat ? MATERIAL_FLAT : 0) | (in->two_sided ? MATERIAL_TWO_SIDED : 0));
    convert_colour(in->diffuse, out.diffuse);
    convert_colour(in->specular, out.specular);
    return out;
}

struct scene_fog convert_fog(const struct model_fog *in)
{
    struct scene_fog out = {.kind = (uint16_t)in->kind};
    if (in->kind == FOG_LINEAR) {
        out.from = convert_q(in->from, 16);
        out.to = convert_q(in->to, 16);
    } else if (in->kind == FOG_EXPONENTIAL) {
        out.density = (uint32_t)fmax(convert_q(in->density, 24), 1);
    }
    convert_colour(in->colour, out.colour);
    return out;
}

static struct scene_motion to_motion(const struct model_motion *in)
{
    struct scene_motion out = {.kind = (uint16_t)in->kind};
    if (in->kind == MOTION_SPIN) {
        to_unit(in->axis, out.axis, 3);
        out.rate = convert_q(in->rate, 16);
    } else if (in->kind == MOTION_KEYS) {
        out.first_key = (uint16_t)in->first_key;
        out.key_count = (uint16_t)in->key_count;
    }
    return out;
}

struct scene_object convert_object(const struct model_object *in, unsigned mesh)
{
    struct scene_object out = {
        .mesh = (uint16_t)mesh, .scale = convert_q(in->pose.scale, 16), .motion = to_motion(&in->motion)};
    to_unit(in->pose.rotation, out.rotation, 4);
    to_q16(in->pose.position, out.position);
    return out;
}

struct scene_key convert_key(const struct model_key *in, const struct scene_key *before)
{
    struct scene_key out = {.time_ms = in->time_ms, .scale = convert_q(in->pose.scale, 16)};
    double dot = 0;
    to_unit(in->pose.rotation, out.rotation, 4);
    to_q16(in->pose.position, out.position);
    for (int k = 0; before && k < 4; k++)
        dot += (double)before->rotation[k] * out.rotation[k];
    for (int k = 0; dot < 0 && k < 4; k++)
        out.rotation[k] = -out.rotation[k];
    return out;
}

struct scene_light convert_light(const struct model_light *in)
{
    struct scene_light out = {.kind = (uint16_t)in->kind, .motion = to_motion(&in->motion)};
    if (in->kind == LIGHT_POINT)
        to_q16(in->vector, out.vector);
    else
        to_unit(in->vector, out.vector, 3);
    convert_colour(in->colour, out.colour);
    return out;
}

struct scene_camera convert_camera(const struct model_camera *in)
{
    struct scene_camera out = {.kind = (uint16_t)in->kind,
                               .viewer = (uint16_t)in->viewer,
                               .focal = convert_q(in->focal, 16),
                               .reference_width = (uint16_t)in->size[0],
                               .reference_height = (uint16_t)in->size[1],
                               .near_plane = convert_q(in->near_plane, 16),
                               .far_plane = convert_q(in->far_plane, 16)};
    to_unit(in->rotation, out.rotation, 4);
    to_q16(in->position, out.position);
    return out;
}

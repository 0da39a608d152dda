/* SPDX-License-Identifier: MIT */
/* The small parts of a scene, rounded from double precision into the blob's structs. */
#ifndef CONVERT_H
#define CONVERT_H

#include "scene/model.h"
#include "scene/scene.h"

struct scene_material convert_material(const struct model_material *in); /* without indices */
struct scene_object convert_object(const struct model_object *in, unsigned mesh);
struct scene_light convert_light(const struct model_light *in);
struct scene_camera convert_camera(const struct model_camera *in);
/* `before`: the key before it of the same motion, or null. Of the two quaternions of a rotation the one closer to it is
 * taken, so that interpolation goes the short way. */
struct scene_key convert_key(const struct model_key *in, const struct scene_key *before);
struct scene_fog convert_fog(const struct model_fog *in);
void convert_colour(const double in[3], uint16_t out[3]);

/* round(value * 2^bits), saturated at the type's ends. */
int32_t convert_q(double value, int bits);

#endif

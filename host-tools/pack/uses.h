/* SPDX-License-Identifier: MIT */
/* Names of what a scene can need and what a build has: firmware/uses.h. */
#ifndef PACK_USES_H
#define PACK_USES_H

#include "scene/scene_effects.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

struct uses_name {
    uint32_t bit;
    const char *name;
};
extern const struct uses_name uses_names[]; /* effects, then formats; the last has no name */

/* The names of a set, each behind a space, or " none". */
void uses_print(FILE *out, uint32_t uses);

/* USES_CLIPPING if an object of a scene can ever reach out of the camera's view, in a picture of any size: it is taken
 * for a ball about its own origin, so that it may turn. */
uint32_t uses_clipping(const struct scene_header *scene);

/* Whether a method draws scenes of these effects otherwise than a plainer one: of those for bump maps and for
 * perspective views it does where there are such. */
bool uses_method(uint32_t uses, const char *name);

/* The names of these, each behind a space. */
void uses_print_methods(FILE *out, uint32_t uses);

/*
 * Sorts lights so that those come first which light the more of what can be seen: a triangle that only the first
 * reaches is drawn as under one light (firmware/shade/steps.h, firmware/raster/table.c). The order changes no bit.
 * Lights that move and such in the scene stand between those before and those behind it.
 */
void uses_order_lights(struct scene_light *lights, unsigned count, const struct scene_camera *camera);

/* The set of formats, and dither, of names apart by commas; 0 if one is no such name. */
uint32_t uses_find(const char *names);

#endif

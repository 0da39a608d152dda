/* SPDX-License-Identifier: MIT */
/* Names of what a scene can need and what a build has: firmware/uses.h. */
#ifndef PACK_USES_H
#define PACK_USES_H

#include "scene/scene_effects.h"

#include <stdio.h>

struct uses_name {
    uint32_t bit;
    const char *name;
};
extern const struct uses_name uses_names[]; /* effects, then formats; the last has no name */

/* The names of a set, each behind a space, or " none". */
void uses_print(FILE *out, uint32_t uses);

/* The set of formats, and dither, of names apart by commas; 0 if one is no such name. */
uint32_t uses_find(const char *names);

#endif

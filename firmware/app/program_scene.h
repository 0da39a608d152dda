/* SPDX-License-Identifier: MIT */
/* The scenes that are linked into a program, in a list that is made at build (tests/tools/scene_list.sh). */
#ifndef PROGRAM_SCENE_H
#define PROGRAM_SCENE_H

#include <stdint.h>

struct program_scene {
    const char *name;
    const uint32_t *blob;   /* as `glint pack` made it, not yet checked */
    const uint32_t *length; /* bytes */
};
extern const struct program_scene program_scenes[];
extern const unsigned program_scene_count;

#endif

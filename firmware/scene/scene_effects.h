/* SPDX-License-Identifier: MIT */
/* Which effects a scene can need at any moment: uses.h names them. */
#ifndef GLINT_SCENE_EFFECTS_H
#define GLINT_SCENE_EFFECTS_H

#include "scene/scene.h"
#include "uses.h"

/* The least set, of USES_EFFECTS, that draws a checked scene: what of it shows is not looked at, so that any view and
 * any moment is covered. scene_header.effects holds all of it. */
uint32_t scene_effects(const struct scene_header *scene);

#endif

/* SPDX-License-Identifier: MIT */
/* Lays a model out as a scene blob. */
#ifndef BLOB_H
#define BLOB_H

#include "pack/pack.h"
#include "scene/model.h"

/* Returns an exit code as pack_load() does; messages begin with `path`. */
int blob_build(const struct model *model, const char *path, struct pack_result *result);

/* Replaces the exponent of every material of a checked blob. */
void blob_override_shininess(struct scene_header *scene, unsigned shininess);

#endif

/* SPDX-License-Identifier: MIT */
/* What a checked blob holds, as text or as one JSON object with the names of a scene file. */
#ifndef SUMMARY_H
#define SUMMARY_H

#include "scene/scene.h"

#include <stdio.h>

void summary_print(FILE *out, const struct scene_header *scene);
void summary_json(FILE *out, const struct scene_header *scene);

#endif

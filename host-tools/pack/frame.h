/* SPDX-License-Identifier: MIT */
/* A scene around a model that came alone. */
#ifndef FRAME_H
#define FRAME_H

#include "scene/model.h"

/* Loads a model file into an empty model: fitted to a radius of 1 at the origin, turning once in 6 s about the upright
 * axis, seen a little from above and aside, as large as its whole turn fits the picture, under one key light from the
 * upper left, before grey. STL files stand on z, as is usual there, all others on y; a surface that is open to one side
 * shows the other first. Returns an exit code; has printed a message when it is not 0. */
int frame_load(const char *path, struct model *model);

#endif

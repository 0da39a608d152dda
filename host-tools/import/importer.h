/* SPDX-License-Identifier: MIT */
/* The only place that knows assimp. */
#ifndef IMPORTER_H
#define IMPORTER_H

#include "scene/model.h"

/* Adds the file's triangles to mesh `mesh` of the model and its materials to the model. Returns null, or why not.
 * `said` takes the importer's own words: the reason, or else a warning, or nothing. A hostile file can make the
 * importer crash or run for ever. */
const char *importer_read(const char *path, struct model *model, size_t mesh, bool *has_normals, char *said,
                          size_t size);

#endif

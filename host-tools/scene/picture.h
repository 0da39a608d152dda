/* SPDX-License-Identifier: MIT */
/* Pictures for textures: from PNG files, or made. */
#ifndef PICTURE_TEXTURE_H
#define PICTURE_TEXTURE_H

#include "scene/model.h"

enum picture_pattern {
    PICTURE_CHECKER,  /* the two colours in turn */
    PICTURE_GRADIENT, /* from the first to the second along u, cell by cell */
    PICTURE_NOISE,    /* smooth noise between them, four octaves */
    PICTURE_PATTERNS
};

/* The texture of a file: that which the model has already under this path, or a new one, bilinear and repeating.
 * *index is -1 after a failure, of which one line has been printed. Returns an exit code. */
int picture_load(struct model *model, const char *path, int *index);

/* The same for the picture that a model names, relative to the model's folder. One that cannot be read is no error: a
 * line on standard error says that the surface is drawn without it, and *index is -1. */
void picture_beside(const char *model_path, const char *name, struct model *model, int *index);

/* The same for a picture that is inside the model. */
void picture_inside(const char *model_path, const struct model_material *material, struct model *model, int *index);

/* The file's texture becomes one of this name alone: whatever names the file next gets another. */
struct model_texture *picture_take(struct model *model, int index, const char *name);

/* Fills a texture of size[0] x size[1] texels with cells[0] x cells[1] of a pattern; it repeats. */
void picture_make(struct model_texture *texture, enum picture_pattern pattern, const unsigned size[2],
                  const unsigned cells[2], double colour[2][3]);

#endif

/* SPDX-License-Identifier: MIT */
/* A scene as a device draws it in 8-bit grey, at its camera's size. */
#ifndef DRAWING_H
#define DRAWING_H

#include "compare/compare.h"
#include "glint.h"
#include "reference/reference.h"

/* Draws the scene of `path` by a method that exists into grey[height][width], with a form of the highlight's power
 * (null: the table). Returns the exit code of the command line; whenever it is not 0, one line has been printed on
 * stderr. */
int drawing_make(uint8_t *grey, const struct scene_header *scene, const char *path, const char *method,
                 const struct glint_power *power);

/* Its differences from the truth before that is rounded, where covered[] is 1. */
void drawing_compare(const uint8_t *grey, const struct reference_image *truth, const uint8_t *covered,
                     struct compare_result *error);

#endif

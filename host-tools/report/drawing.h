/* SPDX-License-Identifier: MIT */
/* A scene as a device draws it in 8-bit grey, or colour, at its camera's size. */
#ifndef DRAWING_H
#define DRAWING_H

#include "compare/compare.h"
#include "glint.h"
#include "reference/reference.h"

#include <stdbool.h>

/* How: a method that exists. */
struct drawing {
    const char *method; /* null: `show`, another */
    const struct glint_method *show;
    const struct glint_power *power; /* form of the highlight's power; null: the table */
    uint16_t budget_q8;              /* of auto; 0: the default */
    bool colour;                     /* RGB888, three bytes a pixel */
};

/* Draws the scene of `path` into pixels[height][width] and, unless null, says what the frame did. Returns the exit code
 * of the command line; whenever it is not 0, one line has been printed on stderr. */
int drawing_make(uint8_t *pixels, const struct scene_header *scene, const char *path, const struct drawing *how,
                 struct glint_stats *stats);

/* Its differences from a truth of as many channels, before that is rounded, where covered[] is 1. */
void drawing_compare(const uint8_t *pixels, const struct reference_image *truth, const uint8_t *covered,
                     struct compare_result *error);

#endif

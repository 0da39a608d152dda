/* SPDX-License-Identifier: MIT */
/* What frame.c and memory.c share: the triangle list. */
#ifndef GLINT_FRAME_H
#define GLINT_FRAME_H

#include "glint.h"

/* 8 bytes a triangle that may be drawn, and 2 for its place in the order of first rows. */
struct triangle_ref {
    uint16_t index; /* of the mesh's triangles; of the clipped store if `clipped` */
    uint8_t object, clipped;
    uint16_t first, last; /* rows [first, last) of the picture */
};

#define NO_MATERIAL 0xffffu

#endif

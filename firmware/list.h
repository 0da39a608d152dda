/* SPDX-License-Identifier: MIT */
/* The triangles of a frame: those that may be drawn, sorted by first row. */
#ifndef GLINT_LIST_H
#define GLINT_LIST_H

#include "geometry/transform.h"
#include "glint.h"

#define LIST_CLIPPED 1u /* a piece */
#define LIST_TURNED  2u /* its back is seen */

/* 8 bytes a triangle that may be drawn, and 2 for its place in the order of first rows. */
struct triangle_ref {
    uint16_t index; /* of the mesh's triangles; of the clipped store if LIST_CLIPPED */
    uint8_t object, kind;
    uint16_t first, last; /* rows [first, last) of the picture */
};

/* The vertex record of the frame's vertex store. */
static inline int16_t *list_record(const struct glint_frame *f, uint32_t vertex)
{
    return f->vertices + vertex * f->vertex_stride;
}

/* Lists the triangles of object `index`, whose vertices are placed; all_placed: each of them on the screen. */
void list_object(struct glint_frame *f, const struct transform *transform, unsigned index, int all_placed);

/* Orders the listed triangles by first row, equal ones as they came. */
void list_sort(struct glint_frame *f);

#endif

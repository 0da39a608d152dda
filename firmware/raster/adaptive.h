/* SPDX-License-Identifier: MIT */
/* Methods that treat potentially highlighted triangles and their neighbours in a way of their own, and draw the others
 * by gouraud. highlighted_mark() is their `object`. */
#ifndef GLINT_ADAPTIVE_H
#define GLINT_ADAPTIVE_H

#include "plan/highlighted.h"
#include "raster/raster.h"
#include "shade/colour.h"

_Static_assert(HIGHLIGHTED_WORDS == COLOUR_WORDS, "the tests use gouraud's words while it does not");

/* Gouraud's, and the mark. */
#define ADAPTIVE_WORDS SHADE_VERTEX_WORDS

/* 1 if a corner of the triangle is one of a potentially highlighted triangle. */
static inline int adaptive_treats(const struct shade_input *in)
{
    const unsigned mark = 2u * surface_lights(in->surface) + HIGHLIGHTED_WORDS;
    return ((in->lights[0][mark] | in->lights[1][mark] | in->lights[2][mark]) & HIGHLIGHTED_FRONT) != 0;
}

#endif

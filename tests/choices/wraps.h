/* SPDX-License-Identifier: MIT */
/*
 * The renderer's own code with parts of it exchanged while it runs: what the linker's --wrap puts between two of its
 * files (tests/tools/choices.mk). Set before a picture is drawn; not for several at a time.
 */
#ifndef WRAPS_H
#define WRAPS_H

#include "tests/choices/parts.h"

#include <stdbool.h>

enum { WRAPS_FRACTION_LEAST = 14, WRAPS_FRACTION_MOST = 24, WRAPS_FRACTION_OWN = 22, WRAPS_SUBPIXEL_OWN = 4 };

struct wraps {
    /* Coefficients of polynomials, depth's apart, are rounded to this many fraction bits of 1/256 of full intensity;
     * additions are exact, so a renderer with no more bits would give these values. */
    unsigned fraction;
    /* Corners are rounded to 1/2^n pixel where n < 4. For more of them a picture 2^(n - 4) times as large is drawn,
     * shifted so that the centre of pixel i is that of its pixel 2^(n - 4) i. */
    unsigned subpixel;
    parts_function *reciprocal, *root;
    unsigned long reciprocals, roots; /* calls, counted */
    /* If `model` is set: over the pixels of every triangle that has a quadratic, the largest difference, in 1/255, that
     * rounding its coefficients to each number of fraction bits makes; in double precision. */
    bool model;
    double error[WRAPS_FRACTION_MOST + 1];
    double largest; /* and the largest value, as a share of full intensity */
};
extern struct wraps wraps;

void wraps_begin(void); /* as the renderer is */

#endif

/* SPDX-License-Identifier: MIT */
/* Sums of struct glint_stats over frames, and their print: what --stats shows. */
#ifndef TALLY_H
#define TALLY_H

#include "glint/renderer.h"

#include <stdbool.h>
#include <stdio.h>

struct tally {
    uint32_t frames;
    double milliseconds;
    uint64_t triangles, culled, rejected, clipped, dropped, setups, specular_triangles, linear_triangles,
        highlight_tests, potentially_highlighted, hidden_lights, hidden_highlights, dropped_highlights, straightened,
        undivided, turned, fogged, fogged_by_pixel, fogged_wholly;
    uint16_t largest_error; /* of any frame */
    uint64_t drawn[GLINT_METHODS], pixels[GLINT_METHODS], mapped[GLINT_TEXTURES];
};

void tally_add(struct tally *tally, const struct glint_stats *stats);

/* The sums, with what was drawn. */
void tally_print(const struct tally *tally, const struct renderer *renderer, bool json);

#endif

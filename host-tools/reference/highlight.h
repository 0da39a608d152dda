/* SPDX-License-Identifier: MIT */
/* The highlight test of "Improved Specular Highlights with Adaptive Shading", section 2.3. */
#ifndef HIGHLIGHT_H
#define HIGHLIGHT_H

#include "reference/shading.h"

#include <stdbool.h>

/* Can the centre of a highlight lie in this triangle, under any of the lights? */
bool highlight_possible(const struct decode_view *view, const struct decode_vertex corner[3]);

#endif

/* SPDX-License-Identifier: MIT */
/* Lines of text over a picture: the letters of firmware/app/text, with marks that a device's screen has no use for. */
#ifndef VIEW_OVERLAY_H
#define VIEW_OVERLAY_H

#include <stdint.h>

#define OVERLAY_LINES   32u
#define OVERLAY_COLUMNS 60u /* what is longer is cut off */
#define OVERLAY_CELL    4u  /* pixels from letter to letter, and */
#define OVERLAY_LINE    7u  /* from line to line */

struct overlay_text {
    char lines[OVERLAY_LINES][OVERLAY_COLUMNS + 1];
    unsigned count; /* all zero at first */
};

/* Another line, if there is room for one. What is no ASCII, or would be obeyed, becomes a question mark a character. */
__attribute__((format(printf, 2, 3))) void overlay_add(struct overlay_text *text, const char *format, ...);

/* A screen, or what lies on one: AArrggbb, rows without gaps. */
struct overlay {
    uint32_t *pixels;
    unsigned width, height;
};

enum overlay_place { OVERLAY_TOP, OVERLAY_MIDDLE, OVERLAY_BOTTOM, OVERLAY_PLACES };

/* Draws the lines in a darkened box at the left of the top or bottom, or in the middle; nothing without lines. Of what
 * has no room the end is missing. */
void overlay_draw(const struct overlay *overlay, enum overlay_place place, const struct overlay_text *text);

#endif

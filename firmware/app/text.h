/* SPDX-License-Identifier: MIT */
/* Letters in a band: 3x5 pixels in cells of 4x6. Capitals, digits and - . : / ! ,; small letters become capitals, and
 * what else there is a space. */
#ifndef APP_TEXT_H
#define APP_TEXT_H

#include "glint.h"

#define TEXT_WIDTH  4u
#define TEXT_HEIGHT 6u

/* Draws the rows of `text`, its upper left corner at (x, y) of the picture, that fall into the band, white on black.
 * `format` is GLINT_RGB565 or GLINT_GREY4; what does not fit the picture's width is cut off. */
void text_draw(const struct glint_band *band, unsigned format, unsigned width, unsigned x, unsigned y,
               const char *text);

/* A line under construction; what does not fit is cut off. */
struct text_line {
    char text[80];
    unsigned length;
};
void text_add(struct text_line *line, const char *text);
void text_add_number(struct text_line *line, uint32_t value);

#endif

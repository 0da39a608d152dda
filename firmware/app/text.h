/* SPDX-License-Identifier: MIT */
/* Letters in a band: 3x5 pixels in cells of 4x6, or twice that. Capitals, digits and - . : / ! ,; small letters become
 * capitals, and what else there is a space. */
#ifndef APP_TEXT_H
#define APP_TEXT_H

#include "glint.h"

/* A cell, in pixels, where the picture has this width: large from 240 on, 30 letters a line. */
#define TEXT_LARGE_FROM 240u
static inline unsigned text_large(unsigned width)
{
    return width >= TEXT_LARGE_FROM ? 1 : 0;
}
static inline unsigned text_width(unsigned width)
{
    return 4u << text_large(width);
}
static inline unsigned text_height(unsigned width)
{
    return 6u << text_large(width);
}

/* The rows of a picture that are at hand, to be written on. */
struct text_canvas {
    const struct glint_band *band;
    uint16_t width; /* of the picture */
    uint8_t format; /* GLINT_RGB565 or GLINT_GREY4 */
    uint8_t dark;   /* 1: black on white, with a row of white above that is another line's gap */
};

/* A letter: five rows from the top, an octal digit each, the left pixel in its highest bit. */
uint16_t text_glyph(char letter);

/* Draws what of `text`, its upper left corner at (x, y) of the picture, falls into the band. What does not fit the
 * picture's width is cut off. */
void text_draw(const struct text_canvas *canvas, unsigned x, unsigned y, const char *text);

/* A line under construction; what does not fit is cut off. */
struct text_line {
    char text[160];
    unsigned length;
};
void text_add(struct text_line *line, const char *text);
/* Spaces up to a length. */
void text_pad(struct text_line *line, unsigned length);
void text_add_number(struct text_line *line, uint32_t value);
/* An angle of 1/65536 turns, in degrees with three digits that tell it apart from its neighbours. */
void text_add_angle(struct text_line *line, uint16_t angle);

#endif

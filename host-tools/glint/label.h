/* SPDX-License-Identifier: MIT */
/* Words under pictures: a font of 5x7 pixels with the letters that the demo's labels have. */
#ifndef LABEL_H
#define LABEL_H

#include <stdint.h>

#define LABEL_SCALE  2u /* picture pixels a font pixel, either way */
#define LABEL_HEIGHT (7u * LABEL_SCALE)

/* In pixels. */
unsigned label_width(const char *text);

/* Draws `text` in light grey with its upper left corner at (x, y) of an RGB picture `width` pixels wide, where it must
 * fit; other characters leave a space. */
void label_draw(const char *text, uint8_t *rgb, unsigned width, unsigned x, unsigned y);

#endif

/* SPDX-License-Identifier: MIT */
/* Pictures inside a page. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* Writes an <img> of 8-bit pixels, grey or RGB, as a PNG in a data URI; `caption` is its text for those who do not see
 * it, free of quotes. False: out of memory, and nothing is written. */
bool picture_write(FILE *out, const uint8_t *pixels, unsigned width, unsigned height, bool rgb, const char *caption);

#endif

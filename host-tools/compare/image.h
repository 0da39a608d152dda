/* SPDX-License-Identifier: MIT */
/* Pictures in memory: 8-bit RGB, top row first. */
#ifndef IMAGE_H
#define IMAGE_H

#include <stddef.h>
#include <stdint.h>

#define IMAGE_MAX_SIZE 16384u /* pixels, either way */

struct image {
    unsigned width, height;
    uint8_t *rgb; /* from malloc */
};

/* Reads a PNG of any colour type; alpha is left out, 16 bits are rounded to 8. Returns the exit code of the command
 * line: 0; 1, not a whole PNG; 3, not readable, or no memory for it. After a failure, one line has been printed on
 * stderr and there is nothing to free. */
int image_read_png(const char *path, struct image *image);

/* The same from memory; `name` is for messages. */
int image_read_png_bytes(const char *name, const uint8_t *bytes, size_t size, struct image *image);

void image_free(struct image *image);

#endif

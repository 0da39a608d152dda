/* SPDX-License-Identifier: MIT */
/* Pictures inside a page. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/*
 * A difference of 8-bit values is shown by its octave: level 0 is less than 1/2 in 255, level l from 2^(l - 2) on, the
 * last also all above; below zero where the picture is too dark. So one picture shows an error of 1 beside one of 32,
 * and takes 4 bits a pixel.
 */
#define PICTURE_LEVELS 7
#define PICTURE_RIGHT  PICTURE_LEVELS /* the sample of level 0: samples are levels plus this */

int picture_level(double difference);

/* How a level is shown: black where right, orange where too bright, blue where too dark. */
void picture_colour(int level, uint8_t rgb[3]);

enum picture_kind { PICTURE_GREY, PICTURE_RGB, PICTURE_DIFFERENCE /* a level a byte */ };

struct picture {
    const uint8_t *pixels; /* the first row shown */
    unsigned stride;       /* bytes between rows */
    unsigned width, height;
    enum picture_kind kind;
};

/* Writes an <img> with a PNG in a data URI, which a browser decodes when it comes into view; `caption` is its text for
 * those who do not see it, free of quotes. False: out of memory, and nothing is written. */
bool picture_write(FILE *out, const struct picture *picture, const char *caption);

#endif

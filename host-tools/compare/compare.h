/* SPDX-License-Identifier: MIT */
/*
 * How far two pictures differ, in 1/255 of full intensity, over the pixels that either covers: those that are not
 * background in both.
 */
#ifndef COMPARE_H
#define COMPARE_H

#include "compare/image.h"

struct compare_result {
    size_t pixels;  /* compared */
    double psnr_db; /* 20 log10(255 / rms); infinite for equal pictures */
    double rms;     /* over pixels and channels */
    double max;     /* largest difference of any channel */
    double p999;    /* of 1000 pixels, 999 differ by no more than this in any channel: nearest rank, rounded up to a
                     * whole number */
};

#define COMPARE_CHANNELS 3

/* Values of `channels` (1..COMPARE_CHANNELS) a pixel, 0..255, not rounded; pixels whose mask is 0 are left out. */
void compare_values(const double *a, const double *b, const uint8_t *mask, size_t pixels, unsigned channels,
                    struct compare_result *result);

/* The colour that most corners of a picture have: its background, unless the scene fills it. */
void compare_background(const struct image *image, uint8_t rgb[3]);

/* Two pictures of one size. `background` null: each has its own, compare_background(); if then nothing is covered and
 * the two differ, every pixel counts. */
void compare_images(const struct image *a, const struct image *b, const uint8_t background[3],
                    struct compare_result *result);

/* rgb = 128 + 8 (b - a) a channel, clamped: grey where they agree, black or white from 16 on. */
void compare_difference(const struct image *a, const struct image *b, uint8_t *rgb);

#endif

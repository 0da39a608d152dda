/* SPDX-License-Identifier: MIT */
/* A picture as a screen takes it. */
#ifndef VIEW_PIXELS_H
#define VIEW_PIXELS_H

#include "view/frames.h"

/* Width and height change places with an odd number of quarter turns. */
uint32_t pixels_width(const struct frames_picture *picture, unsigned rotation);
uint32_t pixels_height(const struct frames_picture *picture, unsigned rotation);

/* Writes it as FFrrggbb, turned clockwise by quarter turns, rows `stride` pixels apart; widened to 8 bits as its PNG.
 */
void pixels_turn(const struct frames_picture *picture, unsigned rotation, uint32_t *out, size_t stride);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * Turning by software, for a controller with two pixels a byte: they are neighbours on the glass in every rotation,
 * which no order of addresses gives. The memory's order stays as at 0 degrees.
 */
#ifndef HAL_PANELS_TURN_H
#define HAL_PANELS_TURN_H

#include "panels/panel.h"

#define TURN_BYTES 80 /* the longest column (SSD0323: 80 rows) or row (64 bytes) of the glass */

/* Sends rows y.. of the picture to where they are on the turned glass, waiting for each. At quarter turns y and rows
 * are even. */
int turn_send(struct panel *panel, const uint8_t *pixels, uint32_t y, uint32_t rows, uint32_t stride);

#endif

/* SPDX-License-Identifier: MIT */
/* Brings a picture down to 256 colours: exactly if it has no more, else by median cut (Heckbert 1982). */
#ifndef PALETTE_H
#define PALETTE_H

#include <stddef.h>
#include <stdint.h>

#define PALETTE_MOST 256u

/* `rgb`: 0x00RRGGBB of `count` pixels; fills an index for each and palette[256], of which it returns how many are used.
 * *different: the colours there were. */
unsigned palette_make(const uint32_t *rgb, size_t count, uint8_t *index, uint32_t *palette, unsigned *different);

#endif

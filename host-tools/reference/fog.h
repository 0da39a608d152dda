/* SPDX-License-Identifier: MIT */
/* Fog between the eye and a point: by its distance along the view, not the way to it, as depth has it. */
#ifndef FOG_H
#define FOG_H

#include "reference/decode.h"

/* The part of a colour that fog takes at a distance, 0..1. */
double fog_amount(const struct decode_fog *fog, double distance);

/* Mixes a finished colour, 0..1 a channel, with the fog's. */
void fog_apply(const struct decode_fog *fog, double distance, unsigned channels, double colour[3]);

#endif

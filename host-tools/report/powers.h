/* SPDX-License-Identifier: MIT */
/*
 * The forms of the highlight's power (shade/power.h) compared: how far each is from the power itself, how far a picture
 * with it is from the truth, and what a frame costs.
 */
#ifndef POWERS_H
#define POWERS_H

#include "report/costs.h"

#include <stdio.h>

/* The largest difference from s^n over 0 <= s <= 1, in 1/255; `form` is a place in renderer_powers[]. */
double powers_error(unsigned form, unsigned exponent);

/* Writes the section of one scene, whose costs are in costs->powers, as HTML. Returns the exit code of the command
 * line; whenever it is not 0, one line has been printed on stderr. */
int powers_write(FILE *out, const char *path, const struct costs *costs);

#endif

/* SPDX-License-Identifier: MIT */
/* Scenes with effects: what auto draws of them, the truth, and what it chose where. */
#ifndef EFFECTS_H
#define EFFECTS_H

#include <stdio.h>

/* Draws the scenes of files by auto, in colour at their camera's size, and writes the section as HTML. Returns the exit
 * code of the command line; whenever it is not 0, one line has been printed on stderr. */
int effects_write(FILE *out, const char *const paths[], unsigned count);

#endif

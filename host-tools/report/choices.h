/* SPDX-License-Identifier: MIT */
/*
 * What fixed-point choices cost and gain, measured elsewhere (tests/choices/, `make report`) and read from a CSV file
 * `choice,value,where,figure,number`. Choices are fraction, subpixel, power, reciprocal and root.
 */
#ifndef CHOICES_H
#define CHOICES_H

#include <stdio.h>

/* Writes the section as HTML: a table a choice, and what to choose. Returns the exit code of the command line, 0, 1 or
 * 3; whenever it is not 0, one line has been printed on stderr. */
int choices_write(FILE *out, const char *path);

#endif

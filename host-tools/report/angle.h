/* SPDX-License-Identifier: MIT */
/* How X-shading's error grows with the angle between normals, and how often it exceeds Gouraud's. */
#ifndef ANGLE_H
#define ANGLE_H

#include <stdio.h>

/* Writes the section as HTML. Returns the exit code of the command line; whenever it is not 0, one line has been
 * printed on stderr. */
int angle_write(FILE *out);

#endif

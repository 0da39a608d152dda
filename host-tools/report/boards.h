/* SPDX-License-Identifier: MIT */
/*
 * What pictures cost on boards, and what the program takes of their memory, measured elsewhere (`make bench-boards`)
 * and read from a CSV file `board,what,figure,unit,number`, a board after the other, of each `program` first.
 */
#ifndef BOARDS_H
#define BOARDS_H

#include <stdio.h>

/* Writes the section as HTML. Returns the exit code of the command line, 0, 1 or 3; whenever it is not 0, one line has
 * been printed on stderr. */
int boards_write(FILE *out, const char *path);

#endif

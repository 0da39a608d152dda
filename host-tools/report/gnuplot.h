/* SPDX-License-Identifier: MIT */
/* Runs gnuplot. */
#ifndef GNUPLOT_H
#define GNUPLOT_H

#include <stdio.h>

/* Runs a script, which is rewound first, and writes the SVG element that it prints to `out`: without prolog and title,
 * so that it can stand in a page, and with `prefix` before every id, so that several can. Returns the exit code of the
 * command line, 0 or 3; after a failure, one line has been printed on stderr. */
int gnuplot_run(FILE *script, FILE *out, const char *prefix);

#endif

/* SPDX-License-Identifier: MIT */
/* What pictures take as a stream, and what it costs to pack them. */
#ifndef STREAMS_H
#define STREAMS_H

#include "report/costs.h"

#include <stdio.h>

/* Measures the scenes of files (traffic.h) and writes the section as HTML to `page`, with the costs to pack where
 * costs->streams has them, and all figures as CSV to `table`. Returns the exit code of the command line; whenever it is
 * not 0, one line has been printed on stderr. */
int streams_write(FILE *page, FILE *table, const char *const paths[], unsigned count, const struct costs *costs);

#endif

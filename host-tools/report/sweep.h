/* SPDX-License-Identifier: MIT */
/* What a scene costs within each budget of auto, and what the plan did for it. */
#ifndef SWEEP_H
#define SWEEP_H

#include "reference/reference.h"
#include "report/survey.h"

#include <stdio.h>

/* Draws the scene of `path` within each budget for which costs->budgets has it on every cpu. Returns the exit code of
 * the command line; whenever it is not 0, one line has been printed on stderr. */
int sweep_measure(struct survey *survey, const char *path, const struct scene_header *scene,
                  const struct reference_image *truth, const struct costs *costs);

/* Writes what to choose when, a table, and pictures of what was drawn by what, as HTML; nothing where no budget was
 * measured. False: out of memory. */
bool sweep_write(FILE *out, const struct survey *survey);

/* The colours of such pictures. */
void sweep_legend(FILE *out);

/* The same figures as CSV. */
void sweep_csv_head(FILE *out);
void sweep_csv(FILE *out, const struct survey *survey);

#endif

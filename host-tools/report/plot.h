/* SPDX-License-Identifier: MIT */
/* Cost against accuracy as a picture, by gnuplot. */
#ifndef PLOT_H
#define PLOT_H

#include "report/survey.h"

#include <stdio.h>

enum plot_sort { PLOT_PSNR, PLOT_LARGEST };

/* Writes an SVG element to `out`, to be inlined in a page: PSNR, or the largest difference, over the instructions of a
 * frame on one cpu, with the methods' Pareto set filled and joined, and auto's budgets as a line of their own. Ids
 * begin with the scene's name and the cpu's; what gnuplot draws black stands in attributes that a style sheet can
 * override. Returns the exit code of the command line; whenever it is not 0, one line has been printed on stderr. */
int plot_write(FILE *out, const struct survey *survey, enum costs_cpu cpu, enum plot_sort sort);

/* PSNR to be shown: that of a picture without error has no number. */
double plot_decibel(const struct compare_result *error);

#endif

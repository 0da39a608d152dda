/* SPDX-License-Identifier: MIT */
/* The report as one page without scripts or other files, and as a table for other programs. */
#ifndef PAGE_H
#define PAGE_H

#include "report/survey.h"

#include <stdio.h>

/* Those that follow the scenes, if there are any figures for them. */
struct page_sections {
    bool effects, power, choices, streams, boards;
};

/* The page in its order: what it is, with links to the scenes of these files and to the sections that follow
 * (effects.h, angle.h, powers.h, choices.h, streams.h, boards.h); a table of one scene; then scene by scene.
 * page_scene() returns the exit code of the command line; when it is not 0, one line has been printed on stderr.
 */
void page_begin(FILE *out, const char *const paths[], unsigned count, const struct page_sections *sections);
void page_summary(FILE *out, const struct survey *survey);
int page_scene(FILE *out, const struct survey *survey);
void page_end(FILE *out);

/* The same figures as CSV. */
void page_csv_head(FILE *out);
void page_csv(FILE *out, const struct survey *survey);

#endif

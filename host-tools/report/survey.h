/* SPDX-License-Identifier: MIT */
/*
 * A scene drawn by every method as a device would, in 8-bit grey at its camera's size, beside the truth: per-pixel
 * Phong in double precision, the normal interpolated correctly in perspective (reference.h). Differences are taken from
 * the truth before it is rounded, so that 8-bit output alone allows 58.9 dB, over the pixels that the scene covers.
 *
 * A scene NAME.json beside which lies NAME-ideal.json is a coarse mesh of that: the ideal scene is the truth, over the
 * pixels that both cover.
 */
#ifndef SURVEY_H
#define SURVEY_H

#include "compare/compare.h"
#include "glint.h"
#include "report/costs.h"

#include <stdbool.h>

#define SURVEY_NAME   64
#define SURVEY_MARGIN 2 /* pixels around what is covered */

struct survey_row {
    const char *method;
    struct compare_result error;
    uint32_t instructions[COSTS_CPUS]; /* a frame */
    uint32_t flash[COSTS_CPUS];        /* bytes */
    /* Of the methods that cost no more here and err no more (by rms), one of the two being less, the one that errs
     * least, of equals the cheapest; null: there is none, and the method belongs to the Pareto set. */
    const char *beaten_by[COSTS_CPUS];
    uint8_t *grey;       /* width x height: what it draws */
    uint8_t *difference; /* the same: picture_level() of what it is too bright, where compared, plus PICTURE_RIGHT */
};

/* By auto within a budget. */
struct survey_budget {
    unsigned budget_q8;
    struct compare_result error;
    uint32_t instructions[COSTS_CPUS];
    struct glint_stats stats; /* of its frame */
    uint8_t *plan;            /* width x height, RGB888: what it was drawn by (glint_auto_shown) */
};

struct survey_box {
    unsigned left, top, width, height;
};

struct survey {
    char scene[SURVEY_NAME];
    unsigned width, height;
    bool perspective;
    unsigned long triangles;       /* of all objects */
    unsigned long ideal_triangles; /* of the ideal scene; 0: there is none */
    uint8_t *truth;                /* rounded to 8 bits */
    uint8_t *covered;              /* 1 where pixels are compared */
    struct survey_box box;         /* of those pixels, with a margin: what is worth showing */
    struct survey_row *rows;       /* cheapest on the first cpu first; of equals the more exact */
    unsigned count;
    struct survey_budget *budgets; /* as costs->budgets has them; those of the file, smallest first */
    unsigned budget_count;
};

/* Draws and measures the scene of a file by methods[count], names that exist. Returns the exit code of the command
 * line; whenever it is not 0, one line has been printed on stderr. To be given to survey_free() in any case. */
int survey_open(struct survey *survey, const char *path, const char *const methods[], unsigned count,
                const struct costs *costs);
void survey_free(struct survey *survey);

/* The scene's name: that of its file without folder and ending. False: it is too long, or has other characters than
 * letters, digits, - and _. */
bool survey_name(const char *path, char name[SURVEY_NAME]);

/* Sorts rows and finds who beats whom. */
void survey_rank(struct survey_row *rows, unsigned count);

#endif

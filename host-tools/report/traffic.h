/* SPDX-License-Identifier: MIT */
/*
 * What pictures take as a stream: a scene that moves is drawn by X, at TRAFFIC_MOMENTS of its loop (of 4 s, if it has
 * none), and again TRAFFIC_STEP_MS later; the second picture of each pair goes through the encoder, headers included,
 * in four bands, as the Linux handheld sends it and the board with an OLED. Where nothing moves, each object is given a
 * turn in 4 s.
 */
#ifndef TRAFFIC_H
#define TRAFFIC_H

#include "glint.h"
#include "report/survey.h"

#include <stdbool.h>

#define TRAFFIC_MOMENTS 20
#define TRAFFIC_STEP_MS 20 /* 50 pictures a second */

struct traffic_kind {
    const char *name; /* of letters, digits and spaces */
    enum glint_format format;
    uint16_t width, height;
    bool dither;
};
enum { TRAFFIC_KINDS = 6 };
extern const struct traffic_kind traffic_kinds[TRAFFIC_KINDS];

/* Ways to send a picture. */
enum traffic_way {
    TRAFFIC_RAW,    /* codec 0, all rows */
    TRAFFIC_ROWS,   /* codec 0, those rows that are not as in the last picture: nothing here sends so */
    TRAFFIC_ALONE,  /* each picture by itself, a key frame: codec 1, or 0 for a band that would not be shorter */
    TRAFFIC_CHANGE, /* against the last picture: codec 2, or 0; this is what is sent */
    TRAFFIC_LEAST,  /* the shorter of the two for each band, had both been tried */
    TRAFFIC_WAYS
};
extern const char *const traffic_ways[TRAFFIC_WAYS]; /* for a CSV file's head */

struct traffic {
    char scene[SURVEY_NAME];
    uint32_t mean[TRAFFIC_KINDS][TRAFFIC_WAYS]; /* bytes a picture, rounded */
    uint32_t most[TRAFFIC_KINDS][TRAFFIC_WAYS];
};

/* Draws and sends the scene of a file as one kind, into one row of `traffic`, or as all of them. Returns the exit code
 * of the command line; whenever it is not 0, one line has been printed on stderr. */
int traffic_measure_kind(struct traffic *traffic, const char *path, unsigned kind);
int traffic_measure(struct traffic *traffic, const char *path);

#endif

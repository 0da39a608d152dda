/* SPDX-License-Identifier: MIT */
/*
 * Pictures of a stream as a film: animated PNG (.png, .apng) or YUV4MPEG2 (.y4m). It runs as the device drew, by its
 * own times; a gap of more than PLAYBACK_GAP_US is cut to that, and the last picture lasts as long as the one before.
 *
 * Animated PNG: every picture with every bit, of which only the rectangle that changed is stored; moments to 1 ms.
 * YUV4MPEG2: a fixed number of pictures a second. A picture begins at the moment nearest to its own and is repeated
 * until the next begins; one that begins with the next is left out. BT.601, limited range, 4:4:4 (hal/host/y4m.c).
 *
 * The file appears when it is closed, whole. Exit codes as everywhere (cli.h), with a message; after any but CLI_DONE
 * it is closed.
 */
#ifndef VIEW_RECORD_H
#define VIEW_RECORD_H

#include "host/displays.h"
#include "view/frames.h"

#define RECORD_RATE 60

struct record {
    uint32_t rate; /* of YUV4MPEG2, pictures a second; 0: RECORD_RATE. Set by the caller, all else is zero at first */

    const char *path; /* null: closed */
    const struct record_kind *kind;
    struct host_display host; /* open from the first picture on */
    uint32_t pictures;        /* taken */
    uint32_t written;         /* of them, or for y4m of the film's */
    uint32_t time_us;         /* the device's, of the last picture */
    uint64_t at_us, gap_us;   /* when that begins in the film; since the one before it */
    uint64_t held_us;         /* when `held` began */
    uint8_t *held, *before;   /* animated PNG: a picture is written when it is known how long it lasts */
};

/* CLI_BAD_USAGE for another ending. Nothing is opened before the first picture. The path stays the caller's. */
int record_open(struct record *record, const char *path);

/* Does nothing if it is closed. Where size or format is another than before, the film ends, is kept and CLI_BAD_DATA
 * returned. */
int record_picture(struct record *record, const struct frames_picture *picture);

/* Without a picture, or if it is not kept, there is no file. Harmless if it is closed. */
int record_close(struct record *record, bool keep);

#endif

/* SPDX-License-Identifier: MIT */
/* glint-view's command line. */
#ifndef VIEW_OPTIONS_H
#define VIEW_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#define OPTIONS_NAME "glint-view"
#define OPTIONS_NONE UINT32_MAX /* not asked for */

struct options {
    const char *input;                                 /* "usb:" if none was given */
    const char *serial;                                /* of a device on USB, or null */
    const char *dump, *scene, *method, *record, *save; /* or null */
    uint32_t frames;                                   /* wanted; 0: all */
    uint32_t record_fps;
    uint32_t wait;          /* at most so many seconds for an answer; 0: for ever */
    uint32_t budget, pause; /* to be asked for, or OPTIONS_NONE */
    uint32_t scale, rotate; /* 0: as it fits; degrees */
    bool headless;          /* also implied by what has no use for a window */
    bool fullscreen;
    bool list;         /* the devices on USB, and nothing else */
    bool trace, names; /* print a line for each picture; what the device offers */
};

/* An exit code, with a message, or -1 to go on. What is not on the command line has its default. */
int options_parse(struct options *options, int argc, char **argv);

#endif

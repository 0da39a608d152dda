/* SPDX-License-Identifier: MIT */
/* What a session with a window does besides: it shows pictures when they are due, and does what the keys say. */
#ifndef VIEW_LIVE_H
#define VIEW_LIVE_H

#include "view/controls.h"
#include "view/dump.h"
#include "view/meter.h"
#include "view/playback.h"
#include "view/status.h"
#include "view/window.h"

#define LIVE_WAIT_MS 4   /* for bytes, between looks at the keys */
#define LIVE_SLICE   128 /* bytes of a recording at a time: less than any picture takes, so that one comes at most */

struct session;

/* A picture with pixels of its own. */
struct live_picture {
    struct frames_picture picture; /* pixels null: none */
    uint8_t *pixels;
    size_t room;
    unsigned connections; /* of the port, when it came */
};

struct live {
    struct window *window;          /* null: none, and nothing of this is used but `meter` */
    struct controls controls, done; /* as the keys have it; as it was when it was last done */
    struct meter meter;
    struct playback playback; /* of a recording */
    struct status_notes notes;
    struct live_picture shown, next; /* next: received, and not shown so far */
    bool waits;                      /* there is such a one */
    double opened, told;             /* when the window was, and the device of the buttons; by cli_clock() */
    double hint;                     /* until when the keys' key is named */
    char film[DUMP_NAME];            /* recorded by key; empty: none */
    unsigned scale;                  /* as last asked for */
    bool there, words;               /* the device was; the words must be written anew */
    const char *why;                 /* it was not */
};

/* Exit codes, with a message. */
int live_open(struct session *session);
void live_close(struct live *live);

void live_picture(struct session *session, const struct frames_picture *picture);
/* A recording has ended, of itself. True if it was begun by key, and so ends nothing else. */
bool live_film_ended(struct live *live);

void live_log(struct live *live, const char *text, size_t length);

/* Of a recording, or a pipe, nothing more is to be read before what has been is shown. */
bool live_holds(const struct session *session);

/* To be called every few milliseconds: false when the window is closed. */
bool live_step(struct session *session);

#endif

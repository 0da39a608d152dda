/* SPDX-License-Identifier: MIT */
/* From a port to pictures, for as long as they are wanted; and what is asked of the device. */
#ifndef VIEW_SESSION_H
#define VIEW_SESSION_H

#include "view/frames.h"
#include "view/live.h"
#include "view/names.h"
#include "view/options.h"
#include "view/port.h"
#include "view/record.h"
#include "view/save.h"

/* In the order of session.c's table. The values are as in a picture: places in the device's lists, 1..255, 0 or 1. */
enum session_wish { SESSION_BUDGET, SESSION_PAUSE, SESSION_SCENE, SESSION_METHOD, SESSION_WISHES };

struct session {
    const struct options *options;
    struct frames frames;
    struct port port;
    struct names names;
    struct record record;
    struct save save;
    struct live live;
    uint32_t wishes[SESSION_WISHES]; /* asked of the device, or OPTIONS_NONE */
    bool obeyed;                     /* by the last picture, in all of these */
    bool counts;                     /* it does, if it obeyed; with a window also if any before it did */
    double asked;                    /* when, by cli_clock() */
    uint32_t seen;                   /* pictures when it was */
    double heard;                    /* when the last good message had come */
    uint32_t messages;               /* that had */
    unsigned connections;            /* of the port, that have been greeted */
    uint32_t pictures;               /* that count */
    uint64_t counted;                /* their bytes */
    uint8_t bytes[PORT_MOST];        /* read, of which [at, count) is not yet looked at; all, that none may be old */
    size_t at, count;
    bool ended; /* nothing will be read any more */
    int code;
};

/* Lets the device be asked, until a picture shows that it has heard. */
void session_wish(struct session *session, enum session_wish wish, uint32_t value);

/* Sends a request now. */
void session_send(struct session *session, enum stream_type type, uint32_t value);

/* All of it: an exit code, with a message but for standard output, which the caller looks at. The signals are caught
 * from here on. */
int session_run(struct session *session, const struct options *options);

/* What is recorded and saved so far is kept, and no more is: an exit code, with a message. Harmless when it is done. */
int session_keep(struct session *session);

#endif

/* SPDX-License-Identifier: MIT */
/* From a port to pictures, for as long as they are wanted; and what is asked of the device. */
#ifndef VIEW_SESSION_H
#define VIEW_SESSION_H

#include "view/frames.h"
#include "view/names.h"
#include "view/options.h"
#include "view/port.h"
#include "view/record.h"
#include "view/save.h"

struct session {
    const struct options *options;
    struct frames frames;
    struct port port;
    struct names names;
    struct record record;
    struct save save;
    uint32_t scene, method; /* asked for, by place in the device's lists, or OPTIONS_NONE */
    bool obeyed;            /* by the last picture, in all that was asked: those before do not count */
    double asked;           /* when, by cli_clock() */
    double heard;           /* when the last good message had come */
    uint32_t messages;      /* that had */
    unsigned connections;
    uint32_t seen;     /* pictures when it was */
    uint32_t pictures; /* that count */
    uint64_t bytes;
    int code;
};

/* All of it: an exit code, with a message. The signals are caught from here on. */
int session_run(struct session *session, const struct options *options);

#endif

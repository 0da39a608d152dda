/* SPDX-License-Identifier: MIT */
/* What the window says in words. */
#ifndef VIEW_STATUS_H
#define VIEW_STATUS_H

#include "view/meter.h"
#include "view/names.h"
#include "view/overlay.h"

struct status {
    const char *port;
    const struct names *names;
    const struct frames_picture *picture; /* on the screen; null: none so far */
    const struct meter *meter;
    uint32_t lost;
    bool details; /* all that is known of it, not only what most want to see */
};

/* Each adds lines; no figures without a picture. */
void status_figures(const struct status *status, struct overlay_text *text);
void status_keys(struct overlay_text *text);

/* One line, cut off if it has no room. */
void status_title(const struct status *status, char *title, size_t room);

#define STATUS_NOTES   4u
#define STATUS_NOTE_MS 5000. /* that a note stays */

/* What is shown for a while: the last few. All zero at first. */
struct status_notes {
    struct status_note {
        char text[OVERLAY_COLUMNS * 4 + 1];
        double until; /* 0: none */
    } notes[STATUS_NOTES];
};

void status_note(struct status_notes *notes, const char *text, size_t length, double now);

/* Drops what has had its time; true if there was any. */
bool status_forget(struct status_notes *notes, double now);
void status_list(const struct status_notes *notes, struct overlay_text *text);

#endif

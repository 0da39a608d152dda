/* SPDX-License-Identifier: MIT */
/*
 * The other end of a line, as firmware/stream/PROTOCOL.md has it: its requests do what the buttons and the menu do, and
 * a key frame please makes the next picture go out too, as it is on the display, behind hello. Over a link all pictures
 * go out that it has room for, each as what has changed since the last of them.
 */
#ifndef APP_REMOTE_H
#define APP_REMOTE_H

#include "stream/receive.h"
#include "stream/stream.h"

#define REMOTE_HELD_US 1000000u /* for so long a button is held that is not told of again */

/* The stream's write is set by who has the line; all else is zero at first. */
struct remote {
    uint32_t buttons, held_us; /* told to be held (enum hal_button), and for how long yet */
    uint32_t pack_us;          /* to pack and send the picture so far */
    uint32_t skipped;          /* pictures that the link had no room for */
    uint32_t sending;          /* the picture under way goes out, or the last one did */
    struct stream stream;      /* its key: a picture is asked for */
    struct stream_receiver receiver;
};

struct app;
struct glint_band;

/* Takes bytes from the line, or HAL_LINK_COMES of them: what they change, a set of enum control_effect. */
unsigned remote_hear(struct app *app, const uint8_t *bytes, int32_t count);

/* The buttons that the other end holds down; so much time has passed since the last call. */
uint32_t remote_buttons(struct remote *remote, uint32_t elapsed_us);

/* Around every picture's bands, each of them just given to the display: sends them if asked to, or over a link. What is
 * packed goes into the other band's memory: it is free until the next is drawn, for the display has only this one under
 * way. */
void remote_begin(struct app *app);
void remote_band(struct app *app, const struct glint_band *band);
void remote_end(struct app *app);

#endif

/* SPDX-License-Identifier: MIT */
/* The viewer's window: a picture, enlarged a whole number of times, and words over it. */
#ifndef VIEW_WINDOW_H
#define VIEW_WINDOW_H

#include "view/controls.h"
#include "view/frames.h"
#include "view/overlay.h"

struct window;

/* Not shown so far. An exit code, with a message that names --headless: no display, or built without SDL2. */
int window_open(struct window **window);
void window_close(struct window *window); /* null: does nothing */

/* Waits so long, then does what the keys since the last call say; true if the window must be drawn anew. */
bool window_keys(struct window *window, struct controls *controls, int wait_ms);

/* Makes the window as large as a picture of this size takes, a pixel being `scale` wide; 0: about half the screen. */
void window_size(struct window *window, uint32_t width, uint32_t height, unsigned scale);
void window_fullscreen(struct window *window, bool fullscreen);
void window_title(struct window *window, const char *title);

/* What the next window_draw() shows: a picture, darkened if it is an old one; lines, by enum overlay_place. */
int window_picture(struct window *window, const struct frames_picture *picture, unsigned rotation);
void window_dim(struct window *window, bool dim);
void window_words(struct window *window, const struct overlay_text text[OVERLAY_PLACES]);

/* Never waits for the screen. */
void window_draw(struct window *window);

/* What it shows, as PNG. */
int window_save(struct window *window, const char *path);

#endif

/* SPDX-License-Identifier: MIT */
/* Where SDL2 is missing no window opens, and so nothing asks more of one. */
#ifndef HAVE_SDL2
#include "view/window.h"

#include "glint/cli.h"

#include <stdio.h>

int window_open(struct window **window)
{
    *window = NULL;
    fprintf(stderr, "window: built without SDL2 (`make view` has it); --headless needs no window\n");
    return CLI_IO;
}

void window_close(struct window *window)
{
    (void)window;
}

bool window_keys(struct window *window, struct controls *controls, int wait_ms)
{
    (void)window, (void)controls, (void)wait_ms;
    return false;
}

void window_size(struct window *window, uint32_t width, uint32_t height, unsigned scale)
{
    (void)window, (void)width, (void)height, (void)scale;
}

void window_fullscreen(struct window *window, bool fullscreen)
{
    (void)window, (void)fullscreen;
}

void window_title(struct window *window, const char *title)
{
    (void)window, (void)title;
}

int window_picture(struct window *window, const struct frames_picture *picture, unsigned rotation)
{
    (void)window, (void)picture, (void)rotation;
    return CLI_IO;
}

void window_dim(struct window *window, bool dim)
{
    (void)window, (void)dim;
}

void window_words(struct window *window, const struct overlay_text text[OVERLAY_PLACES])
{
    (void)window, (void)text;
}

void window_draw(struct window *window)
{
    (void)window;
}

int window_save(struct window *window, const char *path)
{
    (void)window, (void)path;
    return CLI_IO;
}
#endif

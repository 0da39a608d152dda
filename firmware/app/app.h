/* SPDX-License-Identifier: MIT */
/*
 * The handheld's program: scenes from flash, drawn in bands on a board's display, changed by its buttons.
 *
 *   left, right   the scene before, the next        up, down      the next method, the one before
 *   A             stop the animation, or go on      A + up        figures on the screen, or none
 *   A + right     stopped: 100 ms on                A + left      stopped: 100 ms back
 *
 * Each change is reported on the serial line when its picture is on the display:
 * `frame SCENE METHOD MOMENT ms, N us` (N: to draw it, without the display), with `running`, `N dropped` (triangles,
 * for lack of memory) where it applies, or `error SCENE: reason`.
 */
#ifndef APP_H
#define APP_H

#include "app/text.h"
#include "boards/board.h"

/* A scene that is linked in: its packed bytes. The list is made at build. */
struct app_scene {
    const char *name;
    const uint32_t *blob;
    const uint32_t *length;
};
extern const struct app_scene app_scenes[];
extern const unsigned app_scene_count;

/* What is being shown. */
struct app {
    const struct board *board;
    const struct app_scene *scene;
    const struct glint_choice *method;
    uint32_t moment_ms;
    uint8_t paused, figures;
    const char *problem; /* why there is no picture, or null */
    struct glint_frame frame;
    uint32_t draw_us; /* the last picture, without the display */
    uint32_t rate;    /* pictures a second, times 10 */
};

/* Checks app->scene and readies the renderer for it and app->method; sets app->problem. A scene that takes more memory
 * than the board has is drawn in part. */
void show_ready(struct app *app);

/* Draws the moment, or the problem, and sends it: 0, or the display's error. */
int show_frame(struct app *app);

#endif

/* SPDX-License-Identifier: MIT */
/*
 * The handheld's program: scenes from flash, drawn in bands on a board's display, turned and changed by its buttons.
 *
 *   arrows, held   turn the object, 90 degrees a second      A   opens and closes the menu
 *   B              stops the animation, lets it go on        X   the next method        Y   the next scene
 *   any one held while the board starts: the display's test, until it is released
 *
 * In the menu up and down choose a line, left and right change it:
 *
 *   SCENE METHOD   the one before, the next                  TIME     stops the animation; 100 ms back, on
 *   BUDGET         the error a pixel may have, in 1/255      TURN     the object as it was
 *   MOTION         stops the animation, lets it go on        INFO     figures on the screen: none, or shown
 *   SCREEN         left: sends the whole picture anew; right: the display's test while it is held
 *
 * Each change, and the end of each turn, is told on the serial line when its picture is on the display, in clauses
 * apart by ", " of which those in brackets may be missing:
 *
 *   frame SCENE METHOD MOMENT ms, N us, turn YAW,PITCH, budget N, N bytes[, running][, N dropped][, menu LINE], stack N
 *   error SCENE: reason[, menu LINE], stack N
 *   error display
 *   test NAME WIDTHxHEIGHT[, rotation DEGREES][, menu LINE], stack N
 *
 * us: to draw the picture, without the display; turn: degrees, to be given to `glint render --turn`; bytes: sent to the
 * display; dropped: triangles that found no room in memory; stack: the most bytes of it that were ever in use.
 */
#ifndef APP_H
#define APP_H

#include "app/control.h"
#include "app/program_scene.h"
#include "app/remote.h"
#include "app/share.h"
#include "app/text.h"
#include "boards/board.h"

/* What is being shown. */
struct app {
    const struct board *board;
    struct control control;
    struct remote remote;
    const char *problem; /* why there is no picture, or null */
    struct share share;
    uint32_t buttons; /* seen, or told of, since the last picture was begun: what is pressed shortly is not missed */
    uint32_t rate;    /* pictures a second, times 10; 0: none follow one another */
    uint32_t sent;    /* bytes of the last picture that is complete, where the display counts them */
};

static inline const struct program_scene *app_scene(const struct app *app)
{
    return program_scenes + app->control.scene;
}
static inline const struct glint_choice *app_method(const struct app *app)
{
    return glint_choices + app->control.method;
}

/* How it begins and ends, where somebody can say so. */
struct app_start {
    struct control control; /* scene, method, budget, running, figures, moment_ms */
    uint32_t period_us;     /* from one picture to the next at the least */
    uint32_t step_us;       /* that pass from one picture to the next, however long it took; 0: as many as did */
    uint32_t pictures;      /* to show, then to end; 0: no end */
};

/* As it begins where nobody says otherwise. */
void app_usual(struct app_start *start);

/* Opens the board's display and shows pictures, until HAL_QUIT is among the buttons or start->pictures are shown, and
 * closes it: 0, or 3 if the display failed and did not open anew. */
int app_run(const struct board *board, const struct app_start *start);

/* Checks the scene and readies the renderer for it, its method and budget; sets app->problem. A scene that takes more
 * memory than the board has is drawn in part. */
void show_ready(struct app *app);

/* Draws the moment, the problem or the display's test, and sends it: 0, or the display's error. */
int show_frame(struct app *app);

/* Returns when the picture is on the display, which with a second CPU may be later: 0, or the display's error. */
int show_finish(struct app *app);

/* The next picture is sent whole, where the display leaves out what has not changed. */
void show_repaint(const struct app *app);

/* Draws the menu on a band. A label and a space take 7 columns: a method's name beside it fills the 30 of large letters
 * on 240 pixels. */
#define MENU_LABEL 7u
extern const char menu_labels[CONTROL_LINES][MENU_LABEL];
void menu_draw(const struct app *app, const struct text_canvas *canvas);

/* What the serial line is told of the picture on show, or of the display under test, without the line's end. */
void report_picture(const struct app *app, struct text_line *line);
void report_test(const struct app *app, struct text_line *line);

#endif

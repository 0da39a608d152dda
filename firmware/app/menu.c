/* SPDX-License-Identifier: MIT */
/* The menu: no wider than it must, so that much of the scene stays in sight. */
#include "app/app.h"

#define MENU_COLUMNS 19u /* of "screen redraw/test "; longer lines stand out */

const char menu_labels[CONTROL_LINES][MENU_LABEL] = {"scene", "method", "budget", "motion",
                                                     "time",  "turn",   "info",   "screen"};

static void menu_line(const struct app *app, enum control_line number, struct text_line *line)
{
    const struct control *c = &app->control;
    text_add(line, menu_labels[number]);
    text_pad(line, MENU_LABEL);
    switch (number) {
    case CONTROL_LINE_SCENE:
        text_add(line, app_scene(app)->name);
        break;
    case CONTROL_LINE_METHOD:
        text_add(line, app_method(app)->name);
        break;
    case CONTROL_LINE_BUDGET:
        text_add_number(line, c->budget);
        text_add(line, "/255");
        break;
    case CONTROL_LINE_MOTION:
        text_add(line, c->running ? "on" : "off");
        break;
    case CONTROL_LINE_TIME:
        text_add_number(line, c->moment_ms);
        text_add(line, " ms");
        break;
    case CONTROL_LINE_TURN:
        text_add_number(line, (c->yaw * 360u + 32768) >> 16);
        text_add(line, ",");
        text_add_number(line, (c->pitch * 360u + 32768) >> 16);
        break;
    case CONTROL_LINE_INFO:
        text_add(line, c->figures ? "on" : "off");
        break;
    default: /* CONTROL_LINE_SCREEN */
        text_add(line, "redraw/test");
    }
}

void menu_draw(const struct app *app, const struct text_canvas *canvas)
{
    struct text_canvas own = *canvas;
    for (unsigned i = 0; i < CONTROL_LINES; i++) {
        struct text_line line = {.length = 0};
        menu_line(app, (enum control_line)i, &line);
        text_pad(&line, MENU_COLUMNS);
        own.dark = i == app->control.line;
        text_draw(&own, 0, (i + 1) * text_height(own.width), line.text);
    }
}

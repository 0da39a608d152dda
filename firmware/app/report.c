/* SPDX-License-Identifier: MIT */
/* Lines for the serial line, as app.h says. */
#include "app/app.h"
#include "panels/panel.h"

static void report_clause(struct text_line *line, const char *name, uint32_t value, const char *unit)
{
    text_add(line, ", ");
    text_add(line, name);
    text_add_number(line, value);
    text_add(line, unit);
}

static void report_frame(const struct app *app, struct text_line *line)
{
    const struct control *c = &app->control;
    text_add(line, "frame ");
    text_add(line, app_scene(app)->name);
    text_add(line, " ");
    text_add(line, app_method(app)->name);
    text_add(line, " ");
    text_add_number(line, c->moment_ms);
    text_add(line, " ms");
    report_clause(line, "", app->draw_us, " us, turn ");
    text_add_angle(line, c->yaw);
    text_add(line, ",");
    text_add_angle(line, c->pitch);
    report_clause(line, "budget ", c->budget, "");
    report_clause(line, "", app->sent, " bytes");
    if (c->running)
        text_add(line, ", running");
    if (app->frame.stats.dropped)
        report_clause(line, "", app->frame.stats.dropped, " dropped");
}

void report_test(const struct app *app, struct text_line *line)
{
    const struct board *board = app->board;
    text_add(line, "test ");
    text_add(line, board->name);
    text_add(line, " ");
    text_add_number(line, board->width);
    text_add(line, "x");
    text_add_number(line, board->height);
    if (board->display->ops == &panel_display)
        report_clause(line, "rotation ", ((const struct panel *)board->display)->rotation, "");
}

void report_picture(const struct app *app, struct text_line *line)
{
    if (app->control.test) {
        report_test(app, line);
    } else if (app->problem) {
        text_add(line, "error ");
        text_add(line, app_scene(app)->name);
        text_add(line, ": ");
        text_add(line, app->problem);
    } else {
        report_frame(app, line);
    }
    if (app->control.menu) {
        text_add(line, ", menu ");
        text_add(line, menu_labels[app->control.line]);
    }
}

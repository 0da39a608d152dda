/* SPDX-License-Identifier: MIT */
/* From a scene to the display. */
#include "app/app.h"
#include "clock.h"
#include "input.h"
#include "panels/panel.h"

#define SHOW_CLIPPED 64u /* pieces made by clipping, when memory is short */

/* The display as a panel, which has more to say than others; or null. */
static struct panel *show_panel(const struct app *app)
{
    struct hal_display *display = app->board->display;
    return display->ops == &panel_display ? (struct panel *)display : 0;
}

void show_repaint(const struct app *app)
{
    if (show_panel(app))
        panel_repaint(show_panel(app));
}

static struct glint_config show_config(const struct app *app)
{
    const struct board *board = app->board;
    return (struct glint_config){.width = board->width,
                                 .height = board->height,
                                 .band_rows = board->band_rows,
                                 .format = board->format,
                                 .flags = board->dither ? GLINT_DITHER : 0,
                                 .method = app_method(app)->method,
                                 .band = {board->band[0], board->band[1]},
                                 .memory = board->memory,
                                 .memory_bytes = board->memory_bytes,
                                 .tables = board->format == GLINT_RGB565,
                                 .subdivide_tolerance = app->control.budget};
}

/* Makes the stores smaller until they fit: first the table, which only makes it faster, then the room for clipping,
 * then the list of triangles in view. */
static int show_fit(struct glint_config *config)
{
    if (glint_memory_needed(config) > config->memory_bytes)
        config->tables = 0;
    if (glint_memory_needed(config) <= config->memory_bytes)
        return 0;
    if (config->max_clipped > SHOW_CLIPPED) {
        config->max_triangles = (uint16_t)(config->max_triangles - (config->max_clipped - SHOW_CLIPPED));
        config->max_clipped = SHOW_CLIPPED;
    }
    while (glint_memory_needed(config) > config->memory_bytes && config->max_triangles)
        config->max_triangles--;
    return config->max_triangles ? 0 : GLINT_E_MEMORY;
}

void show_ready(struct app *app)
{
    struct glint_config config = show_config(app);
    const struct program_scene *scene = app_scene(app);
    app->problem = 0;
    if (glint_scene_check(scene->blob, *scene->length) != 0) {
        app->problem = glint_scene_problem(scene->blob, *scene->length);
        return;
    }
    glint_fit_stores(&config, scene->blob);
    if (show_fit(&config) != 0 || glint_init(&app->frame, &config) != 0)
        app->problem = "no room for its vertices";
}

static struct text_canvas show_canvas(const struct app *app, const struct glint_band *band)
{
    return (struct text_canvas){.band = band, .width = app->board->width, .format = app->board->format};
}

static void show_figures(const struct app *app, const struct text_canvas *canvas)
{
    struct text_line line = {.length = 0};
    if (app->rate) {
        text_add_number(&line, app->rate / 10);
        text_add(&line, ".");
        text_add_number(&line, app->rate % 10);
        text_add(&line, " fps ");
    }
    text_add_number(&line, app->draw_us);
    text_add(&line, " us");
    if (app->frame.stats.dropped) {
        text_add(&line, " ");
        text_add_number(&line, app->frame.stats.dropped);
        text_add(&line, " dropped");
    }
    text_draw(canvas, 0, 0, line.text);
    line.length = 0;
    text_add(&line, app_method(app)->name);
    text_add(&line, " ");
    text_add_number(&line, app->sent);
    text_add(&line, " b");
    text_draw(canvas, 0, app->board->height - text_height(canvas->width), line.text);
}

static void show_overlay(const struct app *app, const struct glint_band *band)
{
    struct text_canvas canvas = show_canvas(app, band);
    if (app->control.figures)
        show_figures(app, &canvas);
    if (app->control.menu)
        menu_draw(app, &canvas);
}

/* Draws words on as many lines as they take, a letter from the picture's sides. */
static void show_words(const struct text_canvas *canvas, const char *text, unsigned y)
{
    const unsigned cell = text_width(canvas->width), columns = canvas->width / cell - 2;
    while (*text) {
        struct text_line line = {.length = 0};
        unsigned length = 0, end = 0;
        for (; length < columns && length < sizeof line.text - 1 && text[length]; length++)
            if (text[length] == ' ')
                end = length;
        end = !text[length] || end == 0 ? length : end;
        for (unsigned i = 0; i < end; i++)
            line.text[i] = text[i];
        line.text[end] = 0;
        text_draw(canvas, cell, y, line.text);
        y += text_height(canvas->width);
        text += text[end] == ' ' ? end + 1 : end;
    }
}

/* To the display, and over the line if the other end asked for it. */
static int show_band(struct app *app, struct hal_display *display, const struct glint_band *band)
{
    int result = display->ops->flush(display, band->pixels, band->y, band->rows, band->stride);
    remote_band(app, band);
    return result;
}

/* A picture without a scene: words on the display's test, or on black. */
static int show_plain(struct app *app, struct hal_display *display)
{
    const struct board *board = app->board;
    const struct panel *panel = app->control.test ? show_panel(app) : 0;
    const uint32_t stride = (board->format == GLINT_RGB565 ? 2u * board->width : (board->width + 1u) / 2);
    const unsigned line = text_height(board->width);
    struct text_line words = {.length = 0};
    int result = 0;
    if (app->control.test)
        report_test(app, &words);
    for (unsigned y = 0, index = 0; y < board->height && !result; y += board->band_rows, index ^= 1) {
        unsigned left = board->height - y;
        struct glint_band band = {board->band[index], (uint16_t)y,
                                  (uint16_t)(left < board->band_rows ? left : board->band_rows), stride};
        struct text_canvas canvas = show_canvas(app, &band);
        for (uint32_t i = 0; i < stride * band.rows; i++)
            ((uint8_t *)band.pixels)[i] = 0;
        for (unsigned row = 0; panel && row < band.rows; row++)
            panel_bars_row(panel, (uint8_t *)band.pixels + row * stride, y + row);
        if (app->control.test) {
            show_words(&canvas, words.text, 4 * line);
        } else {
            show_words(&canvas, app_scene(app)->name, 2 * line);
            show_words(&canvas, app->problem, 4 * line);
            if (app->control.menu)
                menu_draw(app, &canvas);
        }
        result = show_band(app, display, &band);
    }
    return result;
}

/* Draws and sends the bands; adds the time it took to draw. */
static int show_scene(struct app *app, struct hal_display *display)
{
    struct glint_band band;
    uint32_t begin = clock_us(), spent_us = 0;
    int result = 0;
    glint_turn(&app->frame, app->control.yaw, app->control.pitch);
    if (glint_frame_begin(&app->frame, app_scene(app)->blob, app->control.moment_ms) != 0) {
        app->problem = "cannot be drawn";
        return show_plain(app, display);
    }
    while (!result && glint_frame_next_band(&app->frame, &band)) {
        spent_us += clock_us() - begin;
        app->buttons |= input_buttons();
        show_overlay(app, &band);
        result = show_band(app, display, &band);
        begin = clock_us();
    }
    app->draw_us = spent_us;
    return result;
}

int show_frame(struct app *app)
{
    struct hal_display *display = app->board->display;
    int result = display->ops->frame_begin ? display->ops->frame_begin(display, 0, 0) : 0;
    remote_begin(app);
    if (!result)
        result = app->control.test || app->problem ? show_plain(app, display) : show_scene(app, display);
    if (!result && display->ops->frame_end)
        result = display->ops->frame_end(display);
    remote_end(app);
    app->sent = show_panel(app) ? show_panel(app)->sent : 0;
    return result;
}

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
                                 .budget = GLINT_BUDGET(app->control.budget, 1),
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

static void show_overlay(void *argument, const struct glint_band *band, int assisting);

static void show_share(struct app *app)
{
    const struct board *board = app->board;
    struct share *share = &app->share;
    share->core = board->core;
    share->display = board->display;
    for (unsigned i = 0; i < SHARE_MOST_BANDS; i++)
        share->band[i] = board->band[i];
    share->over = show_overlay;
    share->context = app;
    share_ready(share, board->worker, board->worker_bytes);
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
    if (show_fit(&config) != 0 || glint_init(&app->share.frame, &config) != 0)
        app->problem = "no room for its vertices";
    else
        show_share(app);
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
    text_add_number(&line, app->share.draw_us);
    text_add(&line, " us");
    if (app->share.frame.stats.dropped) {
        text_add(&line, " ");
        text_add_number(&line, app->share.frame.stats.dropped);
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

/* Figures and menu, on a band of the picture; a second CPU leaves the buttons to the first. */
static void show_overlay(void *argument, const struct glint_band *band, int assisting)
{
    struct app *app = argument;
    struct text_canvas canvas = show_canvas(app, band);
    if (!assisting)
        app->buttons |= input_buttons();
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

/* The scene's picture, by one CPU. */
static int show_scene(struct app *app, struct hal_display *display)
{
    struct share *share = &app->share;
    struct glint_band band;
    uint32_t begin = clock_us();
    int result = 0;
    while (!result && glint_frame_next_band(&share->frame, &band)) {
        show_overlay(app, &band, 0);
        share->part_us += clock_us() - begin;
        result = show_band(app, display, &band);
        begin = clock_us();
    }
    share->draw_us = share->part_us;
    return result;
}

/* All is on the panel. */
static int show_wait(const struct app *app)
{
    struct panel *panel = show_panel(app);
    return panel ? panel->bus->ops->wait(panel->bus) : 0;
}

/* Bands that are sent one after the other as they are made, and have left their buffers when this returns: share.c
 * knows nothing of it. A board with a link has a display that copies them: the last may still be on the wires. */
static int show_alone(struct app *app, int (*bands)(struct app *, struct hal_display *))
{
    struct hal_display *display = app->board->display;
    int result = share_finish(&app->share);
    if (!result && display->ops->frame_begin)
        result = display->ops->frame_begin(display, 0, 0);
    if (!result)
        result = bands(app, display);
    if (!result && display->ops->frame_end)
        result = display->ops->frame_end(display);
    return result || app->board->link ? result : show_wait(app);
}

int show_frame(struct app *app)
{
    struct share *share = &app->share;
    if (show_panel(app))
        app->sent = show_panel(app)->sent_last;
    remote_begin(app);
    if (!app->control.test && !app->problem) {
        glint_turn(&share->frame, app->control.yaw, app->control.pitch);
        if (share_begin(share, app_scene(app)->blob, app->control.moment_ms) != 0)
            app->problem = "cannot be drawn";
        else if (!app->remote.sending)
            return share_draw(share);
    }
    int result = show_alone(app, app->control.test || app->problem ? show_plain : show_scene);
    if (result) /* the other end has not all of it either */
        app->remote.stream.key |= app->remote.sending;
    remote_end(app);
    return result;
}

int show_finish(struct app *app)
{
    int result = share_finish(&app->share);
    if (!result)
        result = show_wait(app);
    if (show_panel(app))
        app->sent = show_panel(app)->sent_last;
    return result;
}

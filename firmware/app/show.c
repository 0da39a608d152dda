/* SPDX-License-Identifier: MIT */
/* From a scene to the display. */
#include "app/app.h"
#include "clock.h"

#define SHOW_CLIPPED 64u /* pieces made by clipping, when memory is short */

static struct glint_config show_config(const struct app *app)
{
    const struct board *board = app->board;
    return (struct glint_config){.width = board->width,
                                 .height = board->height,
                                 .band_rows = board->band_rows,
                                 .format = board->format,
                                 .flags = board->dither ? GLINT_DITHER : 0,
                                 .method = app->method->method,
                                 .band = {board->band[0], board->band[1]},
                                 .memory = board->memory,
                                 .memory_bytes = board->memory_bytes};
}

/* Makes the stores smaller until they fit: first the room for clipping, then the list of triangles in view. */
static int show_fit(struct glint_config *config)
{
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
    const struct app_scene *scene = app->scene;
    app->problem = 0;
    app->rate = 0;
    if (glint_scene_check(scene->blob, *scene->length) != 0) {
        app->problem = glint_scene_problem(scene->blob, *scene->length);
        return;
    }
    glint_fit_stores(&config, scene->blob);
    if (show_fit(&config) != 0 || glint_init(&app->frame, &config) != 0)
        app->problem = "no room for its vertices";
}

static void show_figures(const struct app *app, const struct glint_band *band)
{
    struct text_line line = {.length = 0};
    unsigned format = app->board->format, width = app->board->width;
    text_add_number(&line, app->rate / 10);
    text_add(&line, ".");
    text_add_number(&line, app->rate % 10);
    text_add(&line, " fps ");
    text_add_number(&line, app->draw_us);
    text_add(&line, " us");
    text_draw(band, format, width, 0, 0, line.text);
    text_draw(band, format, width, 0, app->board->height - TEXT_HEIGHT, app->method->name);
    if (app->frame.stats.dropped) {
        line.length = 0;
        text_add_number(&line, app->frame.stats.dropped);
        text_add(&line, " dropped");
        text_draw(band, format, width, 0, TEXT_HEIGHT, line.text);
    }
}

/* Draws words on lines as wide as the picture, from the top. */
static void show_words(const struct app *app, const struct glint_band *band, const char *text, unsigned y)
{
    const unsigned columns = app->board->width / TEXT_WIDTH;
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
        text_draw(band, app->board->format, app->board->width, 0, y, line.text);
        y += TEXT_HEIGHT;
        text += text[end] == ' ' ? end + 1 : end;
    }
}

static int show_problem(const struct app *app, struct hal_display *display)
{
    const struct board *board = app->board;
    uint32_t stride = (board->format == GLINT_RGB565 ? 2u * board->width : (board->width + 1u) / 2);
    int result = 0;
    for (unsigned y = 0, index = 0; y < board->height && !result; y += board->band_rows, index ^= 1) {
        unsigned left = board->height - y;
        struct glint_band band = {board->band[index], (uint16_t)y,
                                  (uint16_t)(left < board->band_rows ? left : board->band_rows), stride};
        for (uint32_t i = 0; i < stride * band.rows; i++)
            ((uint8_t *)band.pixels)[i] = 0;
        show_words(app, &band, app->scene->name, 2 * TEXT_HEIGHT);
        show_words(app, &band, app->problem, 4 * TEXT_HEIGHT);
        result = display->ops->flush(display, band.pixels, band.y, band.rows, band.stride);
    }
    return result;
}

/* Draws and sends the bands; adds the time it took to draw. */
static int show_picture(struct app *app, struct hal_display *display)
{
    struct glint_band band;
    uint32_t begin = clock_us(), spent_us = 0;
    int result = 0;
    if (glint_frame_begin(&app->frame, app->scene->blob, app->moment_ms) != 0) {
        app->problem = "cannot be drawn";
        return show_problem(app, display);
    }
    while (!result && glint_frame_next_band(&app->frame, &band)) {
        spent_us += clock_us() - begin;
        if (app->figures)
            show_figures(app, &band);
        result = display->ops->flush(display, band.pixels, band.y, band.rows, band.stride);
        begin = clock_us();
    }
    app->draw_us = spent_us;
    return result;
}

int show_frame(struct app *app)
{
    struct hal_display *display = app->board->display;
    int result = display->ops->frame_begin ? display->ops->frame_begin(display, 0, 0) : 0;
    if (!result)
        result = app->problem ? show_problem(app, display) : show_picture(app, display);
    if (!result && display->ops->frame_end)
        result = display->ops->frame_end(display);
    return result;
}

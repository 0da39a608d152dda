/* SPDX-License-Identifier: MIT */
/*
 * What a picture costs on a board, by the board's own clock: for every scene and principal method one line
 * `cost SCENE METHOD TABLE DRAWN WHOLE CHANGES BYTES BYTES_CHANGES`: microseconds to draw a picture, to draw and send
 * it whole, to draw and send what has changed 50 ms later, and the bytes on the wire of both; then `stack BYTES`, the
 * most that was taken, and `end`. `dropped SCENE METHOD N` where triangles find no room.
 */
#include "boards/board.h"
#include "clock.h"
#include "cortexm/machine.h"
#include "cortexm/stack.h"
#include "panels/panel.h"
#include "tests/device/program.h"

#define STEP_MS 50u /* between the picture that is sent whole and the next: 20 a second */

static const struct {
    const char *name;
    const struct glint_method *method;
    uint8_t table;
} methods[] = {{"gouraud", &glint_gouraud, 0}, {"x", &glint_x, 1}, {"x", &glint_x, 0}, {"phong", &glint_phong, 0}};

int main(void);

void program_write(const char *text)
{
    machine_write(text);
}

/* A picture, sent where there is a display; the microseconds, or 0 if it cannot be. */
static uint32_t cost_frame(struct glint_frame *frame, const void *scene, uint32_t time_ms, struct panel *panel)
{
    struct hal_display *display = panel ? &panel->display : 0;
    struct glint_band band;
    int error = display ? display->ops->frame_begin(display, 0, 0) : 0;
    uint32_t begin = clock_us();
    if (!error)
        error = glint_frame_begin(frame, scene, time_ms);
    while (!error && glint_frame_next_band(frame, &band))
        if (display)
            error = display->ops->flush(display, band.pixels, band.y, band.rows, band.stride);
    if (display && !error)
        error = panel->bus->ops->wait(panel->bus);
    uint32_t spent = clock_us() - begin;
    if (display && !error)
        error = display->ops->frame_end(display);
    return error ? 0 : spent;
}

static int cost_init(struct glint_frame *frame, const struct board *board, const struct program_scene *scene,
                     unsigned m)
{
    struct glint_config config = {.width = board->width, .height = board->height, .format = board->format};
    if (glint_scene_check(scene->blob, *scene->length) != 0)
        return -1;
    glint_fit_stores(&config, scene->blob);
    config.band_rows = board->band_rows;
    config.flags = board->dither ? GLINT_DITHER : 0;
    config.method = methods[m].method;
    config.tables = methods[m].table;
    config.band[0] = board->band[0];
    config.band[1] = board->band[1];
    config.memory = board->memory;
    config.memory_bytes = board->memory_bytes;
    return glint_init(frame, &config);
}

static void cost_line(const struct board *board, const struct program_scene *scene, unsigned m)
{
    struct panel *panel = (struct panel *)board->display;
    struct glint_frame frame;
    struct line line = {.length = 0};
    uint32_t figures[5];
    if (cost_init(&frame, board, scene, m) != 0)
        return;                            /* there is no memory for its table: the line without it stands for both */
    cost_frame(&frame, scene->blob, 0, 0); /* makes the table */
    figures[0] = cost_frame(&frame, scene->blob, 0, 0);
    panel_repaint(panel);
    figures[1] = cost_frame(&frame, scene->blob, 0, panel);
    figures[3] = panel->sent;
    figures[2] = cost_frame(&frame, scene->blob, STEP_MS, panel);
    figures[4] = panel->sent;
    line_text(&line, frame.stats.dropped ? "dropped " : "cost ");
    line_text(&line, scene->name);
    line_text(&line, " ");
    line_text(&line, methods[m].name);
    line_text(&line, methods[m].table ? " 1" : " 0");
    for (unsigned i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        line_text(&line, " ");
        line_decimal(&line, figures[i]);
    }
    line_end(&line);
}

int main(void)
{
    const struct board *board = board_start();
    struct line line = {.length = 0};
    if (board->display->ops->open(board->display, board->width, board->height, (enum hal_pixel_format)board->format) !=
        0)
        return 3;
    for (unsigned s = 0; s < program_scene_count; s++)
        for (unsigned m = 0; m < sizeof methods / sizeof methods[0]; m++)
            if (board->format == HAL_RGB565 || !methods[m].table)
                cost_line(board, &program_scenes[s], m);
    line_text(&line, "stack ");
    line_decimal(&line, stack_used());
    line_end(&line);
    program_write("end\n");
    return 0;
}

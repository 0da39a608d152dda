/* SPDX-License-Identifier: MIT */
/*
 * What a picture costs on a board, by the board's own clock: for every scene and principal method, by one core and by
 * two where the board has them, a line `cost SCENE METHOD TABLE CORES DRAWN WHOLE ROW CHANGES BYTES BYTES_CHANGES`:
 * microseconds to draw a picture, to draw and send it whole, one of several in a row sent whole, to draw and send what
 * has changed 50 ms later, and the bytes on the wire of the second and the fourth; then `stack BYTES`, the most that
 * was taken, and `end`. `dropped` in place of `cost` where triangles find no room. Nothing waits for a tearing signal.
 */
#include "app/share.h"
#include "boards/board.h"
#include "clock.h"
#include "cortexm/machine.h"
#include "cortexm/stack.h"
#include "panels/panel.h"
#include "tests/device/program.h"

#define STEP_MS  50u /* between the picture that is sent whole and the next: 20 a second */
#define IN_A_ROW 8u

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

/* A picture, sent where there is a panel; the microseconds, or 0 if it cannot be. */
static uint32_t cost_picture(struct share *share, const void *scene, uint32_t time_ms, struct panel *panel)
{
    uint32_t begin = clock_us();
    share->display = panel ? &panel->display : 0;
    int error = share_begin(share, scene, time_ms);
    if (!error)
        error = share_draw(share);
    if (!error)
        error = share_finish(share);
    if (panel && !error)
        error = panel->bus->ops->wait(panel->bus);
    return error ? 0 : clock_us() - begin;
}

/* One of several, for whose last bands nothing waits. */
static uint32_t cost_row(struct share *share, const void *scene, struct panel *panel)
{
    uint32_t begin = clock_us();
    int error = 0;
    share->display = &panel->display;
    for (unsigned i = 0; i < IN_A_ROW && !error; i++) {
        panel_repaint(panel);
        error = share_begin(share, scene, 0);
        if (!error)
            error = share_draw(share);
    }
    if (!error)
        error = share_finish(share);
    return error ? 0 : (clock_us() - begin) / IN_A_ROW;
}

static int cost_init(struct share *share, const struct board *board, const struct program_scene *scene, unsigned m,
                     unsigned cores)
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
    if (glint_init(&share->frame, &config) != 0)
        return -1;
    for (unsigned i = 0; i < SHARE_MOST_BANDS; i++)
        share->band[i] = board->band[i];
    share->core = cores == 2 ? board->core : 0;
    share_ready(share, board->worker, board->worker_bytes);
    return 0;
}

static void cost_line(const struct board *board, const struct program_scene *scene, unsigned m, unsigned cores)
{
    static struct share share;
    struct panel *panel = (struct panel *)board->display;
    struct line line = {.length = 0};
    uint32_t figures[6];
    if (cost_init(&share, board, scene, m, cores) != 0)
        return;                              /* there is no memory for its table: the line without it stands for both */
    cost_picture(&share, scene->blob, 0, 0); /* makes the table */
    figures[0] = cost_picture(&share, scene->blob, 0, 0);
    panel_repaint(panel);
    figures[1] = cost_picture(&share, scene->blob, 0, panel);
    figures[4] = panel->sent;
    figures[3] = cost_picture(&share, scene->blob, STEP_MS, panel);
    figures[5] = panel->sent;
    figures[2] = cost_row(&share, scene->blob, panel);
    line_text(&line, share.frame.stats.dropped ? "dropped " : "cost ");
    line_text(&line, scene->name);
    line_text(&line, " ");
    line_text(&line, methods[m].name);
    line_text(&line, methods[m].table ? " 1" : " 0");
    line_text(&line, cores == 2 ? " 2" : " 1");
    for (unsigned i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        line_text(&line, " ");
        line_decimal(&line, figures[i]);
    }
    line_end(&line);
}

int main(void)
{
    const struct board *board = board_start();
    struct panel *panel = (struct panel *)board->display;
    struct hal_bus_ops ops = *panel->bus->ops;
    struct line line = {.length = 0};
    ops.tearing = 0;
    panel->bus->ops = &ops;
    if (panel->display.ops->open(&panel->display, board->width, board->height, (enum hal_pixel_format)board->format) !=
        0)
        return 3;
    panel_bars(panel, board->band[0]); /* the first picture turns the panel on, which takes its time */
    /* what two cores share is begun once and not taken back: those of one core first */
    for (unsigned cores = 1; cores <= (board->core ? 2u : 1u); cores++)
        for (unsigned s = 0; s < program_scene_count; s++)
            for (unsigned m = 0; m < sizeof methods / sizeof methods[0]; m++)
                if (board->format == HAL_RGB565 || !methods[m].table)
                    cost_line(board, &program_scenes[s], m, cores);
    line_text(&line, "stack ");
    line_decimal(&line, stack_used());
    line_end(&line);
    program_write("end\n");
    return 0;
}

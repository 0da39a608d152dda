/* SPDX-License-Identifier: MIT */
/*
 * Shows a scene's first picture whole and a later one by its changed rows, and says on the UART when each begins and
 * ends; then some in a row. The line "SCENE METHOD TABLES ROWS ROTATION MS [CORES]" on the UART says what; ROTATION is
 * added to the board's own, and without CORES one draws, and none in a row.
 */
#include "panels/panel.h"
#include "app/share.h"
#include "boards/board.h"
#include "clock.h"
#include "cortexm/machine.h"
#include "input.h"
#include "tests/device/program.h"

#define WAIT_US    50000u
#define LINE_BYTES 33u
#define IN_A_ROW   8u

int main(void);

void program_write(const char *text)
{
    machine_write(text);
}

struct panel_job {
    const struct program_scene *scene;
    const struct glint_method *method;
    uint32_t tables, rows, rotation, time_ms, cores;
};

/* A picture, sent where there is a display: while bands are on their way, others are drawn. */
static int panel_picture(struct share *share, const struct panel_job *job, uint32_t time_ms, struct panel *panel)
{
    share->display = panel ? &panel->display : 0;
    program_write(panel ? "show\n" : "draw\n");
    int error = share_begin(share, job->scene->blob, time_ms);
    if (error == 0)
        error = share_draw(share);
    if (error == 0)
        error = share_finish(share);
    if (panel && error == 0)
        error = panel->bus->ops->wait(panel->bus);
    program_write(panel ? "shown\n" : "drawn\n");
    return error;
}

/* Pictures one after the other, each sent whole: nothing waits for the display but for want of buffers. */
static int panel_in_a_row(struct share *share, const struct panel_job *job, struct panel *panel)
{
    int error = 0;
    for (unsigned i = 0; i <= IN_A_ROW && error == 0; i++) {
        panel_repaint(panel);
        error = share_begin(share, job->scene->blob, job->time_ms);
        error = error == 0 ? share_draw(share) : error;
        if (i == 0)
            program_write("row\n");
    }
    program_write("rowed\n");
    return error == 0 ? share_finish(share) : error;
}

/* What the board can without a look at the tearing signal: whole and by changes once more, then in a row. */
static int panel_freely(struct share *share, const struct panel_job *job, struct panel *panel)
{
    struct hal_bus *bus = panel->bus, free_bus;
    struct hal_bus_ops ops = *bus->ops;
    ops.tearing = 0;
    free_bus.ops = &ops;
    panel->bus = &free_bus;
    panel_repaint(panel);
    int error = panel_picture(share, job, 0, panel);
    error = error == 0 ? panel_picture(share, job, job->time_ms, panel) : error;
    error = error == 0 && job->cores ? panel_in_a_row(share, job, panel) : error;
    panel->bus = bus;
    return error;
}

static int panel_init(struct share *share, const struct panel_job *job, const struct board *board)
{
    struct glint_config config = {.width = board->width, .height = board->height, .format = board->format};
    if (job->rows > board->band_rows || glint_scene_check(job->scene->blob, *job->scene->length) != 0)
        return -1;
    glint_fit_stores(&config, job->scene->blob);
    config.band_rows = (uint16_t)job->rows;
    config.method = job->method;
    config.tables = (uint8_t)job->tables;
    config.band[0] = board->band[0];
    config.band[1] = board->band[1];
    config.memory = board->memory;
    config.memory_bytes = board->memory_bytes;
    for (unsigned i = 0; i < SHARE_MOST_BANDS; i++)
        share->band[i] = board->band[i];
    if (glint_init(&share->frame, &config) != 0)
        return -1;
    share->core = job->cores == 2 ? board->core : 0;
    share_ready(share, board->worker, board->worker_bytes);
    return share->core || job->cores != 2 ? 0 : -1;
}

static int panel_run(const struct panel_job *job, const struct board *board)
{
    struct hal_display *display = board->display;
    struct panel *panel = (struct panel *)display;
    static struct share share;
    panel->rotation = (uint16_t)((panel->rotation + job->rotation) % 360);
    if (panel_init(&share, job, board) != 0 ||
        display->ops->open(display, board->width, board->height, HAL_RGB565) != 0)
        return 2;
    /* The first makes the colour tables too. */
    if (panel_picture(&share, job, 0, 0) != 0 || panel_picture(&share, job, job->time_ms, 0) != 0 ||
        panel_picture(&share, job, 0, panel) != 0)
        return 3;
    program_write("first\n");
    if (panel_picture(&share, job, job->time_ms, panel) != 0 || panel_freely(&share, job, panel) != 0)
        return 3;
    return share.frame.stats.dropped ? 1 : 0;
}

/* The next word of the line, which it ends. */
static char *panel_word(char **at)
{
    char *word = *at;
    while (**at && **at != ' ')
        ++*at;
    if (**at)
        *(*at)++ = 0;
    return word;
}

int main(void)
{
    char line[LINE_BYTES], *at = line;
    const struct board *board = board_start();
    struct panel_job job = {0};
    struct line buttons = {.length = 0};
    clock_wait_us(WAIT_US); /* for the line to come */
    if (machine_command_line(line, sizeof line) != 0)
        return 2;
    line_text(&buttons, "buttons ");
    line_hex(&buttons, input_buttons());
    line_end(&buttons);
    const char *scene = panel_word(&at), *method = panel_word(&at);
    job.tables = text_number(panel_word(&at));
    job.rows = text_number(panel_word(&at));
    job.rotation = text_number(panel_word(&at));
    job.time_ms = text_number(panel_word(&at));
    job.cores = text_number(panel_word(&at));
    for (unsigned s = 0; s < program_scene_count; s++)
        if (text_equal(scene, program_scenes[s].name))
            job.scene = &program_scenes[s];
    for (unsigned m = 0; m < glint_choice_count; m++)
        if (text_equal(method, glint_choices[m].name))
            job.method = glint_choices[m].method;
    return job.scene && job.method ? panel_run(&job, board) : 2;
}

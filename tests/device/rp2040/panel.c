/* SPDX-License-Identifier: MIT */
/*
 * Shows a scene's first picture whole and a later one by its changed rows, and says on the UART when each begins and
 * ends. The line "SCENE METHOD TABLES ROWS ROTATION MS" on the UART says what; ROTATION is added to the board's own.
 */
#include "panels/panel.h"
#include "boards/board.h"
#include "clock.h"
#include "cortexm/machine.h"
#include "input.h"
#include "tests/device/program.h"

#define WAIT_US    50000u
#define LINE_BYTES 33u

int main(void);

void program_write(const char *text)
{
    machine_write(text);
}

struct panel_job {
    const struct program_scene *scene;
    const struct glint_method *method;
    uint32_t tables, rows, rotation, time_ms;
};

/* A frame, sent where there is a display: while a band is on its way, the next is drawn into the other buffer. */
static int panel_frame(struct glint_frame *frame, const struct panel_job *job, uint32_t time_ms,
                       struct hal_display *display)
{
    struct glint_band band;
    int error = display ? display->ops->frame_begin(display, 0, 0) : 0;
    program_write(display ? "show\n" : "draw\n");
    if (error == 0)
        error = glint_frame_begin(frame, job->scene->blob, time_ms);
    while (error == 0 && glint_frame_next_band(frame, &band))
        if (display)
            error = display->ops->flush(display, band.pixels, band.y, band.rows, band.stride);
    if (display && error == 0)
        error = ((struct panel *)display)->bus->ops->wait(((struct panel *)display)->bus);
    program_write(display ? "shown\n" : "drawn\n");
    if (display && error == 0)
        error = display->ops->frame_end(display);
    return error;
}

static int panel_init(struct glint_frame *frame, const struct panel_job *job, const struct board *board)
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
    return glint_init(frame, &config);
}

static int panel_run(const struct panel_job *job, const struct board *board)
{
    struct hal_display *display = board->display;
    struct panel *panel = (struct panel *)display;
    struct glint_frame frame;
    panel->rotation = (uint16_t)((panel->rotation + job->rotation) % 360);
    if (panel_init(&frame, job, board) != 0 ||
        display->ops->open(display, board->width, board->height, HAL_RGB565) != 0)
        return 2;
    /* The first makes the colour tables too. */
    if (panel_frame(&frame, job, 0, 0) != 0 || panel_frame(&frame, job, job->time_ms, 0) != 0 ||
        panel_frame(&frame, job, 0, display) != 0)
        return 3;
    program_write("first\n");
    if (panel_frame(&frame, job, job->time_ms, display) != 0)
        return 3;
    return frame.stats.dropped ? 1 : 0;
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
    for (unsigned s = 0; s < program_scene_count; s++)
        if (text_equal(scene, program_scenes[s].name))
            job.scene = &program_scenes[s];
    for (unsigned m = 0; m < glint_choice_count; m++)
        if (text_equal(method, glint_choices[m].name))
            job.method = glint_choices[m].method;
    return job.scene && job.method ? panel_run(&job, board) : 2;
}

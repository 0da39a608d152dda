/* SPDX-License-Identifier: MIT */
/* Buttons, time and reports. */
#include "app/app.h"
#include "app/crash.h"
#include "clock.h"
#include "cortexm/machine.h"
#include "cortexm/stack.h"
#include "input.h"
#include "serial.h"

/* A picture, and a look at the buttons: longer than a key bounces, and a little less than pictures of a display at 60
 * Hz are apart, whose tearing signal then sets the pace. */
#define MAIN_PERIOD_US 16000u
#define MAIN_RATE_US   500000u /* over which the pictures a second are counted */

struct main_state {
    struct app app;
    uint32_t last_us;   /* of the last look at the buttons */
    uint32_t window_us; /* since when pictures are counted */
    uint32_t pictures;  /* since then */
    uint32_t shown;     /* in all */
};

/* Pictures a second, while they follow one another. */
static void main_count(struct main_state *state, int drawn)
{
    uint32_t now = clock_us(), window = now - state->window_us;
    state->pictures += drawn != 0;
    if (drawn && window < MAIN_RATE_US)
        return;
    /* under 2^32: fewer than 400 pictures in the window */
    state->app.rate = drawn ? (state->pictures * 10000000u + window / 2) / window : 0;
    state->pictures = 0;
    state->window_us = now;
}

static void main_tell(struct app *app)
{
    struct text_line line = {.length = 0};
    report_picture(app, &line);
    if (stack_used()) {
        text_add(&line, ", stack ");
        text_add_number(&line, stack_used());
    }
    machine_write(line.text);
    machine_write("\n");
    if (app->board->log && app->remote.sending)
        app->board->log(&app->remote.stream, line.text);
}

static int main_open(const struct board *board)
{
    struct hal_display *display = board->display;
    int error = display->ops->open(display, board->width, board->height, (enum hal_pixel_format)board->format);
    if (error)
        machine_write("error display\n");
    return error;
}

#define MAIN_GONE 1 /* the display does not open */

/* A write-only bus shows no fault; one that does is told and the display begun anew. 0: the picture is on the display.
 */
static int main_show(struct app *app, int report)
{
    struct hal_display *display = app->board->display;
    int error = show_frame(app);
    if (!error && report)
        error = show_finish(app);
    if (!error)
        return 0;
    machine_write("error display\n");
    display->ops->close(display, 0);
    return main_open(app->board) == 0 ? error : MAIN_GONE;
}

static int main_send(void *context, const void *bytes, size_t size)
{
    (void)context;
    serial_write(bytes, (uint32_t)size);
    return 0;
}

/* What the other end of the line wants. One look a picture: who talks without end stops nothing. */
static unsigned main_hear(struct app *app)
{
    uint8_t bytes[6 * STREAM_HEADER];
    struct hal_link *link = app->board->link;
    return remote_hear(app, bytes,
                       link ? link->ops->read(link, bytes, sizeof bytes) : (int32_t)serial_read(bytes, sizeof bytes));
}

/* X where it is linked, else the first. */
static uint16_t main_first_method(void)
{
    for (unsigned i = 0; i < glint_choice_count; i++)
        if (glint_choices[i].name[0] == 'x' && glint_choices[i].name[1] == 0)
            return (uint16_t)i;
    return 0;
}

void app_usual(struct app_start *start)
{
    *start = (struct app_start){.control = {.scenes = (uint16_t)program_scene_count,
                                            .methods = (uint16_t)glint_choice_count,
                                            .method = main_first_method(),
                                            .budget = CONTROL_BUDGET,
                                            .running = 1,
                                            .figures = 1},
                                .period_us = MAIN_PERIOD_US};
}

/* Until it is to end: 0, or MAIN_GONE. */
static int main_loop(struct main_state *state, const struct app_start *start)
{
    struct app *app = &state->app;
    state->last_us = state->window_us = clock_us();
    for (unsigned effect = CONTROL_DRAW | CONTROL_REPORT; !start->pictures || state->shown < start->pictures;) {
        effect |= main_hear(app);
        uint32_t now = clock_us(), elapsed = now - state->last_us, buttons = input_buttons() | app->buttons;
        if (buttons & HAL_QUIT)
            return 0;
        if (start->step_us)
            elapsed = state->shown ? start->step_us : 0;
        buttons |= remote_buttons(&app->remote, now - state->last_us);
        effect |= control_step(&app->control, buttons, elapsed);
        state->last_us = now;
        app->buttons = 0;
        if (effect & CONTROL_READY) {
            show_ready(app);
            main_count(state, 0); /* others are another number */
        }
        if (effect & CONTROL_REPAINT)
            show_repaint(app);
        main_count(state, effect & CONTROL_DRAW);
        effect &= CONTROL_DRAW | CONTROL_REPORT;
        uint32_t skipped = app->remote.skipped;
        int error = effect ? main_show(app, effect & CONTROL_REPORT) : 0;
        if (error == MAIN_GONE)
            return error;
        if (effect && !error) {
            if (effect & CONTROL_REPORT)
                main_tell(app);
            /* who looks from afar shall see how it stands, too, when it moves no more */
            effect = app->remote.skipped != skipped ? CONTROL_DRAW : 0;
            state->shown++;
        }
        stack_check();
        while (clock_us() - now < start->period_us)
            clock_idle();
    }
    return 0;
}

int app_run(const struct board *board, const struct app_start *start)
{
    struct main_state state = {.app = {.board = board, .control = start->control}};
    struct stream *stream = &state.app.remote.stream;
    stream->write = board->link ? board->link->ops->write : main_send;
    stream->context = board->link;
    stream->last = board->last;
    if (main_open(board) != 0)
        return 3;
    crash_show(board);
    control_start(&state.app.control, input_buttons() & ~(uint32_t)HAL_QUIT);
    show_ready(&state.app);
    /* a display that is gone is not open */
    return main_loop(&state, start) == 0 && show_finish(&state.app) == 0 &&
                   board->display->ops->close(board->display, 1) == 0
               ? 0
               : 3;
}

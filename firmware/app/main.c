/* SPDX-License-Identifier: MIT */
/* Buttons, time and reports. */
#include "app/app.h"
#include "clock.h"
#include "cortexm/machine.h"
#include "input.h"

#define MAIN_PERIOD_US 16667u  /* a picture, and a look at the buttons: longer than a key bounces */
#define MAIN_RATE_US   500000u /* over which the pictures a second are counted */
#define MAIN_STEP_MS   100u

struct main_state {
    struct app app;
    uint32_t held;      /* buttons, last time */
    uint32_t last_us;   /* when the animation was last moved on */
    uint32_t part_us;   /* of a millisecond, not yet in its moment */
    uint32_t window_us; /* since when pictures are counted */
    uint32_t pictures;
    uint8_t chord; /* another button came while A was held: its release means nothing */
};

static void main_change_scene(struct app *app, int forward)
{
    unsigned index = (unsigned)(app->scene - app_scenes);
    index = (index + (forward ? 1 : app_scene_count - 1)) % app_scene_count;
    app->scene = app_scenes + index;
    show_ready(app);
}

static void main_change_method(struct app *app, int forward)
{
    unsigned index = (unsigned)(app->method - glint_choices);
    index = (index + (forward ? 1 : glint_choice_count - 1)) % glint_choice_count;
    app->method = glint_choices + index;
    show_ready(app);
}

static void main_step(struct app *app, int forward)
{
    if (forward)
        app->moment_ms += MAIN_STEP_MS;
    else
        app->moment_ms -= app->moment_ms < MAIN_STEP_MS ? app->moment_ms : MAIN_STEP_MS;
}

/* What the newly pressed and released buttons do: 1 if something. */
static int main_buttons(struct main_state *state)
{
    struct app *app = &state->app;
    uint32_t held = input_buttons(), pressed = held & ~state->held, released = state->held & ~held;
    uint32_t arrows = pressed & (HAL_UP | HAL_DOWN | HAL_LEFT | HAL_RIGHT);
    state->held = held;
    if (pressed & HAL_A)
        state->chord = 0;
    if ((held & HAL_A) && arrows) {
        state->chord = 1;
        if (arrows & HAL_UP)
            app->figures ^= 1;
        if (app->paused && arrows & (HAL_LEFT | HAL_RIGHT))
            main_step(app, arrows & HAL_RIGHT ? 1 : 0);
        return 1;
    }
    if (arrows & (HAL_LEFT | HAL_RIGHT))
        main_change_scene(app, arrows & HAL_RIGHT ? 1 : 0);
    if (arrows & (HAL_UP | HAL_DOWN))
        main_change_method(app, arrows & HAL_UP ? 1 : 0);
    if ((released & HAL_A) && !state->chord) {
        app->paused ^= 1;
        return 1;
    }
    return arrows != 0;
}

/* Moves the animation on. */
static void main_advance(struct main_state *state, uint32_t now)
{
    uint32_t elapsed = now - state->last_us;
    state->last_us = now;
    if (state->app.paused)
        return;
    state->part_us += elapsed;
    state->app.moment_ms += state->part_us / 1000;
    state->part_us %= 1000;
}

static void main_count(struct main_state *state)
{
    uint32_t now = clock_us(), window = now - state->window_us;
    state->pictures++;
    if (window < MAIN_RATE_US)
        return;
    /* under 2^32: fewer than 400 pictures in the window */
    state->app.rate = (state->pictures * 10000000u + window / 2) / window;
    state->pictures = 0;
    state->window_us = now;
}

static void main_report(const struct app *app)
{
    struct text_line line = {.length = 0};
    text_add(&line, app->problem ? "error " : "frame ");
    text_add(&line, app->scene->name);
    if (app->problem) {
        text_add(&line, ": ");
        text_add(&line, app->problem);
    } else {
        text_add(&line, " ");
        text_add(&line, app->method->name);
        text_add(&line, " ");
        text_add_number(&line, app->moment_ms);
        text_add(&line, " ms, ");
        text_add_number(&line, app->draw_us);
        text_add(&line, " us");
        if (!app->paused)
            text_add(&line, ", running");
        if (app->frame.stats.dropped) {
            text_add(&line, ", ");
            text_add_number(&line, app->frame.stats.dropped);
            text_add(&line, " dropped");
        }
    }
    machine_write(line.text);
    machine_write("\n");
}

/* A write-only bus shows no fault; one that does is told and the display begun anew. */
static void main_show(struct app *app)
{
    const struct board *board = app->board;
    struct hal_display *display = board->display;
    if (show_frame(app) == 0)
        return;
    machine_write("error display\n");
    display->ops->close(display, 0);
    display->ops->open(display, board->width, board->height, (enum hal_pixel_format)board->format);
}

static const struct glint_choice *main_first_method(void)
{
    const struct glint_choice *choice = glint_choices;
    while (choice->method != &glint_x)
        choice++;
    return choice;
}

int main(void)
{
    struct main_state state = {.app = {.board = board_start(), .scene = app_scenes, .figures = 1}};
    const struct board *board = state.app.board;
    struct hal_display *display = board->display;
    if (display->ops->open(display, board->width, board->height, (enum hal_pixel_format)board->format) != 0) {
        machine_write("error display\n");
        return 3;
    }
    state.app.method = main_first_method();
    show_ready(&state.app);
    /* what is held at the start is no press, and its release means nothing */
    state.held = input_buttons();
    state.chord = 1;
    state.last_us = state.window_us = clock_us();
    for (int changed = 1;; changed = main_buttons(&state)) {
        uint32_t now = clock_us();
        main_advance(&state, now);
        if (changed || !state.app.paused) {
            main_show(&state.app);
            main_count(&state);
        }
        if (changed)
            main_report(&state.app);
        while (clock_us() - now < MAIN_PERIOD_US)
            clock_idle();
    }
}

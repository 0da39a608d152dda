/* SPDX-License-Identifier: MIT */
/* The handheld's program at the other end of a line: whatever comes, its choices stay in range, and the picture that it
 * sends if it was asked to is whole. */
#include "app/app.h"
#include "clock.h"
#include "fuzz/fuzz.h"
#include "host/displays.h"
#include "input.h"
#include "view/frames.h"

enum { WIDTH = 16, HEIGHT = 12, BAND_ROWS = 5, PIECE = 48 };

static uint32_t memory[48 * 1024 / 4], bands[2][WIDTH * BAND_ROWS / 2 + 1], now_us;
static struct hal_display display = {&null_display};
static struct frames viewer;

uint32_t input_buttons(void)
{
    return 0;
}

uint32_t clock_us(void)
{
    now_us = (now_us + 100) & 0x3FFFFFFF;
    return now_us;
}

void clock_wait_us(uint32_t us)
{
    (void)us;
}

static int show(void *context, const void *bytes, size_t size)
{
    (void)context;
    frames_push(&viewer, bytes, size);
    return 0;
}

static void in_range(const struct app *app)
{
    const struct control *c = &app->control;
    FUZZ_CHECK(c->scene < c->scenes && c->method < c->methods && c->budget >= 1 && c->running <= 1);
    FUZZ_CHECK(app->remote.receiver.count < STREAM_HEADER && app->remote.asked <= 1);
}

/* Draws the moment; it goes out whole if that was asked for, and not at all otherwise. */
static void draw(struct app *app)
{
    const struct frames_events none = {0};
    bool asked = app->remote.asked;
    frames_open(&viewer, &none);
    FUZZ_CHECK(show_frame(app) == 0);
    FUZZ_CHECK(viewer.pictures == asked && viewer.lost == 0 && viewer.parser.count == 0 && !viewer.parser.damaged);
    FUZZ_CHECK(!asked || (viewer.picture.scene == app->control.scene && viewer.picture.method == app->control.method &&
                          viewer.picture.budget == app->control.budget));
    frames_close(&viewer);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const struct board board = {.name = "model",
                                .display = &display,
                                .width = WIDTH,
                                .height = HEIGHT,
                                .band_rows = BAND_ROWS,
                                .format = HAL_RGB565,
                                .pack = &pack_rgb565,
                                .band = {bands[0], bands[1]},
                                .memory = memory,
                                .memory_bytes = sizeof memory};
    struct app app = {.board = &board,
                      .control = {.scenes = (uint16_t)program_scene_count,
                                  .methods = (uint16_t)glint_choice_count,
                                  .budget = CONTROL_BUDGET},
                      .remote.stream = {.write = show}};
    unsigned ready = CONTROL_READY, drawn = 0;
    for (size_t at = 0; at < size; at += PIECE) {
        uint32_t count = (uint32_t)(size - at < PIECE ? size - at : PIECE);
        unsigned effect = remote_hear(&app, data + at, count);
        FUZZ_CHECK((effect & ~(unsigned)(CONTROL_DRAW | CONTROL_REPORT | CONTROL_READY)) == 0);
        in_range(&app);
        uint32_t held = remote_buttons(&app.remote, 250000), later = remote_buttons(&app.remote, REMOTE_HELD_US);
        FUZZ_CHECK(later == 0 || later == held);
        FUZZ_CHECK(remote_buttons(&app.remote, REMOTE_HELD_US) == 0);
        ready |= effect;
        if (effect & CONTROL_DRAW && drawn < 2) { /* drawing takes a thousand times as long as listening */
            if (ready & CONTROL_READY)
                show_ready(&app);
            ready = 0;
            draw(&app);
            drawn++;
        }
    }
    return 0;
}

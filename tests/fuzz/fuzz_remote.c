/* SPDX-License-Identifier: MIT */
/* The handheld's program at the other end of a line, or of a link: whatever comes, its choices stay in range, and every
 * picture that it sends is whole and shown. Without a link it sends what was asked for, and nothing else. */
#include "app/app.h"
#include "clock.h"
#include "fuzz/fuzz.h"
#include "host/displays.h"
#include "input.h"
#include "link.h"
#include "view/frames.h"

enum { WIDTH = 16, HEIGHT = 12, BAND_ROWS = 5, PIECE = 48, MOST_PICTURES = 3 };

static uint32_t memory[48 * 1024 / 4], bands[2][WIDTH * BAND_ROWS / 2 + 1], now_us;
static uint16_t last[WIDTH * HEIGHT];
static struct hal_display display = {&null_display};
static struct frames viewer;
static bool link_takes; /* the next picture */

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

static uint32_t link_begin(struct hal_link *link, uint32_t *skipped)
{
    (void)link;
    *skipped += !link_takes;
    return link_takes;
}

static const struct hal_link_ops link_ops = {.begin = link_begin, .write = show};
static struct hal_link link_end = {&link_ops};

static void in_range(const struct app *app)
{
    const struct control *c = &app->control;
    FUZZ_CHECK(c->scene < c->scenes && c->method < c->methods && c->budget >= 1 && c->running <= 1);
    FUZZ_CHECK(app->remote.receiver.count < STREAM_HEADER);
}

/* Draws the moment. */
static void draw(struct app *app)
{
    bool goes = app->board->link ? link_takes : app->remote.stream.key;
    uint16_t heard = app->remote.stream.heard;
    uint32_t pictures = viewer.pictures;
    const struct frames_picture *p = &viewer.picture;
    FUZZ_CHECK(show_frame(app) == 0);
    FUZZ_CHECK(viewer.pictures == pictures + goes && !viewer.lost && !viewer.parser.count && !viewer.parser.damaged);
    FUZZ_CHECK(!goes || (p->scene == app->control.scene && p->method == app->control.method &&
                         p->budget == app->control.budget && p->paused == !app->control.running && p->echo == heard));
    FUZZ_CHECK(!goes || !app->remote.stream.key);
}

/* Another viewer, with nothing of what the one before knew. */
static unsigned somebody_comes(struct app *app)
{
    frames_restart(&viewer);
    unsigned effect = remote_hear(app, NULL, HAL_LINK_COMES);
    FUZZ_CHECK(effect == CONTROL_DRAW && app->remote.stream.key && !app->remote.stream.heard);
    return effect;
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
                                .link = size & 1 ? &link_end : NULL,
                                .memory = memory,
                                .memory_bytes = size % 8 < 6 ? sizeof memory : 64 /* words instead of a scene */};
    struct app app = {.board = &board,
                      .control = {.scenes = (uint16_t)program_scene_count,
                                  .methods = (uint16_t)glint_choice_count,
                                  .budget = CONTROL_BUDGET},
                      .remote.stream = {.write = show, .last = size & 1 ? (uint8_t *)last : NULL}};
    const struct frames_events none = {0};
    unsigned ready = CONTROL_READY, drawn = 0;
    frames_open(&viewer, &none);
    for (size_t at = 0; at < size; at += PIECE) {
        uint32_t count = (uint32_t)(size - at < PIECE ? size - at : PIECE);
        unsigned effect = board.link && data[at] % 3 == 2 ? somebody_comes(&app) : 0;
        effect |= remote_hear(&app, data + at, (int32_t)count);
        FUZZ_CHECK((effect & ~(unsigned)(CONTROL_DRAW | CONTROL_REPORT | CONTROL_READY)) == 0);
        in_range(&app);
        uint32_t held = remote_buttons(&app.remote, 250000), later = remote_buttons(&app.remote, REMOTE_HELD_US);
        FUZZ_CHECK(later == 0 || later == held);
        FUZZ_CHECK(remote_buttons(&app.remote, REMOTE_HELD_US) == 0);
        ready |= effect;
        if (effect & CONTROL_DRAW && drawn < MOST_PICTURES) { /* drawing takes a thousand times as long as listening */
            if (ready & CONTROL_READY)
                show_ready(&app);
            ready = 0;
            link_takes = data[at] % 3 > 0;
            draw(&app);
            drawn++;
        }
    }
    frames_close(&viewer);
    return 0;
}

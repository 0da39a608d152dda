/* SPDX-License-Identifier: MIT */
#include "app/remote.h"
#include "app/app.h"
#include "clock.h"

static unsigned remote_choose(uint16_t *choice, uint32_t value, uint32_t count)
{
    if (value >= count)
        return 0;
    *choice = (uint16_t)value;
    return CONTROL_DRAW | CONTROL_REPORT | CONTROL_READY;
}

static unsigned remote_do(struct app *app, const struct stream_request *request)
{
    struct control *c = &app->control;
    uint32_t value = request->value;
    app->remote.stream.heard = request->sequence;
    switch (request->type) {
    case STREAM_KEY_PLEASE:
        app->remote.stream.key = 1;
        return CONTROL_DRAW;
    case STREAM_BUTTONS:
        app->buttons |= (uint8_t)value; /* they may be released before anybody looks */
        app->remote.buttons = value;
        app->remote.held_us = REMOTE_HELD_US;
        return 0;
    case STREAM_METHOD:
        return remote_choose(&c->method, value, c->methods);
    case STREAM_SCENE:
        return remote_choose(&c->scene, value, c->scenes);
    case STREAM_BUDGET:
        if (value < 1 || value > 255)
            return 0;
        c->budget = (uint8_t)value;
        return CONTROL_DRAW | CONTROL_REPORT | CONTROL_READY;
    case STREAM_PAUSE:
        c->running = value == 0;
        return CONTROL_DRAW | CONTROL_REPORT;
    default: /* of a later viewer */
        return 0;
    }
}

unsigned remote_hear(struct app *app, const uint8_t *bytes, int32_t count)
{
    struct stream_request request;
    unsigned effect = 0;
    if (count < 0) { /* HAL_LINK_COMES */
        app->remote.stream.heard = 0;
        app->remote.stream.key = 1;
        effect = CONTROL_DRAW;
    }
    for (int32_t i = 0; i < count; i++)
        if (stream_receive(&app->remote.receiver, bytes[i], &request))
            effect |= remote_do(app, &request);
    return effect;
}

uint32_t remote_buttons(struct remote *remote, uint32_t elapsed_us)
{
    if (remote->held_us <= elapsed_us) {
        remote->held_us = 0;
        remote->buttons = 0;
    } else {
        remote->held_us -= elapsed_us;
    }
    return remote->buttons;
}

void remote_begin(struct app *app)
{
    const struct board *board = app->board;
    const struct control *c = &app->control;
    struct stream *s = &app->remote.stream;
    const struct stream_names names = {board->name,
                                       {program_scenes, (uint16_t)program_scene_count, sizeof program_scenes[0]},
                                       {glint_choices, (uint16_t)glint_choice_count, sizeof glint_choices[0]}};
    const struct stream_frame frame = {c->moment_ms, (uint8_t)c->scene, (uint8_t)c->method, c->budget,
                                       (uint8_t)!c->running};
    struct hal_link *link = board->link;
    app->remote.sending = link ? link->ops->begin(link, &app->remote.skipped) : s->key;
    if (!app->remote.sending)
        return;
    s->pixels = board->pack;
    s->width = board->width;
    s->height = board->height;
    s->buffer_bytes = ((uint32_t)board->width * s->pixels->bits + 7) / 8 * board->band_rows;
    s->time_us = clock_us();
    app->remote.pack_us = 0;
    if (s->key)
        stream_hello(s, &names);
    stream_frame_begin(s, &frame);
}

void remote_band(struct app *app, const struct glint_band *band)
{
    void *const *bands = app->board->band;
    if (!app->remote.sending)
        return;
    uint32_t begin = clock_us();
    app->remote.stream.buffer = band->pixels == bands[0] ? bands[1] : bands[0];
    stream_band(&app->remote.stream, band->pixels, band->y, band->rows);
    app->remote.pack_us += clock_us() - begin;
}

void remote_end(struct app *app)
{
    const struct glint_stats *stats = &app->share.frame.stats;
    struct stream_statistics statistics = {.draw_us = app->share.draw_us,
                                           .pack_us = app->remote.pack_us,
                                           .triangles = stats->triangles,
                                           .dropped = stats->dropped,
                                           .skipped = app->remote.skipped};
    for (unsigned id = 0; id < GLINT_METHODS; id++)
        statistics.drawn += stats->drawn[id];
    if (app->remote.sending)
        stream_frame_end(&app->remote.stream, &statistics);
}

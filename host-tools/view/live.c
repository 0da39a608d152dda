/* SPDX-License-Identifier: MIT */
#include "view/session.h"

#include "glint/cli.h"
#include "view/unpack.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LIVE_HIDDEN_MS  300.  /* that a window without a picture stays hidden: its size is not known */
#define LIVE_BUTTONS_MS 500.  /* between messages of the same buttons: a device lets go of them after a second */
#define LIVE_HINT_MS    5000. /* that the figures name the key that lists the keys */
#define LIVE_WIDTH      240   /* of a window without a picture */

static uint64_t live_us(void)
{
    return (uint64_t)(cli_clock() * 1e3);
}

int live_open(struct session *s)
{
    struct live *l = &s->live;
    const struct options *o = s->options;
    l->controls = l->done = (struct controls){.figures = true};
    l->controls.rotation = o->rotate / 90;
    l->controls.fullscreen = o->fullscreen;
    l->scale = o->scale;
    l->opened = cli_clock();
    l->hint = l->opened + LIVE_HINT_MS;
    l->words = true;
    return window_open(&l->window);
}

void live_close(struct live *l)
{
    window_close(l->window);
    free(l->shown.pixels);
    free(l->next.pixels);
}

void live_picture(struct session *s, const struct frames_picture *p)
{
    struct live *l = &s->live;
    struct live_picture *next = &l->next;
    size_t bytes = unpack_row_bytes(p->format, p->width) * p->height;
    meter_picture(&l->meter, p, cli_clock());
    if (bytes > next->room) {
        free(next->pixels);
        next->pixels = malloc(bytes);
        next->room = next->pixels ? bytes : 0;
        s->frames.parser.out_of_memory |= !next->pixels;
    }
    if (!next->pixels)
        return;
    memcpy(next->pixels, p->pixels, bytes);
    next->picture = *p;
    next->picture.pixels = next->pixels;
    next->connections = s->connections;
    l->waits = true;
}

void live_log(struct live *l, const char *text, size_t length)
{
    status_note(&l->notes, text, length, cli_clock());
    l->words = true;
}

bool live_holds(const struct session *s)
{
    return s->live.window && s->live.waits && !s->port.asks;
}

static void live_size(struct live *l)
{
    const struct frames_picture *p = &l->shown.picture;
    const unsigned turn = l->controls.rotation & 1;
    if (p->pixels)
        window_size(l->window, turn ? p->height : p->width, turn ? p->width : p->height, l->scale);
    else
        window_size(l->window, LIVE_WIDTH, LIVE_WIDTH, 0);
}

/* A picture that is due goes to the window. True if one did. */
static bool live_show(struct session *s)
{
    struct live *l = &s->live;
    const struct frames_picture *p = &l->next.picture;
    if (!l->waits)
        return false;
    if (s->port.asks ? l->controls.paused && !l->controls.steps
                     : playback_wait(&l->playback, p->time_us, live_us()) != 0)
        return false;
    if (s->port.asks)
        l->controls.steps -= l->controls.steps != 0;
    else
        playback_shown(&l->playback, p->time_us, live_us());
    const struct live_picture before = l->shown;
    l->shown = l->next;
    l->next = before;
    l->waits = false;
    if (!before.pixels || before.picture.width != l->shown.picture.width ||
        before.picture.height != l->shown.picture.height)
        live_size(l);
    s->code = s->code ? s->code : window_picture(l->window, &l->shown.picture, l->controls.rotation);
    return true;
}

static void live_buttons(struct session *s)
{
    struct live *l = &s->live;
    struct controls *c = &l->controls;
    double now = cli_clock();
    const bool tapped = c->taps & ~c->buttons;
    if (s->port.there && tapped)
        session_send(s, STREAM_BUTTONS, c->buttons | c->taps);
    c->taps = 0;
    if (!s->port.there || (!tapped && c->buttons == l->done.buttons && now - l->told < LIVE_BUTTONS_MS))
        return;
    session_send(s, STREAM_BUTTONS, c->buttons);
    l->told = now;
}

/* The place after `steps` others in a list that is a ring. */
static uint32_t live_place(const struct names *names, enum names_list list, uint32_t place, int steps)
{
    int64_t count = names_count(names, list);
    return count ? (uint32_t)((((int64_t)place + steps) % count + count) % count) : OPTIONS_NONE;
}

/* What the device is asked for, from what its last picture shows, or what was asked for and is not shown so far. */
static void live_ask(struct session *s)
{
    struct live *l = &s->live;
    struct controls *c = &l->controls;
    const struct frames_picture *p = l->waits ? &l->next.picture : &l->shown.picture;
    const uint32_t *wishes = s->wishes;
    const uint32_t scene = wishes[SESSION_SCENE] == OPTIONS_NONE ? p->scene : wishes[SESSION_SCENE];
    const uint32_t method = wishes[SESSION_METHOD] == OPTIONS_NONE ? p->method : wishes[SESSION_METHOD];
    const uint32_t budget = wishes[SESSION_BUDGET] == OPTIONS_NONE ? p->budget : wishes[SESSION_BUDGET];
    const uint32_t paused = wishes[SESSION_PAUSE] == OPTIONS_NONE ? p->paused : wishes[SESSION_PAUSE];
    if (s->port.asks && p->pixels) {
        if (c->scene)
            session_wish(s, SESSION_SCENE, live_place(&s->names, NAMES_SCENES, scene, c->scene));
        if (c->method)
            session_wish(s, SESSION_METHOD, live_place(&s->names, NAMES_METHODS, method, c->method));
        int64_t wanted = (int64_t)budget + c->budget;
        if (c->budget)
            session_wish(s, SESSION_BUDGET, wanted < 1 ? 1 : wanted > 255 ? 255 : (uint32_t)wanted);
        if (c->motion)
            session_wish(s, SESSION_PAUSE, !paused);
    }
    c->scene = c->method = c->budget = 0;
    c->motion = false;
}

static void live_note(struct live *l, const char *what, const char *name)
{
    char line[OVERLAY_COLUMNS + 1]; /* a longer name is cut off */
    snprintf(line, sizeof line, "%s %s", what, name);
    live_log(l, line, strlen(line));
}

bool live_film_ended(struct live *l)
{
    bool by_key = l->film[0] != 0;
    if (by_key)
        live_note(l, "ended", l->film);
    l->film[0] = 0;
    return by_key;
}

/* Begins a recording, or ends what --record or the key began. */
static void live_film(struct session *s)
{
    struct live *l = &s->live;
    if (s->record.path) {
        const char *name = s->record.path, *done = s->record.pictures ? "saved" : "no picture for";
        live_note(l, record_close(&s->record, true) ? "cannot write" : done, name);
        l->film[0] = 0;
    } else {
        dump_name(l->film, "recording");
        if (record_open(&s->record, l->film) == CLI_DONE)
            live_note(l, "recording", l->film);
        else
            l->film[0] = 0;
    }
}

/* What is to be written: it is told, and a failure ends nothing. */
static void live_write(struct session *s)
{
    struct live *l = &s->live;
    struct controls *c = &l->controls;
    char name[DUMP_NAME];
    if (c->picture && l->shown.picture.pixels) {
        dump_name(name, "picture");
        live_note(l, dump_file(name, &l->shown.picture) ? "cannot write" : "saved", name);
    }
    if (c->window) {
        dump_name(name, "window");
        live_note(l, window_save(l->window, name) ? "cannot write" : "saved", name);
    }
    if (c->film)
        live_film(s);
    c->picture = c->window = c->film = false;
}

/* The keys that change the window itself. */
static void live_change(struct session *s)
{
    struct live *l = &s->live;
    struct controls *c = &l->controls;
    if (c->scale)
        c->fullscreen = false;
    if (c->fullscreen != l->done.fullscreen)
        window_fullscreen(l->window, c->fullscreen);
    if (c->rotation != l->done.rotation && l->shown.picture.pixels)
        s->code = s->code ? s->code : window_picture(l->window, &l->shown.picture, c->rotation);
    bool turned = (c->rotation ^ l->done.rotation) & 1, left = l->done.fullscreen && !c->fullscreen;
    if (c->scale || ((turned || left) && !c->fullscreen && l->shown.picture.pixels)) {
        l->scale = c->scale ? c->scale : l->scale;
        live_size(l);
    }
    c->scale = 0;
    if (c->paused != l->done.paused)
        playback_pause(&l->playback, c->paused, live_us());
    if (!s->port.asks && c->steps && l->waits && !l->playback.step) {
        playback_step(&l->playback);
        c->steps--;
    }
    if (c->rotation != l->done.rotation || c->paused != l->done.paused || c->figures != l->done.figures ||
        c->details != l->done.details || c->help != l->done.help)
        l->words = true;
}

static void live_words(struct session *s)
{
    struct live *l = &s->live;
    const struct status status = {.port = s->port.name,
                                  .names = &s->names,
                                  .picture = l->shown.picture.pixels ? &l->shown.picture : NULL,
                                  .meter = &l->meter,
                                  .lost = s->frames.lost,
                                  .details = l->controls.details};
    struct overlay_text text[OVERLAY_PLACES] = {{.count = 0}};
    char title[128];
    status_title(&status, title, sizeof title);
    window_title(l->window, title);
    if (l->controls.figures && !l->controls.help)
        status_figures(&status, &text[OVERLAY_TOP]);
    if (l->controls.help)
        status_keys(&text[OVERLAY_MIDDLE]);
    else if (!s->port.there)
        overlay_add(&text[OVERLAY_MIDDLE], "waiting for %s%s%s", s->port.name, s->port.why ? ": " : "",
                    s->port.why ? s->port.why : "");
    else if (!l->shown.picture.pixels || l->shown.connections != s->port.connections)
        overlay_add(&text[OVERLAY_MIDDLE], "no picture so far");
    else if (s->ended && s->port.asks)
        overlay_add(&text[OVERLAY_MIDDLE], "%s has gone", s->port.name);
    if (l->controls.figures && !l->controls.help && (!l->shown.picture.pixels || cli_clock() < l->hint))
        overlay_add(&text[OVERLAY_BOTTOM], "h lists the keys");
    status_list(&l->notes, &text[OVERLAY_BOTTOM]);
    if (l->controls.paused && l->controls.figures)
        overlay_add(&text[OVERLAY_BOTTOM], "held: space lets it go on");
    else if (s->ended && !l->waits && !s->port.asks && l->controls.figures)
        overlay_add(&text[OVERLAY_BOTTOM], "the end");
    window_words(l->window, text);
    l->words = false;
}

bool live_step(struct session *s)
{
    struct live *l = &s->live;
    /* who reads has waited for bytes */
    bool draw = window_keys(l->window, &l->controls, s->ended || live_holds(s) ? LIVE_WAIT_MS : 0);
    live_buttons(s);
    live_ask(s);
    live_change(s);
    live_write(s);
    bool there = s->port.there && !(s->ended && s->port.asks);
    l->words |= l->there != there || l->why != s->port.why;
    l->there = there;
    l->why = s->port.why;
    /* pictures that come one by one are told one by one */
    bool single =
        s->ended || l->controls.paused || l->shown.connections != s->port.connections || !l->shown.picture.pixels;
    bool shown = live_show(s);
    if (cli_clock() - l->opened > LIVE_HIDDEN_MS && !l->shown.picture.pixels && l->opened > 0.) {
        live_size(l);
        l->opened = 0.;
    }
    bool current = l->shown.connections == s->port.connections;
    window_dim(l->window, !there || !current);
    bool figures = meter_turn(&l->meter, cli_clock()), forgotten = status_forget(&l->notes, cli_clock());
    l->words = l->words || figures || forgotten || (single && shown);
    draw = draw || shown || l->words;
    if (l->words)
        live_words(s);
    if (draw)
        window_draw(l->window);
    if (shown)
        meter_shown(&l->meter, &l->shown.picture, cli_clock());
    l->done = l->controls;
    return !l->controls.quit;
}

/* SPDX-License-Identifier: MIT */
/*
 * A session of glint-view with a window and a device, both the test's, on a clock that only waiting moves. The device
 * sends what the test draws and writes down what it is asked for; the window writes down what it is shown. Include
 * after cmocka.h.
 */
#ifndef VIEW_CASE_H
#define VIEW_CASE_H

#include "glint/cli.h"
#include "stream_case.h"

static double case_clock(void);
#define cli_clock case_clock
#include "view/live.c"
#include "view/session.c"
#undef cli_clock

#define CASE_SIDE  4u
#define CASE_ASKED 256

struct view_case {
    double now;
    unsigned turn;                /* how often the keys were looked at */
    void (*turns)(unsigned turn); /* what happens then */
    struct controls *controls;
    struct session session;
    struct stream_case_bytes wire; /* sent, and of that read */
    size_t read;
    struct stream stream;
    struct {
        enum stream_type type;
        uint32_t value;
    } asked[CASE_ASKED];
    unsigned asked_count;
    uint16_t sequence; /* of the last */
    unsigned shown;    /* pictures; the last one's pixels are all of this */
    uint8_t pixel;
    bool dim;
    struct overlay_text text[OVERLAY_PLACES];
};
static struct view_case it;

static double case_clock(void)
{
    return it.now += .001;
}

int port_open(struct port *port, const char *input, const char *serial)
{
    (void)serial;
    *port = (struct port){.name = input, .asks = true, .there = true, .connections = 1};
    return CLI_DONE;
}

long port_read(struct port *port, void *bytes, size_t size, int wait_ms)
{
    size_t count = it.wire.count - it.read < size ? it.wire.count - it.read : size;
    (void)port;
    if (count == 0) {
        it.now += wait_ms;
        return 0;
    }
    memcpy(bytes, it.wire.bytes + it.read, count);
    it.read += count;
    return (long)count;
}

int port_ask(struct port *port, enum stream_type type, uint32_t value)
{
    it.sequence = ++port->sequence;
    if (it.asked_count < CASE_ASKED) {
        it.asked[it.asked_count].type = type;
        it.asked[it.asked_count++].value = value;
    }
    return CLI_DONE;
}

void port_missing(struct port *port)
{
    (void)port;
}

void port_close(struct port *port)
{
    (void)port;
}

int window_open(struct window **window)
{
    *window = (struct window *)&it;
    return CLI_DONE;
}

void window_close(struct window *window)
{
    (void)window;
}

bool window_keys(struct window *window, struct controls *controls, int wait_ms)
{
    (void)window;
    it.now += wait_ms;
    it.controls = controls;
    it.turns(it.turn++);
    return false;
}

void window_size(struct window *window, uint32_t width, uint32_t height, unsigned scale)
{
    (void)window, (void)width, (void)height, (void)scale;
}

void window_fullscreen(struct window *window, bool fullscreen)
{
    (void)window, (void)fullscreen;
}

void window_title(struct window *window, const char *title)
{
    (void)window, (void)title;
}

int window_picture(struct window *window, const struct frames_picture *picture, unsigned rotation)
{
    (void)window, (void)rotation;
    it.shown++;
    it.pixel = picture->pixels[0];
    return CLI_DONE;
}

void window_dim(struct window *window, bool dim)
{
    (void)window;
    it.dim = dim;
}

void window_words(struct window *window, const struct overlay_text text[OVERLAY_PLACES])
{
    (void)window;
    memcpy(it.text, text, sizeof it.text);
}

void window_draw(struct window *window)
{
    (void)window;
}

int window_save(struct window *window, const char *path)
{
    (void)window, (void)path;
    return CLI_DONE;
}

static inline void case_press(int key)
{
    controls_press(it.controls, key, false, false);
}

static inline void case_release(int key)
{
    controls_release(it.controls, key);
}

static inline void case_key(int key)
{
    case_press(key);
    case_release(key);
}

/* The device draws a picture that is all of one value. */
static inline void case_draw(uint8_t pixel, unsigned method, bool paused, bool key)
{
    static const char *const scenes[] = {"one", "two"}, *const methods[] = {"first", "second", "third"};
    static const struct stream_names names = {"board", {scenes, 2, sizeof *scenes}, {methods, 3, sizeof *methods}};
    const struct stream_frame frame = {
        .moment_ms = 40, .method = (uint8_t)method, .budget = 4, .paused = (uint8_t)paused};
    static const struct stream_statistics statistics = {.draw_us = 5};
    uint8_t pixels[CASE_SIDE * CASE_SIDE];
    memset(pixels, pixel, sizeof pixels);
    it.stream.time_us += 20000;
    it.stream.key = it.stream.key || key;
    if (it.stream.key)
        assert_int_equal(stream_hello(&it.stream, &names), 0);
    assert_int_equal(stream_frame_begin(&it.stream, &frame), 0);
    assert_int_equal(stream_band(&it.stream, pixels, 0, CASE_SIDE), 0);
    assert_int_equal(stream_frame_end(&it.stream, &statistics), 0);
}

/* How often the device was asked for this, from the n-th request on. */
static inline unsigned case_asked(unsigned from, enum stream_type type, uint32_t value)
{
    unsigned count = 0;
    for (unsigned i = from; i < it.asked_count; i++)
        count += it.asked[i].type == type && it.asked[i].value == value;
    return count;
}

/* Runs until a turn quits. */
static inline int case_run(const struct options *options, void (*turns)(unsigned turn))
{
    it = (struct view_case){.turns = turns, .now = 1e6};
    it.stream = stream_case_open(&it.wire, STREAM_GREY8, CASE_SIDE, CASE_SIDE, CASE_SIDE, true);
    int code = session_run(&it.session, options);
    stream_case_close(&it.stream, &it.wire);
    return code;
}

#endif

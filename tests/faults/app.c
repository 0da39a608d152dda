/* SPDX-License-Identifier: MIT */
/* The handheld's program between a display and the other end of a link or a line, of which one call or two fail. */
#include "view/frames.h"
#include "view/port.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "app_machine.h"

#include "tests/faults/pairs.h"

enum { WIDTH = 32, HEIGHT = 24, BAND_ROWS = 10, MEMORY = 64 * 1024, PICTURES = 4, MOST_CALLS = 1000 };
enum { PICTURE = 2 * WIDTH * HEIGHT };

static uint32_t memory[MEMORY / 4], bands[2][WIDTH * BAND_ROWS / 2], last[PICTURE / 4];
const struct program_scene program_scenes[] = {{"tiny", blob, &blob_length}};
const unsigned program_scene_count = 1;

static struct seam seam;
static unsigned told; /* errors of the display */

void machine_write(const char *text)
{
    told += strcmp(text, "error display\n") == 0;
}

/* --- a display that holds the program to display.h -------------------------------------------------------------------
 */

enum glass_state { CLOSED, OPEN, DRAWING, BROKEN };

static struct {
    struct hal_display display;
    enum glass_state state;
    unsigned rows, pictures, faults;
    uint8_t pixels[PICTURE], good[PICTURE];
} glass;

/* Whether the call fails: then only close may follow. */
static int glass_fails(void)
{
    assert_in_range(seam.calls, 0, MOST_CALLS);
    if (!seam_fails(&seam))
        return 0;
    glass.faults++;
    glass.state = glass.state == CLOSED ? CLOSED : BROKEN;
    return 1;
}

static int glass_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    (void)display, (void)format;
    assert_int_equal(glass.state, CLOSED);
    assert_true(width == WIDTH && height == HEIGHT);
    if (glass_fails())
        return HAL_E_IO;
    glass.state = OPEN;
    return 0;
}

static int glass_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    (void)display, (void)index, (void)delay_ms;
    assert_int_equal(glass.state, OPEN);
    if (glass_fails())
        return HAL_E_IO;
    glass.state = DRAWING;
    glass.rows = 0;
    return 0;
}

static int glass_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    (void)display;
    assert_int_equal(glass.state, DRAWING);
    assert_int_equal(y, glass.rows);
    memcpy(glass.pixels + y * stride, pixels, rows * stride);
    glass.rows += rows;
    return glass_fails() ? HAL_E_IO : 0;
}

static int glass_end(struct hal_display *display)
{
    (void)display;
    assert_int_equal(glass.state, DRAWING);
    assert_int_equal(glass.rows, HEIGHT);
    if (glass_fails())
        return HAL_E_IO;
    glass.state = OPEN;
    if (glass.pictures++ == 0 && !seam.fails_at)
        memcpy(glass.good, glass.pixels, PICTURE);
    assert_memory_equal(glass.pixels, glass.good, PICTURE);
    return 0;
}

static int glass_close(struct hal_display *display, int keep)
{
    (void)display;
    assert_true(glass.state != CLOSED && keep == (glass.state == OPEN));
    int failed = seam_fails(&seam);
    glass.state = CLOSED;
    return failed ? HAL_E_IO : 0;
}

static const struct hal_display_ops glass_ops = {glass_open, glass_begin, glass_flush, glass_end, glass_close};

/* --- the other end: a viewer that comes, and goes when a write fails -------------------------------------------------
 */

static struct {
    struct hal_link link;
    struct frames frames;
    int there, comes;
    unsigned pictures, faults;
} viewer;

static void viewer_shown(void *context, const struct frames_picture *p)
{
    (void)context;
    viewer.pictures++;
    assert_memory_equal(p->pixels, glass.good, PICTURE);
}

static void viewer_said(void *context, const char *text, uint32_t length)
{
    (void)context, (void)text, (void)length;
}

/* For a key frame, at each look: the scene itself stands still. */
static int32_t ask(uint8_t *bytes, uint32_t size)
{
    assert_in_range(seam.calls, 0, MOST_CALLS);
    assert_true(size >= STREAM_HEADER);
    port_message(bytes, STREAM_KEY_PLEASE, 0, 0);
    return STREAM_HEADER;
}

static int32_t viewer_read(struct hal_link *link, void *bytes, uint32_t size)
{
    (void)link;
    if (seam_fails(&seam))
        return 0;
    if (!viewer.comes)
        return ask(bytes, size);
    frames_restart(&viewer.frames);
    viewer.comes = 0;
    viewer.there = 1;
    return HAL_LINK_COMES;
}

static uint32_t viewer_begin(struct hal_link *link, uint32_t *skipped)
{
    (void)link;
    const int full = viewer.there && seam_fails(&seam);
    *skipped += (uint32_t)full;
    return viewer.there && !full;
}

static int viewer_write(void *link, const void *bytes, size_t size)
{
    (void)link;
    if (!viewer.there || seam_fails(&seam)) {
        viewer.comes = 1; /* another one, later */
        viewer.there = 0;
        return HAL_E_IO;
    }
    frames_push(&viewer.frames, bytes, size);
    return 0;
}

/* Over the line what it sends can be lost. */
uint32_t serial_read(void *bytes, uint32_t size)
{
    return seam_fails(&seam) ? 0 : (uint32_t)ask(bytes, size);
}

void serial_write(const void *bytes, uint32_t count)
{
    frames_push(&viewer.frames, bytes, count);
}

/* --- the runs --------------------------------------------------------------------------------------------------------
 */

static int run(int linked, const struct seam *next)
{
    static const struct hal_link_ops ops = {viewer_read, viewer_begin, viewer_write};
    static const struct frames_events events = {viewer_shown, viewer_said, viewer_said, NULL};
    const struct board board = {.name = "model",
                                .display = &glass.display,
                                .width = WIDTH,
                                .height = HEIGHT,
                                .band_rows = BAND_ROWS,
                                .format = HAL_RGB565,
                                .pack = &pack_rgb565,
                                .band = {bands[0], bands[1]},
                                .memory = memory,
                                .memory_bytes = sizeof memory,
                                .link = linked ? &viewer.link : NULL,
                                .last = linked ? (uint8_t *)last : NULL,
                                .log = stream_log};
    struct app_start start;
    app_usual(&start);
    start.pictures = PICTURES;
    start.control.running = start.control.figures = 0;
    seam = *next;
    told = 0;
    glass.display.ops = &glass_ops;
    glass.state = CLOSED;
    glass.pictures = glass.faults = viewer.pictures = 0;
    viewer.link.ops = &ops;
    viewer.comes = 1;
    viewer.there = 0;
    frames_open(&viewer.frames, &events);
    int code = app_run(&board, &start);
    frames_close(&viewer.frames);
    return code;
}

/* The program ends as it was to, or with 3 because the display does not open anew or does not close; each fault of the
 * display is told; every picture that was shown, on the glass or far away, is whole. */
static void assert_well(int code)
{
    const int ended = glass.state == CLOSED;
    assert_true(ended);
    assert_true(code == 0 || code == 3);
    assert_int_equal(told, glass.faults);
    if (code == 0)
        assert_in_range(glass.pictures, PICTURES, PICTURES + 2);
    else
        assert_true(seam.fails_at);
}

static int load(void **state)
{
    (void)state;
    return app_machine_load("tests/scenes/tiny.json");
}

static void calls_that_fail_are_told_and_the_next_picture_is_whole(void **state)
{
    (void)state;
    unsigned runs = 0, recovered = 0;
    for (int linked = 0; linked < 2; linked++) {
        assert_int_equal(run(linked, &(struct seam){0}), 0);
        assert_int_equal(viewer.pictures, glass.pictures);
        const int calls = seam.calls;
        for (int k = 1; k <= calls; k++) {
            assert_well(run(linked, &(struct seam){.fails_at = k, .reason = EIO}));
            runs++;
        }
        struct pairs pairs = pairs_of(calls, pairs_most(3000));
        for (struct seam next; pairs_next(&pairs, &next);) {
            int code = run(linked, &next);
            assert_well(code);
            recovered += code == 0 && glass.faults > 0;
        }
        runs += pairs.tried;
    }
    assert_true(recovered > 0);
    print_message("%u runs, of which %u went on after the display's fault\n", runs, recovered);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(calls_that_fail_are_told_and_the_next_picture_is_whole)};
    return cmocka_run_group_tests(tests, load, NULL);
}

/* SPDX-License-Identifier: MIT */
/* A machine and a display that is no panel, for the handheld's program, whose sources are included. After cmocka.h. */
#ifndef APP_PLAIN_CASE_H
#define APP_PLAIN_CASE_H

#include "app/crash.c"
#include "app/main.c"
#include "app/show.c"

enum { WIDTH = 64, HEIGHT = 48, BAND_ROWS = 10, WIDE = 2048, MEMORY = 150 * 1024, FLUSHES = 5, LONG_NAME = 170 };

static uint32_t blobs[2][24 * 1024 / 4], lengths[2], memory[MEMORY / 4], bands[2][WIDE * BAND_ROWS / 2];
static char long_name[LONG_NAME + 1];
const struct program_scene program_scenes[] = {{"demo", blobs[0], &lengths[0]}, {long_name, blobs[1], &lengths[1]}};
const unsigned program_scene_count = 2;

/* `x` is the last of them, or none is. */
static char last_name[3];
const struct glint_choice glint_choices[] = {{"gouraud", &glint_gouraud}, {"flat", &glint_flat}, {last_name, &glint_x}};
const unsigned glint_choice_count = 3;

/* The machine: buttons that change at moments, a fault, a stack and a serial line. */
static struct {
    uint32_t now_us, tick_us;
    struct {
        uint32_t from_us, buttons;
    } keys[8]; /* the last that has come holds */
    uint32_t looks;
    struct fault fault;
    int faulted;
    uint32_t stack;
    char told[4096];
    uint8_t says[64];
    uint32_t says_count;
    struct frames frames;
} machine;

uint32_t input_buttons(void)
{
    uint32_t buttons = 0;
    machine.looks++;
    for (int i = 0; i < 8 && machine.keys[i].from_us <= machine.now_us; i++)
        buttons = machine.keys[i].buttons;
    return buttons;
}
uint32_t clock_us(void)
{
    return machine.now_us += machine.tick_us;
}
void clock_wait_us(uint32_t us)
{
    machine.now_us += us;
}
void clock_idle(void)
{
    machine.now_us += 1000;
}
void machine_write(const char *text)
{
    strncat(machine.told, text, sizeof machine.told - strlen(machine.told) - 1);
}
void serial_write(const void *bytes, uint32_t count)
{
    frames_push(&machine.frames, bytes, count);
}
uint32_t serial_read(void *bytes, uint32_t size)
{
    uint32_t count = machine.says_count < size ? machine.says_count : size;
    memcpy(bytes, machine.says, count);
    machine.says_count = 0;
    return count;
}
int fault_last(struct fault *fault)
{
    int faulted = machine.faulted;
    *fault = machine.fault;
    machine.faulted = 0;
    return faulted;
}
void fault_text(const struct fault *fault, char text[FAULT_TEXT])
{
    (void)fault;
    strcpy(text, "fault 3, at 00001234, from 00005678");
}
uint32_t stack_used(void)
{
    return machine.stack;
}
void stack_check(void) {}

/* The display keeps what it is given, and the first picture of all apart. */
static struct {
    uint16_t shown[WIDE * HEIGHT], first[WIDE * HEIGHT];
    uint32_t begun, flushed, ended, closed, kept;
    uint32_t fails_at; /* the flush, from 1 on; 0: none */
    uint32_t first_us; /* when the second picture was begun */
} glass;

static int glass_open(struct hal_display *display, uint16_t width, uint16_t height, enum hal_pixel_format format)
{
    (void)display, (void)width, (void)height, (void)format;
    return 0;
}
static int glass_begin(struct hal_display *display, uint32_t index, uint32_t delay_ms)
{
    (void)display, (void)index, (void)delay_ms;
    if (glass.begun++ == 1)
        glass.first_us = machine.now_us;
    return 0;
}
static int glass_flush(struct hal_display *display, const void *pixels, uint16_t y, uint16_t rows, uint32_t stride)
{
    (void)display;
    memcpy(glass.shown + y * (stride / 2), pixels, rows * stride);
    if (++glass.flushed == FLUSHES)
        memcpy(glass.first, glass.shown, sizeof glass.first);
    return glass.flushed == glass.fails_at ? HAL_E_IO : 0;
}
static int glass_end(struct hal_display *display)
{
    (void)display;
    glass.ended++;
    return 0;
}
static int glass_close(struct hal_display *display, int keep)
{
    (void)display;
    glass.closed++;
    glass.kept += keep != 0;
    return 0;
}
static const struct hal_display_ops glass_ops = {glass_open, glass_begin, glass_flush, glass_end, glass_close};
/* One that is told of bands alone. */
static const struct hal_display_ops glass_plain_ops = {glass_open, 0, glass_flush, 0, glass_close};
static struct hal_display display;
static struct board board;
static struct app app;

/* All anew; the app as at its start, but stopped and without figures. */
static int begin(void **state)
{
    struct pack_result demo;
    (void)state;
    assert_int_equal(pack_load("tests/scenes/demo.json", NULL, &demo), 0);
    assert_true(demo.size <= sizeof blobs[0]);
    for (int i = 0; i < 2; i++) {
        memcpy(blobs[i], demo.scene, demo.size);
        lengths[i] = (uint32_t)demo.size;
    }
    pack_free(&demo);
    memset(long_name, 'm', LONG_NAME);
    strcpy(last_name, "xy");
    memset(&machine, 0, sizeof machine);
    memset(&glass, 0, sizeof glass);
    machine.tick_us = 100;
    machine.keys[0].from_us = UINT32_MAX;
    display.ops = &glass_ops;
    board = (struct board){.name = "model",
                           .display = &display,
                           .width = WIDTH,
                           .height = HEIGHT,
                           .band_rows = BAND_ROWS,
                           .format = HAL_RGB565,
                           .pack = &pack_rgb565,
                           .band = {bands[0], bands[1]},
                           .memory = memory,
                           .memory_bytes = sizeof memory};
    app = (struct app){.board = &board, .control = {.scenes = 2, .methods = 3, .budget = CONTROL_BUDGET}};
    return 0;
}

/* The same words on black are in the picture. */
static uint16_t wanted[WIDE * HEIGHT];
static struct glint_band paper;
static struct text_canvas canvas(void)
{
    paper =
        (struct glint_band){wanted, 0, board.height, board.format == HAL_RGB565 ? 2u * board.width : board.width / 2u};
    return (struct text_canvas){.band = &paper, .width = board.width, .format = board.format};
}
static void write_words(unsigned x, unsigned y, const char *text)
{
    const struct text_canvas c = canvas();
    text_draw(&c, x, y, text);
}
static void blank(void)
{
    memset(wanted, 0, sizeof wanted);
}
static void check_words(const uint16_t *picture)
{
    assert_memory_equal(picture, wanted, paper.stride * board.height);
}

#endif

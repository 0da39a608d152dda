/* SPDX-License-Identifier: MIT */
/*
 * A panel of hal/panels/ wired to a model of it. The bus reads a band's pixels as late as it may, when the next call of
 * the bus comes: a band that was given back too early, or a line used twice, shows.
 */
#ifndef PANEL_CASE_H
#define PANEL_CASE_H

#include "clock.h"
#include "panel_model.h"
#include "panels/panel.h"
#include "random.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#define CASE_PIXELS (320 * 240)

static const struct glass {
    const char *name;
    enum model_kind kind;
    const struct panel_controller *controller;
    uint16_t width, height, x, y;
} glasses[] = {
    {"ST7789 240x240", MODEL_ST7789, &panel_st7789, 240, 240, 0, 0},
    {"ST7789 240x240 below", MODEL_ST7789, &panel_st7789, 240, 240, 0, 80},
    {"ST7789 135x240", MODEL_ST7789, &panel_st7789, 135, 240, 52, 40},
    {"ILI9341 240x320", MODEL_ILI9341, &panel_ili9341, 240, 320, 0, 0},
    {"ILI9341 62x30", MODEL_ILI9341, &panel_ili9341, 62, 30, 7, 11},
    {"SSD1351 128x128", MODEL_SSD1351, &panel_ssd1351, 128, 128, 0, 0},
    {"SSD1351 128x96", MODEL_SSD1351, &panel_ssd1351, 128, 96, 0, 32},
    {"SSD1351 31x50", MODEL_SSD1351, &panel_ssd1351, 31, 50, 5, 9},
    {"SSD0323 128x64", MODEL_SSD0323, &panel_ssd0323, 128, 64, 0, 0},
    {"SSD0323 64x30", MODEL_SSD0323, &panel_ssd0323, 64, 30, 20, 7},
};
#define GLASSES (sizeof glasses / sizeof glasses[0])

struct wires {
    struct hal_bus bus;
    struct model model;
    const uint8_t *pixels; /* on their way, or null */
    unsigned word;
    uint32_t count, rows, stride;
    int calls, fail_at; /* the call that fails, or -1 */
    int tears;
};

struct setting {
    struct panel panel;
    struct wires wires;
    const struct glass *glass;
    uint16_t width, height;        /* of the picture */
    uint16_t picture[CASE_PIXELS]; /* a pixel each, as drawn */
    uint8_t band[2][CASE_PIXELS * 2];
    uint32_t memory[CASE_PIXELS / 2];
};

/* One setting at a time; the clock is its model's. */
static struct setting set;

uint32_t clock_us(void)
{
    return (uint32_t)set.wires.model.now;
}

void clock_wait_us(uint32_t us)
{
    set.wires.model.now += us;
}

static int wires_settle(struct wires *wires)
{
    const uint8_t *row = wires->pixels;
    for (uint32_t y = 0; row && y < wires->rows; y++, row += wires->stride)
        for (uint32_t x = 0; x < wires->count; x++) {
            uint16_t word = row[x];
            if (wires->word == 2) {
                memcpy(&word, row + 2 * x, 2);
                model_byte(&wires->model, 1, (uint8_t)(word >> 8));
            }
            model_byte(&wires->model, 1, (uint8_t)word);
        }
    wires->pixels = 0;
    return wires->calls++ == wires->fail_at ? HAL_E_IO : 0;
}

static int wires_write(struct hal_bus *bus, enum hal_bus_kind kind, const uint8_t *bytes, uint32_t count)
{
    struct wires *wires = (struct wires *)bus;
    int error = wires_settle(wires);
    for (uint32_t i = 0; i < count; i++)
        model_byte(&wires->model, kind == HAL_BUS_DATA, bytes[i]);
    return error;
}

static int wires_pixels(struct hal_bus *bus, const void *pixels, unsigned word, uint32_t count, uint32_t rows,
                        uint32_t stride)
{
    struct wires *wires = (struct wires *)bus;
    int error = wires_settle(wires);
    wires->pixels = pixels, wires->word = word, wires->count = count, wires->rows = rows, wires->stride = stride;
    return error;
}

static int wires_wait(struct hal_bus *bus)
{
    return wires_settle((struct wires *)bus);
}

static void wires_reset(struct hal_bus *bus, int level)
{
    struct wires *wires = (struct wires *)bus;
    if (!level)
        model_reset(&wires->model);
    wires->model.reset_low = !level;
    wires->model.ready = wires->model.now + 120000;
}

static void wires_backlight(struct hal_bus *bus, unsigned level)
{
    ((struct wires *)bus)->model.backlight = (int)level;
}

static void wires_tearing(struct hal_bus *bus)
{
    ((struct wires *)bus)->tears++;
}

static const struct hal_bus_ops wires_all = {wires_write, wires_pixels,    wires_wait,
                                             wires_reset, wires_backlight, wires_tearing};
static const struct hal_bus_ops wires_bare = {wires_write, wires_pixels, wires_wait, 0, 0, 0};

/* A panel after power-up, not opened. */
static struct panel *case_prepare(const struct glass *glass, unsigned rotation)
{
    memset(&set.panel, 0, sizeof set.panel);
    memset(&set.wires, 0, sizeof set.wires);
    set.glass = glass;
    set.wires.bus.ops = &wires_all;
    set.wires.fail_at = -1;
    set.wires.model.kind = glass->kind;
    model_reset(&set.wires.model);
    memset(set.wires.model.memory, glass->kind == MODEL_SSD0323 ? 0 : 0xDE, sizeof set.wires.model.memory);
    set.panel = (struct panel){.display.ops = &panel_display,
                               .controller = glass->controller,
                               .bus = &set.wires.bus,
                               .width = glass->width,
                               .height = glass->height,
                               .offset_x = glass->x,
                               .offset_y = glass->y,
                               .rotation = (uint16_t)rotation};
    set.width = rotation % 180 ? glass->height : glass->width;
    set.height = rotation % 180 ? glass->width : glass->height;
    return &set.panel;
}

static int case_open(void)
{
    return panel_display.open(&set.panel.display, set.width, set.height, set.glass->controller->format);
}

static int case_grey(void)
{
    return set.glass->kind == MODEL_SSD0323;
}

static unsigned case_row_bytes(void)
{
    return case_grey() ? set.width / 2u : set.width * 2u;
}

static void case_random_row(unsigned y)
{
    for (unsigned x = 0; x < set.width; x++)
        set.picture[y * set.width + x] = (uint16_t)(random_bits() & (case_grey() ? 15 : 0xFFFF));
}

static inline void case_random_picture(void)
{
    for (unsigned y = 0; y < set.height; y++)
        case_random_row(y);
}

/* Rows as the renderer writes them, `stride` bytes apart. */
static void case_draw_band(uint8_t *band, unsigned y, unsigned rows, unsigned stride)
{
    for (unsigned i = 0; i < rows; i++) {
        const uint16_t *from = set.picture + (y + i) * set.width;
        if (!case_grey())
            memcpy(band + i * stride, from, set.width * 2u);
        else
            for (unsigned x = 0; x < set.width; x += 2)
                band[i * stride + x / 2] = (uint8_t)(from[x] << 4 | from[x + 1]);
    }
}

/* Sends the picture in bands from two buffers in turn; what was given back is spoiled at once. */
static inline int case_show(unsigned rows, unsigned padding)
{
    struct hal_display *display = &set.panel.display;
    unsigned stride = case_row_bytes() + padding;
    int error = panel_display.frame_begin(display, 0, 0), b = 0;
    for (unsigned y = 0; y < set.height && !error; y += rows, b = !b) {
        unsigned count = y + rows > set.height ? set.height - y : rows;
        case_draw_band(set.band[b], y, count, stride);
        error = panel_display.flush(display, set.band[b], (uint16_t)y, (uint16_t)count, stride);
        memset(set.band[!b], 0x5A, stride * rows < sizeof set.band[0] ? stride * rows : sizeof set.band[0]);
    }
    if (!error)
        error = panel_display.frame_end(display);
    return error;
}

/* What an eye sees at x, y of the picture on the glass turned clockwise by the rotation. */
static uint16_t case_seen(unsigned x, unsigned y, int bgr, int dark)
{
    unsigned w = set.glass->width, h = set.glass->height, glass_x = x, glass_y = y;
    switch (set.panel.rotation) {
    case 90:
        glass_x = y, glass_y = h - 1 - x;
        break;
    case 180:
        glass_x = w - 1 - x, glass_y = h - 1 - y;
        break;
    case 270:
        glass_x = w - 1 - y, glass_y = x;
        break;
    }
    return model_seen(&set.wires.model, glass_x + set.glass->x, glass_y + set.glass->y, bgr, dark);
}

/* Pixels that are not seen as drawn. */
static inline unsigned case_wrong(int bgr, int dark)
{
    unsigned wrong = 0;
    for (unsigned y = 0; y < set.height; y++)
        for (unsigned x = 0; x < set.width; x++)
            wrong += case_seen(x, y, bgr, dark) != set.picture[y * set.width + x];
    return wrong;
}

static void case_no_faults(void)
{
    if (set.wires.model.faults)
        fail_msg("%s, rotation %u: %d faults, the first at panel_model.h:%d", set.glass->name, set.panel.rotation,
                 set.wires.model.faults, set.wires.model.first_fault);
}

#endif

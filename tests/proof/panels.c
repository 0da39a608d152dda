/* SPDX-License-Identifier: MIT */
/*
 * A band of any rows goes to the glass, whole or what changed of it, turned by software or not: each row that is sent
 * lies in the band, each that is remembered in the panel's memory, which may hold a picture, a sum a row or nothing.
 * Windows and what goes over the bus are tables.c's.
 *
 *   proves: panel_by_software panel_send panel_flush changes_mix changes_sum changes_same changes_row turn_line
 *           turn_half turn_quarter turn_send
 *   assumes: wire_window wire_window_bytes wire_pixels
 *   options: -eva-precision 3 -eva-slevel 300 -eva-split-return auto
 */
#include "proof.h"

#include <string.h>

#define __builtin_memcmp memcmp
#define __builtin_memcpy memcpy

#include "clock.h"
#include "panels/panel.h"
#include "panels/wire.h"

/*@ assigns \nothing; */
void clock_wait_us(uint32_t us);

/*@ requires there: \valid(panel) && x <= 2047 && y <= 2047 && 1 <= width <= 2048 && 1 <= height <= 2048;
    requires inside: panel->controller->turning == PANEL_BY_SOFTWARE ||
        (x + width <= panel->across && y + height <= panel->down);
    assigns \result, panel->sent \from panel->sent, x, y, width, height;
    ensures -2 <= \result <= 0; */
int wire_window(struct panel *panel, uint32_t x, uint32_t y, uint32_t width, uint32_t height);

/*@ assigns \result \from \nothing;
    ensures 6 <= \result <= 11; */
uint32_t wire_window_bytes(const struct panel_controller *controller);

/*@ requires some: \valid(panel) && 1 <= bytes <= 4096 && 1 <= rows <= 2048;
    requires there: \valid_read((const uint8_t *)pixels + (0 .. (rows - 1) * stride + bytes - 1));
    assigns \result, panel->sent \from panel->sent, bytes, rows;
    ensures -2 <= \result <= 0; */
int wire_pixels(struct panel *panel, const void *pixels, uint32_t bytes, uint32_t rows, uint32_t stride);

#include "hal/panels/changes.c"
#include "hal/panels/panel.c"
#include "hal/panels/ssd0323.c"
#include "hal/panels/turn.c"

#define ROWS 3

static int bus_wait(struct hal_bus *bus)
{
    (void)bus;
    return any_s32(-2, 0);
}

/* Rows y .. of a picture that is open, with so much memory for the last one; nothing lies before or behind either. */
static void flush(const struct panel_controller *controller, uint8_t turns, uint16_t across, uint16_t down,
                  uint32_t memory_size, uint16_t y, uint16_t rows, uint32_t gap)
{
    static const struct hal_bus_ops ops = {.wait = bus_wait};
    struct hal_bus bus = {&ops};
    static uint8_t memory[ROWS * 128], band[ROWS * 128];
    struct panel panel = {.controller = controller, .bus = &bus, .across = across, .down = down, .turns = turns};
    panel.row_bytes = (uint16_t)(controller->format == HAL_RGB565 ? across * 2u : across / 2u);
    panel.memory = memory + sizeof memory - memory_size;
    panel.memory_size = memory_size;
    panel.window_cost = (uint16_t)any_u32(0, 65535);
    panel.next = (uint16_t)any_u32(0, 65535);
    panel.all = any_flag();
    any_bytes(memory, sizeof memory);
    any_bytes(band, sizeof band);
    const uint32_t stride = panel.row_bytes + gap, bytes = rows ? (rows - 1) * stride + panel.row_bytes : 0;
    panel_display.flush(&panel.display, band + sizeof band - bytes, y, rows, stride);
}

static void bands(const struct panel_controller *controller, uint8_t turns, uint16_t across, uint32_t gap)
{
    const uint32_t whole = ROWS * (controller->format == HAL_RGB565 ? across * 2u : across / 2u);
    const uint32_t sizes[] = {whole, whole - 1, 4 * ROWS, 4 * ROWS - 1, 0};
    //@ loop unroll 4;
    for (uint16_t y = 0; y <= ROWS; y++)
        //@ loop unroll 5;
        for (uint16_t rows = 0; rows <= ROWS + 1 - y; rows++)
            //@ loop unroll 5;
            for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++)
                flush(controller, turns, across, ROWS, sizes[i], y, rows, gap);
}

/* The longest lines that are turned. */
static void lines(uint8_t turns, uint16_t across, uint16_t down)
{
    flush(&panel_ssd0323, turns, across, down, 0, 0, 2, 0);
    flush(&panel_ssd0323, turns, across, down, 0, (uint16_t)(down - 2), 2, 0);
}

void prove(void)
{
    static const struct panel_controller colours = {.format = HAL_RGB565};
    bands(&colours, (uint8_t)any_u32(0, 3), 3, 5);
    bands(&panel_ssd0323, 1, 10, 3);
    bands(&panel_ssd0323, 2, 10, 0);
    flush(&colours, 0, 9, ROWS, 4 * ROWS, 0, ROWS, 0); /* a sum of four words and more */
    lines(1, 80, 128);
    lines(2, 128, 80);
    lines(3, 80, 128);
}

/* SPDX-License-Identifier: MIT */
#include "panels/wire.h"
#include "clock.h"

int wire_command(struct panel *panel, uint8_t command, const uint8_t *arguments, uint32_t count)
{
    struct hal_bus *bus = panel->bus;
    panel->sent += 1 + count;
    int error = bus->ops->write(bus, HAL_BUS_COMMAND, &command, 1);
    if (error || !count)
        return error;
    return bus->ops->write(bus, (enum hal_bus_kind)panel->controller->arguments, arguments, count);
}

int wire_table(struct panel *panel, struct panel_table table, uint32_t longest)
{
    for (uint32_t i = 0; i < table.size;) {
        const uint8_t *at = table.bytes + i;
        uint8_t command = at[0];
        uint32_t count = at[1] & ~(uint32_t)PANEL_DELAY, ms = 0;
        const uint8_t *arguments = at + 2;
        i += 2 + count;
        if (at[1] & PANEL_DELAY)
            ms = table.bytes[i++] * 5u;
        int error = wire_command(panel, command, arguments, count);
        if (error)
            return error;
        if (ms)
            clock_wait_us((ms < longest ? ms : longest) * 1000);
    }
    return 0;
}

static int wire_range(struct panel *panel, uint8_t command, uint32_t first, uint32_t last)
{
    if (panel->controller->address_bytes == 1)
        return wire_command(panel, command, (const uint8_t[]){(uint8_t)first, (uint8_t)last}, 2);
    const uint8_t range[] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};
    return wire_command(panel, command, range, 4);
}

int wire_window(struct panel *panel, uint32_t x, uint32_t y, uint32_t width, uint32_t height)
{
    const struct panel_controller *controller = panel->controller;
    uint32_t x1 = x + panel->left, y1 = y + panel->top, x2 = x1 + width - 1, y2 = y1 + height - 1;
    if (controller->format == HAL_GREY4)
        x1 /= 2, x2 /= 2;
    int exchanged = (panel->turns & 1) && controller->turning == PANEL_GOES_DOWN;
    int error = wire_range(panel, exchanged ? controller->row : controller->column, x1, x2);
    if (!error)
        error = wire_range(panel, exchanged ? controller->column : controller->row, y1, y2);
    if (!error && controller->write)
        error = wire_command(panel, controller->write, 0, 0);
    return error;
}

uint32_t wire_window_bytes(const struct panel_controller *controller)
{
    return 2 * (1 + 2u * controller->address_bytes) + (controller->write != 0);
}

int wire_pixels(struct panel *panel, const void *pixels, uint32_t bytes, uint32_t rows, uint32_t stride)
{
    unsigned word = panel->controller->format == HAL_RGB565 ? 2 : 1;
    panel->sent += bytes * rows;
    return panel->bus->ops->pixels(panel->bus, pixels, word, bytes / word, rows, stride);
}

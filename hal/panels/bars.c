/* SPDX-License-Identifier: MIT */
#include "panels/panel.h"

#define BARS  8
#define WHITE 0xFFFFu

/* Bits of a bar's number, from 0 on the left: 4 takes red off, 2 green, 1 blue... as television's bars, by brightness:
 * green counts most, then red, then blue. */
static uint16_t bars_colour(uint32_t bar)
{
    return (uint16_t)((bar & 2 ? 0 : 0xF800u) | (bar & 4 ? 0 : 0x07E0u) | (bar & 1 ? 0 : 0x001Fu));
}

/* One of red, green, blue and white, from dark to light. */
static uint16_t bars_ramp(uint32_t ramp, uint32_t x, uint32_t width)
{
    static const uint16_t masks[4] = {0xF800, 0x07E0, 0x001F, 0xFFFF};
    uint32_t level = x * 32 / width;
    return (uint16_t)((level << 11 | level << 6 | level) & masks[ramp]);
}

static void bars_put(const struct panel *panel, void *row, uint32_t x, uint32_t colour)
{
    if (panel->controller->format == HAL_RGB565) {
        ((uint16_t *)row)[x] = (uint16_t)colour;
        return;
    }
    uint8_t *pair = (uint8_t *)row + x / 2;
    *pair = (uint8_t)(x & 1 ? (*pair & 0xF0u) | colour : (*pair & 0x0Fu) | colour << 4);
}

/* Parts of the picture begin at even rows where it is grey, with an edge of two: what an SSD0323 takes at quarter
 * turns. */
void panel_bars_row(const struct panel *panel, void *row, uint32_t y)
{
    const int grey = panel->controller->format == HAL_GREY4;
    const uint32_t width = panel->across, height = panel->down, edge = grey ? 2 : 1, ramps = height * 3 / 4 & ~1u;
    for (uint32_t x = 0; x < width; x++) {
        uint32_t bar = x * BARS / width, colour;
        if (y < edge || y >= height - edge || x == 0 || x == width - 1)
            colour = grey ? 15 : WHITE;
        else if (y < ramps)
            colour = grey ? 14 - 2 * bar : bars_colour(bar);
        else
            colour = grey ? x * 16 / width : bars_ramp((y - ramps) * 4 / (height - ramps), x, width);
        bars_put(panel, row, x, colour);
    }
}

int panel_bars(struct panel *panel, void *row)
{
    uint32_t height = panel->down, rows = panel->controller->format == HAL_GREY4 && height % 2 == 0 ? 2 : 1;
    panel_repaint(panel);
    int error = panel_display.frame_begin(&panel->display, 0, 0);
    for (uint32_t y = 0; y < height && !error; y += rows) {
        panel_bars_row(panel, row, y);
        /* the row is used again: a stride of 0, and nothing may be on its way when it changes */
        error = panel_display.flush(&panel->display, row, (uint16_t)y, (uint16_t)rows, 0);
        if (!error)
            error = panel->bus->ops->wait(panel->bus);
    }
    return error ? error : panel_display.frame_end(&panel->display);
}

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

static uint16_t bars_ramp(uint32_t x, uint32_t width)
{
    uint32_t level = x * 32 / width;
    return (uint16_t)(level << 11 | level << 6 | level);
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

enum bars_part { BARS_EDGE, BARS_COLOURS, BARS_RAMP };

static void bars_row(const struct panel *panel, void *row, enum bars_part part)
{
    int grey = panel->controller->format == HAL_GREY4;
    uint32_t width = panel->across;
    for (uint32_t x = 0; x < width; x++) {
        uint32_t bar = x * BARS / width, colour;
        if (part == BARS_EDGE || x == 0 || x == width - 1)
            colour = grey ? 15 : WHITE;
        else if (part == BARS_COLOURS)
            colour = grey ? 14 - 2 * bar : bars_colour(bar);
        else
            colour = grey ? x * 16 / width : bars_ramp(x, width);
        bars_put(panel, row, x, colour);
    }
}

/* A row sent again and again: a stride of 0. */
static int bars_send(struct panel *panel, void *row, enum bars_part part, uint32_t y, uint32_t rows)
{
    bars_row(panel, row, part);
    int error = panel_display.flush(&panel->display, row, (uint16_t)y, (uint16_t)rows, 0);
    return error ? error : panel->bus->ops->wait(panel->bus);
}

int panel_bars(struct panel *panel, void *row)
{
    /* Bands of two rows at least: what an SSD0323 takes at quarter turns. Its edge is then two rows thick. */
    uint32_t height = panel->down, edge = panel->controller->format == HAL_GREY4 ? 2 : 1;
    uint32_t ramp = height * 3 / 4 & ~1u;
    panel_repaint(panel);
    int error = panel_display.frame_begin(&panel->display, 0, 0);
    if (!error)
        error = bars_send(panel, row, BARS_EDGE, 0, edge);
    if (!error)
        error = bars_send(panel, row, BARS_COLOURS, edge, ramp - edge);
    if (!error)
        error = bars_send(panel, row, BARS_RAMP, ramp, height - edge - ramp);
    if (!error)
        error = bars_send(panel, row, BARS_EDGE, height - edge, edge);
    return error ? error : panel_display.frame_end(&panel->display);
}

/* SPDX-License-Identifier: MIT */
#include "panels/turn.h"
#include "panels/wire.h"

static int turn_line(struct panel *panel, uint32_t x, uint32_t y, uint32_t width, uint32_t height, const uint8_t *line)
{
    uint32_t bytes = width / 2 * height;
    int error = wire_window(panel, x, y, width, height);
    if (!error)
        error = wire_pixels(panel, line, bytes, 1, bytes);
    /* The caller's line is used again. */
    return error ? error : panel->bus->ops->wait(panel->bus);
}

static int turn_half(struct panel *panel, const uint8_t *row, uint32_t y)
{
    uint8_t line[TURN_BYTES];
    for (uint32_t i = 0; i < panel->row_bytes; i++) {
        uint32_t pair = row[panel->row_bytes - 1u - i];
        line[i] = (uint8_t)((pair & 15) << 4 | pair >> 4);
    }
    return turn_line(panel, 0, panel->down - 1u - y, panel->across, 1, line);
}

/* Two rows of the picture are a column of bytes: at 90 degrees the upper row is left and its first pixel at the bottom,
 * at 270 the upper row is right and its first pixel at the top. */
static int turn_quarter(struct panel *panel, const uint8_t *upper, const uint8_t *lower, uint32_t y)
{
    uint8_t line[TURN_BYTES];
    int quarter = panel->turns == 1;
    const uint8_t *left = quarter ? upper : lower, *right = quarter ? lower : upper;
    for (uint32_t x = 0; x < panel->across; x++) {
        uint32_t shift = x & 1 ? 0 : 4, l = left[x / 2] >> shift & 15, r = right[x / 2] >> shift & 15;
        line[quarter ? panel->across - 1u - x : x] = (uint8_t)(l << 4 | r);
    }
    return turn_line(panel, quarter ? y : panel->down - 2u - y, 0, 2, panel->across, line);
}

int turn_send(struct panel *panel, const uint8_t *pixels, uint32_t y, uint32_t rows, uint32_t stride)
{
    int error = 0;
    uint32_t step = panel->turns & 1 ? 2 : 1;
    for (uint32_t i = 0; i < rows && !error; i += step, pixels += step * stride)
        error = step == 2 ? turn_quarter(panel, pixels, pixels + stride, y + i) : turn_half(panel, pixels, y + i);
    return error;
}

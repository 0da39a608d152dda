/* SPDX-License-Identifier: MIT */
#include "app/crash.h"
#include "app/text.h"
#include "clock.h"
#include "cortexm/fault.h"
#include "input.h"

/* A clause a line: what stands before the next ", ". */
static void crash_lines(const struct text_canvas *canvas, unsigned height, const char *text)
{
    const unsigned cell = text_height(canvas->width), margin = text_width(canvas->width);
    for (unsigned y = cell; *text; y += 2 * cell) {
        char line[FAULT_TEXT];
        unsigned length = 0;
        while (*text && *text != ',')
            line[length++] = *text++;
        line[length] = 0;
        while (*text == ',' || *text == ' ')
            text++;
        text_draw(canvas, margin, y, line);
    }
    text_draw(canvas, margin, height - 2 * cell, "press a button");
}

static int crash_picture(const struct board *board, const char *text)
{
    struct hal_display *display = board->display;
    uint32_t stride = (board->format == GLINT_RGB565 ? 2u * board->width : (board->width + 1u) / 2);
    int error = display->ops->frame_begin ? display->ops->frame_begin(display, 0, 0) : 0;
    for (unsigned y = 0, index = 0; y < board->height && !error; y += board->band_rows, index ^= 1) {
        unsigned left = board->height - y, rows = left < board->band_rows ? left : board->band_rows;
        struct glint_band band = {board->band[index], (uint16_t)y, (uint16_t)rows, stride};
        for (uint32_t i = 0; i < stride * rows; i++)
            ((uint8_t *)band.pixels)[i] = 0;
        crash_lines(&(struct text_canvas){&band, board->width, board->format, 0}, board->height, text);
        error = display->ops->flush(display, band.pixels, band.y, band.rows, band.stride);
    }
    return error || !display->ops->frame_end ? error : display->ops->frame_end(display);
}

static void crash_wait(int held)
{
    while ((input_buttons() != 0) != held)
        clock_idle();
}

void crash_show(const struct board *board)
{
    struct fault fault;
    char text[FAULT_TEXT];
    if (!fault_last(&fault))
        return;
    fault_text(&fault, text);
    if (crash_picture(board, text) != 0) /* the serial line has it */
        return;
    for (int held = 0; held < 3; held++) /* up, down, up */
        crash_wait(held & 1);
}

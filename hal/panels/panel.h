/* SPDX-License-Identifier: MIT */
/*
 * Panels with a memory of their own behind a serial bus, each a table of data (st7789, ili9341, ssd1351, ssd0323). What
 * a glass needs is said by the board or the user:
 *
 *     static uint32_t rows[240];
 *     struct panel panel = {.display.ops = &panel_display, .controller = &panel_st7789, .bus = &bus, .width = 240,
 *                           .height = 240, .memory = rows, .memory_size = sizeof rows};
 *     panel.display.ops->open(&panel.display, 240, 240, HAL_RGB565);
 *
 * The bus is write-only: a panel that is missing or has lost its registers is not seen. `refresh` mends the second.
 */
#ifndef HAL_PANELS_PANEL_H
#define HAL_PANELS_PANEL_H

#include "bus.h"
#include "display.h"

#include <stdatomic.h>

/* Tables of commands: a command, the number of its arguments, the arguments; with PANEL_DELAY added to the number, a
 * byte more: units of 5 ms to wait then. */
#define PANEL_DELAY 0x80

struct panel_table {
    const uint8_t *bytes;
    uint16_t size;
};

/* How a picture is turned by a quarter. */
enum panel_turning {
    PANEL_EXCHANGES,   /* the controller exchanges a window's sides (MADCTL's MV) */
    PANEL_GOES_DOWN,   /* it fills columns first, in windows that keep the memory's sides */
    PANEL_BY_SOFTWARE, /* turn.c, half a turn too */
};

/* What is one controller's own, from its data sheet. Where modules differ, as the usual one has it. */
struct panel_controller {
    struct panel_table reset; /* to the state after power-up; empty where only the reset line does it */
    struct panel_table start; /* all registers; can be sent again at any time */
    struct panel_table on, off;
    uint16_t columns, rows;     /* pixels of its memory */
    uint8_t format;             /* enum hal_pixel_format it takes */
    uint8_t arguments;          /* enum hal_bus_kind of a command's arguments */
    uint8_t address_bytes;      /* of a column or row in a window */
    uint8_t column, row, write; /* commands of a window; write == 0: pixels follow the rows */
    uint8_t orient;             /* the command for turn[] */
    uint8_t turn[4];            /* its argument at 0, 90, 180, 270 degrees */
    uint8_t turning;            /* enum panel_turning */
    uint8_t bgr;                /* bit of the argument that swaps red and blue; 0: it has no colours */
    uint8_t normal, inverted;   /* commands */
    uint8_t tearing;            /* command that turns the tearing signal on, with one argument 0; 0: none */
};

extern const struct panel_controller panel_st7789, panel_ili9341, panel_ssd1351, panel_ssd0323;

struct panel {
    struct hal_display display; /* ops: &panel_display */
    const struct panel_controller *controller;
    struct hal_bus *bus;
    struct panel_table extra;    /* sent after the controller's own start table: what a board has otherwise */
    uint16_t width, height;      /* pixels of the glass as built, before rotation */
    uint16_t offset_x, offset_y; /* where its first pixel is in the controller's memory, before rotation */
    uint16_t rotation;           /* 0, 90, 180, 270: degrees the panel is turned clockwise; the picture stays upright */
    uint8_t bgr, invert;         /* 1: red and blue, or light and dark, the other way than on the usual module */
    uint16_t refresh;            /* pictures from one sending of all registers to the next; 0: only in open() */
    /* To send changed rows only, memory for the last picture; without it, or with less than 4 bytes a row, every row
     * is sent. A whole picture's bytes: exact. Less: a 32-bit checksum a row, a change missed once in 2^32 changed rows
     * (83 hours of 240 rows 60 times a second), until the row changes again or the next repaint. At a multiple of 4. */
    void *memory;
    uint32_t memory_size;
    /* Unchanged rows between changed ones are sent too while they have no more bytes than this. 0: a window's bytes on
     * the wire. More, where stopping a transfer costs the machine time. */
    uint16_t window_cost;

    /* to read: bytes sent for this picture so far, commands included */
    uint32_t sent;
    uint32_t sent_last; /* of the last picture that was complete */

    /* the panel's own */
    uint16_t across, down; /* the picture's size, turned */
    uint16_t left, top;    /* added to a window's address */
    uint16_t row_bytes;
    uint16_t next;      /* the row at which the open window goes on, or PANEL_NO_ROW */
    uint16_t age;       /* pictures since all registers were sent */
    uint8_t turns;      /* quarter turns */
    uint8_t shown;      /* a picture was: display on, backlight on */
    atomic_uchar asked; /* repaints so far, modulo 256: panel_repaint() alone writes it */
    uint8_t begun;      /* of these, what a picture has begun for */
    uint8_t all;        /* the picture under way is sent whole */
};

#define PANEL_NO_ROW 0xffff

/* open: HAL_E_ARGUMENT if the size is not the glass's (turned), the format not the controller's, an option out of
 * range. Waits up to half a second for the panel to wake; display and backlight go on with the first picture. flush:
 * HAL_E_ARGUMENT for rows outside; an SSD0323 at 90 or 270 degrees takes bands that begin and end at even rows. The
 * backlight goes on at full when the first picture is complete; afterwards its level is the board's. */
extern const struct hal_display_ops panel_display;

/* The next picture to begin is sent whole. By one CPU, while another may be at any of the display's calls. */
void panel_repaint(struct panel *panel);

/* Row y of the self-test's picture, for a program that draws it itself. */
void panel_bars_row(const struct panel *panel, void *row, uint32_t y);

/* Draws the self-test: white, yellow, cyan, green, magenta, red, blue, black from left to right (or 8 greys), below
 * them ramps from dark to light of red, green, blue and white (or of the greys), around all a line. Order tells
 * rotation and BGR, dark and light tell inversion, ramps that jump tell exchanged bytes, a missing side of the line
 * tells an offset. To be called between open and close, outside a picture. `row` is room for a row of pixels; 0 or a
 * HAL_E code. */
int panel_bars(struct panel *panel, void *row);

#endif

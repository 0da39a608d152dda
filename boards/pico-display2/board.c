/* SPDX-License-Identifier: MIT */
/* Raspberry Pi Pico in a Pimoroni Pico Display Pack 2.0, https://shop.pimoroni.com/products/pico-display-pack-2-0:
 * RP2040, 2 MiB flash, ST7789 320x240 and four keys. */
#include "boards/rp2040.h"

#define WIDTH     320u
#define HEIGHT    240u
#define BAND_ROWS 24u                              /* a band takes 15,360 bytes, its depth as many */
#define MEMORY    (160u * 1024u)                   /* bytes: 4000 triangles with a table */
#define WORKER    (2u * WIDTH * BAND_ROWS + 3584u) /* bytes: a band's depth and the working state, with all effects */

/* A opens the menu, in which X goes from line to line, B and Y change one. */
static const struct rp2040_button buttons[] = {{12, HAL_A}, {13, HAL_LEFT}, {14, HAL_DOWN}, {15, HAL_RIGHT}};

/* GCTRL, VCOMS and the gammas of this glass */
static const uint8_t extra[] = {
    0xB7, 1,    0x35, 0xBB, 1,  0x1F, 0xE0, 14,   0xD0, 0x08, 0x11, 0x08, 0x0C, 0x15, 0x39, 0x33, 0x50, 0x36, 0x13,
    0x14, 0x29, 0x2D, 0xE1, 14, 0xD0, 0x08, 0x10, 0x08, 0x06, 0x06, 0x39, 0x44, 0x51, 0x0B, 0x16, 0x14, 0x2F, 0x31,
};

static uint32_t band[4][WIDTH * BAND_ROWS / 2], memory[MEMORY / 4], worker[WORKER / 4], sums[HEIGHT];

const struct rp2040_board rp2040_board = {
    .uart_tx = 0,
    .uart_rx = 1,
    .dc = 16,
    .cs = 17,
    .sck = 18,
    .mosi = 19,
    .backlight = 20,
    .reset = RP2040_NO_PIN,
    .tearing = RP2040_NO_PIN,
    .spi_mode = 0,
    .spi_divisor = 2,
    .buttons = buttons,
    .button_count = sizeof buttons / sizeof buttons[0],
};

struct panel rp2040_panel = {
    .display.ops = &panel_display,
    .controller = &panel_st7789,
    .extra = {extra, sizeof extra},
    .width = HEIGHT, /* the glass as built stands upright */
    .height = WIDTH,
    .rotation = 270,
    .refresh = 600, /* pictures from one sending of all registers to the next: ten seconds */
    .memory = sums,
    .memory_size = sizeof sums,
};

const struct board rp2040_app = {
    .name = "pico-display2",
    .display = &rp2040_panel.display,
    .width = WIDTH,
    .height = HEIGHT,
    .band_rows = BAND_ROWS,
    .format = HAL_RGB565,
    .pack = &pack_rgb565,
    .band = {band[0], band[1], band[2], band[3]},
    .memory = memory,
    .memory_bytes = sizeof memory,
    .core = &rp2040_core1,
    .worker = worker,
    .worker_bytes = sizeof worker,
};

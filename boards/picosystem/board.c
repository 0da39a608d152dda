/* SPDX-License-Identifier: MIT */
/* Pimoroni PicoSystem, https://shop.pimoroni.com/products/picosystem: RP2040, 16 MiB flash, ST7789 240x240. */
#include "boards/rp2040.h"

#define SIZE      240u
#define BAND_ROWS 30u                             /* a band takes 14,400 bytes, its depth as many */
#define MEMORY    (160u * 1024u)                  /* bytes: 4000 triangles with a table */
#define WORKER    (2u * SIZE * BAND_ROWS + 3584u) /* bytes: a band's depth and the working state, with all effects */

static const struct rp2040_button buttons[] = {
    {23, HAL_UP}, {20, HAL_DOWN}, {22, HAL_LEFT}, {21, HAL_RIGHT}, {18, HAL_A}, {19, HAL_B}, {17, HAL_X}, {16, HAL_Y},
};

static const uint8_t extra[] = {0xBB, 1, 0x25}; /* VCOMS of this glass */

static uint32_t band[4][SIZE * BAND_ROWS / 2], memory[MEMORY / 4], worker[WORKER / 4], sums[SIZE];

const struct rp2040_board rp2040_board = {
    .uart_tx = 0,
    .uart_rx = 1,
    .reset = 4,
    .cs = 5,
    .sck = 6,
    .mosi = 7,
    .tearing = 8,
    .dc = 9,
    .backlight = 12,
    .spi_mode = 0,
    .spi_divisor = 2,
    .buttons = buttons,
    .button_count = sizeof buttons / sizeof buttons[0],
};

struct panel rp2040_panel = {
    .display.ops = &panel_display,
    .controller = &panel_st7789,
    .extra = {extra, sizeof extra},
    .width = SIZE,
    .height = SIZE,
    .memory = sums,
    .memory_size = sizeof sums,
};

const struct board rp2040_app = {
    .name = "picosystem",
    .display = &rp2040_panel.display,
    .width = SIZE,
    .height = SIZE,
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

/* SPDX-License-Identifier: MIT */
/* Raspberry Pi Pico with an ST7789, wired as the Waveshare Pico-LCD-1.3, https://www.waveshare.com/wiki/Pico-LCD-1.3:
 * RP2040, 2 MiB flash, 240x240, a joystick and four keys. Any other wiring is a change of the pins below. */
#include "boards/rp2040.h"

#define SIZE      240u
#define BAND_ROWS 30u                             /* a band takes 14,400 bytes, its depth as many */
#define MEMORY    (160u * 1024u)                  /* bytes: 4000 triangles with a table */
#define WORKER    (2u * SIZE * BAND_ROWS + 3584u) /* bytes: a band's depth and the working state, with all effects */

/* The joystick's press and key A do the same. */
static const struct rp2040_button buttons[] = {
    {2, HAL_UP}, {18, HAL_DOWN}, {16, HAL_LEFT}, {20, HAL_RIGHT}, {3, HAL_A},
    {15, HAL_A}, {17, HAL_B},    {19, HAL_X},    {21, HAL_Y},
};

static uint32_t band[4][SIZE * BAND_ROWS / 2], memory[MEMORY / 4], worker[WORKER / 4], sums[SIZE];

const struct rp2040_board rp2040_board = {
    .uart_tx = 0,
    .uart_rx = 1,
    .dc = 8,
    .cs = 9,
    .sck = 10, /* SPI1's */
    .mosi = 11,
    .reset = 12,
    .backlight = 13,
    .tearing = RP2040_NO_PIN,
    .spi_mode = 0,
    .spi_divisor = 2,
    .buttons = buttons,
    .button_count = sizeof buttons / sizeof buttons[0],
};

struct panel rp2040_panel = {
    .display.ops = &panel_display,
    .controller = &panel_st7789,
    .width = SIZE,
    .height = SIZE,
    .rotation = 270, /* the glass is mounted with its cable at the side */
    .refresh = 600,  /* its wires are longer than a handheld's: all registers anew every ten seconds */
    .memory = sums,
    .memory_size = sizeof sums,
};

const struct board rp2040_app = {
    .name = "pico-st7789",
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

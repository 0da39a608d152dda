/* SPDX-License-Identifier: MIT */
#include "boards/picosystem/board.h"
#include "input.h"
#include "rp2040/rp2040.h"

static const struct rp2040_button buttons[] = {
    {23, HAL_UP}, {20, HAL_DOWN}, {22, HAL_LEFT}, {21, HAL_RIGHT}, {18, HAL_A}, {19, HAL_B}, {17, HAL_X}, {16, HAL_Y},
};

static const uint8_t extra[] = {0xBB, 1, 0x25}; /* VCOMS of this glass */

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

struct panel *picosystem_start(void)
{
    static struct panel panel = {.display.ops = &panel_display,
                                 .controller = &panel_st7789,
                                 .extra = {extra, sizeof extra},
                                 .width = 240,
                                 .height = 240};
    rp2040_start();
    panel.bus = rp2040_bus();
    return &panel;
}

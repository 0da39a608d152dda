/* SPDX-License-Identifier: MIT */
#include "boards/lm3s6965evb/board.h"
#include "boards/board.h"
#include "input.h"
#include "panels/panel.h"

const struct lm3s_key lm3s_keys[] = {BOARD_KEYS, {{0, 0}, 0}};

static uint32_t board_band[2][BOARD_BAND_ROWS * BOARD_WIDTH / 2 / 4], board_memory[BOARD_MEMORY / 4];
static struct lm3s_bus board_bus;
static uint32_t board_rows[BOARD_HEIGHT]; /* checksums of the rows on show */
static struct panel board_oled = {.display.ops = &panel_display,
                                  .controller = &panel_ssd0323,
                                  .bus = &board_bus.bus,
                                  .width = BOARD_WIDTH,
                                  .height = BOARD_HEIGHT,
                                  .refresh = BOARD_OLED_REFRESH,
                                  .memory = board_rows,
                                  .memory_size = sizeof board_rows};

const struct board *board_start(void)
{
    static const struct board board = {.name = "lm3s6965evb",
                                       .display = &board_oled.display,
                                       .width = BOARD_WIDTH,
                                       .height = BOARD_HEIGHT,
                                       .band_rows = BOARD_BAND_ROWS,
                                       .format = HAL_GREY4,
                                       .dither = 1,
                                       .band = {board_band[0], board_band[1]},
                                       .memory = board_memory,
                                       .memory_bytes = sizeof board_memory};
    lm3s_clock_start();
    lm3s_uart_start();
    lm3s_keys_start();
    lm3s_pins_output(BOARD_CARD_CS, 1);
    lm3s_pins_output(BOARD_OLED_POWER, 1);
    lm3s_bus_start(&board_bus, BOARD_OLED_DC, BOARD_OLED_DIVIDER, BOARD_OLED_RATE);
    return &board;
}

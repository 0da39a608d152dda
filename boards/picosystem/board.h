/* SPDX-License-Identifier: MIT */
/* Pimoroni PicoSystem, https://shop.pimoroni.com/products/picosystem: RP2040, 16 MiB flash, ST7789 240x240. */
#ifndef BOARD_PICOSYSTEM_H
#define BOARD_PICOSYSTEM_H

#include "panels/panel.h"

/* Starts clocks, timer, serial line and buttons, and gives the display, not yet open; its options can be changed
 * until then. */
struct panel *picosystem_start(void);

#endif

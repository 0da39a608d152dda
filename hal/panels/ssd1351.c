/* SPDX-License-Identifier: MIT */
/*
 * Solomon Systech SSD1351, 128x128 RGB565 OLED. At quarter turns it counts rows first, within windows that keep their
 * sides. A 128x96 glass on it is at offset_y 32.
 */
#include "panels/panel.h"

static const uint8_t start[] = {
    0xFD, 1, 0x12,             /* command lock: take commands */
    0xFD, 1, 0xB1,             /* and those below */
    0xAE, 0,                   /* display off */
    0xB3, 1, 0xF1,             /* clock */
    0xCA, 1, 0x7F,             /* 128 lines */
    0xA1, 1, 0x00,             /* start line */
    0xA2, 1, 0x00,             /* display offset */
    0xB5, 1, 0x00,             /* GPIO off */
    0xAB, 1, 0x01,             /* own regulator */
    0xB1, 1, 0x32,             /* precharge */
    0xB4, 3, 0xA0, 0xB5, 0x55, /* segment low voltage */
    0xBB, 1, 0x17,             /* precharge voltage */
    0xBE, 1, 0x05,             /* VCOMH */
    0xC1, 3, 0xC8, 0x80, 0xC8, /* contrast of the colours */
    0xC7, 1, 0x0F,             /* contrast */
    0xB6, 1, 0x01,             /* second precharge */
};

static const uint8_t on[] = {0xAF, 0};
static const uint8_t off[] = {0xAE, 0};

const struct panel_controller panel_ssd1351 = {
    .start = {start, sizeof start},
    .on = {on, sizeof on},
    .off = {off, sizeof off},
    .columns = 128,
    .rows = 128,
    .format = HAL_RGB565,
    .arguments = HAL_BUS_DATA,
    .address_bytes = 1,
    .column = 0x15,
    .row = 0x75,
    .write = 0x5C,
    .orient =
        0xA0, /* 16 bits 40, lines interleaved 20, lines from below 10, red first 04, columns back 02, down first 01 */
    .turn = {0x74, 0x65, 0x66, 0x77},
    .turning = PANEL_GOES_DOWN,
    .bgr = 0x04,
    .normal = 0xA6,
    .inverted = 0xA7,
};

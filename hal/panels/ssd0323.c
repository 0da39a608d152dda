/* SPDX-License-Identifier: MIT */
/*
 * Solomon Systech SSD0323, 128x80 OLED of 16 greys, as the usual 128x64 glass is wired. Arguments go with D/C low.
 * Turned by software: a byte has two pixels.
 */
#include "panels/panel.h"

static const uint8_t start[] = {
    0xAE, 0,                                                 /* display off */
    0xB3, 1, 0x91,                                           /* clock */
    0xA8, 1, 0x3F,                                           /* 64 lines */
    0xA2, 1, 0x40,                                           /* display offset */
    0xA1, 1, 0x00,                                           /* start line */
    0xAD, 1, 0x02,                                           /* supply from outside */
    0x86, 0,                                                 /* full current */
    0xB8, 8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76, /* greys */
    0x81, 1, 0x70,                                           /* contrast */
    0xB2, 1, 0x51,                                           /* row period */
    0xB1, 1, 0x55,                                           /* phases */
    0xBC, 1, 0x10,                                           /* precharge voltage */
    0xBE, 1, 0x1C,                                           /* VCOMH */
    0xBF, 1, 0x0F,                                           /* segment low voltage */
};

static const uint8_t on[] = {0xAF, 0};
static const uint8_t off[] = {0xAE, 0};

const struct panel_controller panel_ssd0323 = {
    .start = {start, sizeof start},
    .on = {on, sizeof on},
    .off = {off, sizeof off},
    .columns = 128,
    .rows = 80,
    .format = HAL_GREY4,
    .arguments = HAL_BUS_COMMAND,
    .address_bytes = 1,
    .column = 0x15,
    .row = 0x75,
    .orient = 0xA0, /* lines interleaved 40, lines from below 10, left pixel high 02 */
    .turn = {0x52, 0x52, 0x52, 0x52},
    .turning = PANEL_BY_SOFTWARE,
    .normal = 0xA4,
    .inverted = 0xA7,
};

/* SPDX-License-Identifier: MIT */
/*
 * Ilitek ILI9341, 240x320 RGB565. Its usual glass has blue first (MADCTL's BGR is set for the usual order) and its rows
 * from below: GS in B6 turns them, and MADCTL is then the ST7789's.
 */
#include "panels/panel.h"

static const uint8_t reset[] = {0x01, 0 | PANEL_DELAY, 150 / 5}; /* SWRESET */

static const uint8_t start[] = {
    0xEF, 3, 0x03, 0x80, 0x02,             /* as the maker's start-up code has it */
    0xCF, 3, 0x00, 0xC1, 0x30,             /* power control B */
    0xED, 4, 0x64, 0x03, 0x12, 0x81,       /* power-on sequence */
    0xE8, 3, 0x85, 0x00, 0x78,             /* driver timing A */
    0xCB, 5, 0x39, 0x2C, 0x00, 0x34, 0x02, /* power control A */
    0xF7, 1, 0x20,                         /* pump ratio */
    0xEA, 2, 0x00, 0x00,                   /* driver timing B */
    0xC0, 1, 0x23,                         /* PWCTRL1 */
    0xC1, 1, 0x10,                         /* PWCTRL2 */
    0xC5, 2, 0x3E, 0x28,                   /* VMCTRL1 */
    0xC7, 1, 0x86,                         /* VMCTRL2 */
    0xB1, 2, 0x00, 0x13,                   /* FRMCTR1: 100 pictures a second */
    0xF2, 1, 0x00,                         /* three gammas off */
    0x26, 1, 0x01,                         /* GAMSET */
    /* PGAMCTRL, NGAMCTRL */
    0xE0, 15, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00, 0xE1, 15, 0x00,
    0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F, 0xB6, 3, 0x08, 0xC2,
    0x27,                           /* DISCTRL: GS, 320 lines */
    0x3A, 1, 0x55,                  /* PIXSET: 16 bits a pixel */
    0x11, 0 | PANEL_DELAY, 120 / 5, /* SLPOUT */
};

static const uint8_t on[] = {0x29, 0 | PANEL_DELAY, 100 / 5};         /* DISPON */
static const uint8_t off[] = {0x28, 0, 0x10, 0 | PANEL_DELAY, 5 / 5}; /* DISPOFF, SLPIN */

const struct panel_controller panel_ili9341 = {
    .reset = {reset, sizeof reset},
    .start = {start, sizeof start},
    .on = {on, sizeof on},
    .off = {off, sizeof off},
    .columns = 240,
    .rows = 320,
    .format = HAL_RGB565,
    .arguments = HAL_BUS_DATA,
    .address_bytes = 2,
    .column = 0x2A, /* CASET */
    .row = 0x2B,    /* PASET */
    .write = 0x2C,  /* RAMWR */
    .orient = 0x36, /* MADCTL: MY 80, MX 40, MV 20, BGR 08 */
    .turn = {0x08, 0xA8, 0xC8, 0x68},
    .turning = PANEL_EXCHANGES,
    .bgr = 0x08,
    .normal = 0x20,   /* DINVOFF */
    .inverted = 0x21, /* DINVON */
    .tearing = 0x35,  /* TEON */
};

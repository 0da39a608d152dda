/* SPDX-License-Identifier: MIT */
/* Sitronix ST7789V, 240x320 RGB565. Its usual glass (IPS) is normally white: INVON shows colours as they are. */
#include "panels/panel.h"

static const uint8_t reset[] = {0x01, 0 | PANEL_DELAY, 150 / 5}; /* SWRESET */

static const uint8_t start[] = {
    0xB2, 5, 0x0C, 0x0C, 0x00, 0x33, 0x33, /* PORCTRL: porches */
    0x3A, 1, 0x05,                         /* COLMOD: 16 bits a pixel */
    0xB7, 1, 0x14,                         /* GCTRL: gate voltages */
    0xBB, 1, 0x37,                         /* VCOMS */
    0xC0, 1, 0x2C,                         /* LCMCTRL */
    0xC2, 1, 0x01,                         /* VDVVRHEN: the next two count */
    0xC3, 1, 0x12,                         /* VRHS */
    0xC4, 1, 0x20,                         /* VDVS */
    0xD0, 2, 0xA4, 0xA1,                   /* PWCTRL1 */
    0xC6, 1, 0x0F,                         /* FRCTRL2: 60 pictures a second */
    /* PVGAMCTRL, NVGAMCTRL */
    0xE0, 14, 0xD0, 0x04, 0x0D, 0x11, 0x13, 0x2B, 0x3F, 0x54, 0x4C, 0x18, 0x0D, 0x0B, 0x1F, 0x23, 0xE1, 14, 0xD0, 0x04,
    0x0C, 0x11, 0x13, 0x2C, 0x3F, 0x44, 0x51, 0x2F, 0x1F, 0x1F, 0x20, 0x23, 0x11, 0 | PANEL_DELAY, 120 / 5, /* SLPOUT */
};

static const uint8_t on[] = {0x29, 0 | PANEL_DELAY, 100 / 5};         /* DISPON */
static const uint8_t off[] = {0x28, 0, 0x10, 0 | PANEL_DELAY, 5 / 5}; /* DISPOFF, SLPIN */

const struct panel_controller panel_st7789 = {
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
    .row = 0x2B,    /* RASET */
    .write = 0x2C,  /* RAMWR */
    .orient = 0x36, /* MADCTL: MY 80, MX 40, MV 20 */
    .turn = {0x00, 0xA0, 0xC0, 0x60},
    .turning = PANEL_EXCHANGES,
    .bgr = 0x08,
    .normal = 0x21,   /* INVON */
    .inverted = 0x20, /* INVOFF */
    .tearing = 0x35,  /* TEON */
};

/* SPDX-License-Identifier: MIT */
/*
 * A board with an RP2040 and a panel is data: its board.c defines `rp2040_board` (pins, buttons), `rp2040_panel` (the
 * glass) and `rp2040_app` (sizes and buffers), its link.ld the flash. rp2040.c starts any of them. boards/README.md
 * says how to add one.
 */
#ifndef BOARDS_RP2040_H
#define BOARDS_RP2040_H

#include "boards/board.h"
#include "input.h"
#include "panels/panel.h"
#include "rp2040/rp2040.h"

extern struct panel rp2040_panel;     /* without its bus */
extern const struct board rp2040_app; /* display: &rp2040_panel.display */

#endif

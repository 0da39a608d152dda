/* SPDX-License-Identifier: MIT */
/* What a panel says on its bus. All return 0 or HAL_E_IO and count the bytes in panel->sent. */
#ifndef HAL_PANELS_WIRE_H
#define HAL_PANELS_WIRE_H

#include "panels/panel.h"

int wire_command(struct panel *panel, uint8_t command, const uint8_t *arguments, uint32_t count);

/* Sends a table of commands; waits at most `longest` ms for each. */
int wire_table(struct panel *panel, struct panel_table table, uint32_t longest);

/* Opens a window, counted from the glass's first pixel as turned by the controller, and leaves the bus ready for its
 * pixels. Even x and width where a byte has two pixels. */
int wire_window(struct panel *panel, uint32_t x, uint32_t y, uint32_t width, uint32_t height);

/* Bytes of a window's commands. */
uint32_t wire_window_bytes(const struct panel_controller *controller);

/* Sends `rows` rows of panel->row_bytes, or of `bytes` where a panel is turned by software. May return early. */
int wire_pixels(struct panel *panel, const void *pixels, uint32_t bytes, uint32_t rows, uint32_t stride);

#endif

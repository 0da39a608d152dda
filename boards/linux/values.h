/* SPDX-License-Identifier: MIT */
/* Values of options, read strictly: 1, and the value, or 0 with nothing changed. */
#ifndef BOARDS_LINUX_VALUES_H
#define BOARDS_LINUX_VALUES_H

#include "linux/keys.h"
#include "linux/wires.h"

int values_number(const char *text, uint32_t low, uint32_t high, uint32_t *value);
int values_short(const char *text, uint32_t low, uint32_t high, uint16_t *value);
int values_size(const char *text, uint16_t *width, uint16_t *height); /* 240x320 */
int values_hertz(const char *text, uint32_t *value);                  /* 62500000, 62.5M, 500k */
int values_switch(const char *text, uint8_t *value);                  /* on, off; null: on */

/* A line, with ! before it if low is on; `none`. */
int values_pin(char *text, struct wires_pin *pin);

/* up=6,down=19,a=13; `none`. Writes zeros into the text. */
int values_keys(char *text, struct keys_config *keys);

#endif

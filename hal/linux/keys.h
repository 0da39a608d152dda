/* SPDX-License-Identifier: MIT */
/* Buttons on GPIO lines, as hal/input.h; and the signals that end a program, as HAL_QUIT. */
#ifndef HAL_LINUX_KEYS_H
#define HAL_LINUX_KEYS_H

#include "input.h"
#include "linux/pins.h"

#define KEYS_SETTLE_US 10000u /* longer than a button bounces */

struct keys_config {
    const char *chip;
    unsigned count;
    const char *line[GPIO_LINES];
    uint16_t button[GPIO_LINES]; /* enum hal_button */
    uint8_t high;                /* 1: pressed is high, pulled down; 0: pressed is low, pulled up */
};

/* Takes the lines, none if count is 0: from now on input_buttons() knows them. 0, or HAL_E_IO and the problem. */
int keys_open(const struct keys_config *config, struct problem *problem);
void keys_close(void);

/* SIGINT, SIGTERM and SIGHUP become HAL_QUIT from now on, unless the program was started with them ignored. */
void keys_catch_signals(void);

#endif

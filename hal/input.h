/* SPDX-License-Identifier: MIT */
/* Buttons. One implementation is linked: the machine's. */
#ifndef HAL_INPUT_H
#define HAL_INPUT_H

#include <stdint.h>

enum hal_button {
    HAL_UP = 1 << 0,
    HAL_DOWN = 1 << 1,
    HAL_LEFT = 1 << 2,
    HAL_RIGHT = 1 << 3,
    HAL_A = 1 << 4,
    HAL_B = 1 << 5,
    HAL_X = 1 << 6,
    HAL_Y = 1 << 7,
    HAL_QUIT = 1 << 8, /* no button: the program is to end, where there is something to go back to */
};

/* The buttons held now: a set of enum hal_button. */
uint32_t input_buttons(void);

#endif

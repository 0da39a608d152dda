/* SPDX-License-Identifier: MIT */
/* Stellaris LM3S6965 Evaluation Board, https://www.ti.com/tool/EKI-LM3S6965 (revisions A and B: OLED OSRAM 128x64).
 * Pins as in its manual, each fact once. */
#ifndef LM3S6965EVB_H
#define LM3S6965EVB_H

#include "lm3s/lm3s.h"

/* clang-format off */
#define BOARD_OLED_DC    ((struct lm3s_pins){LM3S_GPIOC, 1u << 7})
#define BOARD_OLED_POWER ((struct lm3s_pins){LM3S_GPIOC, 1u << 6}) /* its 15 V */
#define BOARD_CARD_CS    ((struct lm3s_pins){LM3S_GPIOD, 1u << 0}) /* low selects the SD card on the same wires */
#define BOARD_KEYS                                  \
    {{LM3S_GPIOE, 1u << 0}, HAL_UP},                \
    {{LM3S_GPIOE, 1u << 1}, HAL_DOWN},              \
    {{LM3S_GPIOE, 1u << 2}, HAL_LEFT},              \
    {{LM3S_GPIOE, 1u << 3}, HAL_RIGHT},             \
    {{LM3S_GPIOF, 1u << 1}, HAL_A} /* "select" */
/* clang-format on */

/* 50 MHz / (2 * 7) = 3.6 MHz: the SSD0323 takes a bit in 250 ns at the least. */
#define BOARD_OLED_DIVIDER 2
#define BOARD_OLED_RATE    6

#define BOARD_OLED_REFRESH 600 /* pictures: all its registers anew every 10 s */

#define BOARD_WIDTH     128
#define BOARD_HEIGHT    64
#define BOARD_BAND_ROWS 16
#define BOARD_MEMORY    (54u * 1024) /* of 64 KiB: the rest is bands and stack */

#endif

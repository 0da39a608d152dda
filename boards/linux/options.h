/* SPDX-License-Identifier: MIT */
/* The options of `glint-device`, and what each does to the settings. */
#ifndef BOARDS_LINUX_OPTIONS_H
#define BOARDS_LINUX_OPTIONS_H

#include "boards/linux/settings.h"

enum option_id {
    OPTION_BOARD,
    OPTION_PANEL,
    OPTION_SIZE,
    OPTION_ROTATE,
    OPTION_BGR,
    OPTION_INVERT,
    OPTION_OFFSET_X,
    OPTION_OFFSET_Y,
    OPTION_WHOLE,
    OPTION_REFRESH,
    OPTION_SPI,
    OPTION_SPI_MODE,
    OPTION_SPEED,
    OPTION_CHIP,
    OPTION_DC,
    OPTION_RESET,
    OPTION_BACKLIGHT,
    OPTION_SCK,
    OPTION_MOSI,
    OPTION_CS,
    OPTION_KEYS,
    OPTION_KEYS_HIGH,
    OPTION_STREAM,
    OPTION_UDC,
    OPTION_USB_SERIAL,
    OPTION_SCENE,
    OPTION_METHOD,
    OPTION_BUDGET,
    OPTION_DITHER,
    OPTION_FPS,
    OPTION_FIGURES,
    OPTION_STILL,
    OPTION_TIME,
    OPTION_STEP,
    OPTION_FRAMES,
    OPTION_TEST_PATTERN,
    OPTION_OFF,
    OPTION_LIST,
    OPTION_HELP,
    OPTIONS
};

struct option_text {
    const char *name, *value, *help; /* value null: a switch, on or off */
};
extern const struct option_text options_text[OPTIONS];

/* 1, or 0 if `text` is no value of the option; null for a switch without one. The text stays in use. */
int options_set(struct settings *settings, enum option_id option, char *text);

#endif

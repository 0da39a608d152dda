/* SPDX-License-Identifier: MIT */
/* What `glint-device` is told by its command line and by a board file: the same names in both, a file's first. */
#ifndef BOARDS_LINUX_SETTINGS_H
#define BOARDS_LINUX_SETTINGS_H

#include "app/app.h"
#include "linux/keys.h"
#include "linux/usb_stream.h"
#include "linux/wires.h"
#include "panels/panel.h"

#define SETTINGS_BOARD "/etc/glint/board.conf" /* the board file where --board does not say */

#define SETTINGS_SERIAL 63u /* characters of a USB serial number at the most */

enum settings_exit { SETTINGS_DONE, SETTINGS_BAD_DATA, SETTINGS_BAD_USAGE, SETTINGS_DEVICE };
enum settings_task { SETTINGS_PLAY, SETTINGS_PATTERN, SETTINGS_LIST, SETTINGS_OFF, SETTINGS_HELP };

struct settings {
    enum settings_task task;
    struct wires_config wires;
    struct keys_config keys;
    const struct panel_controller *controller;
    uint16_t width, height, offset_x, offset_y, rotation, refresh; /* as in panel.h */
    uint8_t bgr, invert, whole;                                    /* whole: every row of every picture is sent */
    uint8_t dither, dithers;                                       /* dithers: it was said */
    uint8_t bare;                                                  /* no panel: a controller is not needed */
    uint8_t usb;                                                   /* pictures go to a USB host */
    const char *udc, *serial;                                      /* of USB; null: not said */
    struct app_start start;
    char *text; /* the board file, to be freed: strings above are in it or in argv */
};

/* -1 to go on, or the exit code, with its message told. */
int settings_read(struct settings *settings, int argc, char **argv);

/* Prints every option. */
void settings_help(void);

/* The controllers by name, up to a null name; of "none" it is null. */
struct settings_panel {
    const char *name;
    const struct panel_controller *controller;
    uint16_t width, height; /* of its usual glass */
};
extern const struct settings_panel settings_panels[];

#endif

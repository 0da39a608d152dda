/* SPDX-License-Identifier: MIT */
/* What the keys of the window do. Knows no window: who draws it hands in the keys and does what is found here. */
#ifndef VIEW_CONTROLS_H
#define VIEW_CONTROLS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* A key is the letter that is on it, or one of these. */
enum controls_key {
    CONTROLS_ESCAPE = 27,
    CONTROLS_UP = 256,
    CONTROLS_DOWN,
    CONTROLS_LEFT,
    CONTROLS_RIGHT,
    CONTROLS_PAGE_UP,
    CONTROLS_PAGE_DOWN,
    CONTROLS_F1,
    CONTROLS_F11,
};

struct controls {
    uint32_t buttons;  /* the device's, held now, as in STREAM_BUTTONS */
    uint32_t taps;     /* pressed, though maybe released again, since this was last zeroed, by who tells the device */
    unsigned rotation; /* quarter turns, clockwise */
    bool fullscreen, paused, figures, details, help;
    /* asked for since these were last zeroed, by whoever does it */
    unsigned scale, steps; /* scale: 0: as it is */
    int scene, method, budget;
    bool motion, picture, window, film, quit;
};

/* `again`: the key was held already and repeats. */
void controls_press(struct controls *controls, int key, bool shift, bool again);
void controls_release(struct controls *controls, int key);

/* The window has lost the keyboard: all buttons are released. */
void controls_leave(struct controls *controls);

/* Line by line what the keys do: `key` and `does` end with null behind the last. */
struct controls_help {
    const char *key, *does;
};
extern const struct controls_help controls_help[];

/* The same for --help. */
void controls_print(FILE *out);

#endif

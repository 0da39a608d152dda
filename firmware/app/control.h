/* SPDX-License-Identifier: MIT */
/*
 * What the buttons do: the state that they change, apart from any display, clock or board.
 *
 * Arrows that are held turn the object, a quarter turn a second. A opens and closes a menu: there up and down choose a
 * line, left and right change what it says; held, they do it again and again. B stops the animation or lets it go on, X
 * takes the next method, Y the next scene.
 */
#ifndef APP_CONTROL_H
#define APP_CONTROL_H

#include <stdint.h>

/* The menu's lines from the top, and what left and right do there. */
enum control_line {
    CONTROL_LINE_SCENE,  /* the one before, the next */
    CONTROL_LINE_METHOD, /* the same */
    CONTROL_LINE_BUDGET, /* a smaller error, a larger one */
    CONTROL_LINE_MOTION, /* stops the animation, lets it go on */
    CONTROL_LINE_TIME,   /* stops it and goes 100 ms back or on */
    CONTROL_LINE_TURN,   /* the object as it was */
    CONTROL_LINE_INFO,   /* figures: none, or shown */
    CONTROL_LINE_SCREEN, /* sends the whole picture anew; shows the display's test while held */
    CONTROL_LINES
};

/* What a step has changed: a set. */
enum control_effect {
    CONTROL_DRAW = 1 << 0,    /* what is to be seen */
    CONTROL_REPORT = 1 << 1,  /* and that is to be told */
    CONTROL_READY = 1 << 2,   /* scene, method or budget: the renderer is to be made ready for them */
    CONTROL_REPAINT = 1 << 3, /* all rows are to be sent */
};

#define CONTROL_BUDGET 4u /* 1/255ths, to begin with */

struct control {
    uint16_t scenes, methods; /* how many there are: set before control_start() */
    uint16_t scene, method;   /* which of them */
    uint8_t budget;           /* 1/255ths that a pixel may err, 1..255 */
    uint8_t running, figures;
    uint8_t menu, line;  /* open; enum control_line */
    uint8_t test;        /* the display's test is shown while this button is held */
    uint16_t yaw, pitch; /* 1/65536 turns, for glint_turn() */
    uint32_t moment_ms;  /* of the animation */

    /* its own */
    uint32_t held;      /* buttons at the last step ... */
    uint32_t ignored;   /* ... and those that do nothing until they are released */
    uint32_t repeat_us; /* until a held arrow acts again */
    uint32_t moment_us; /* part of a millisecond, not yet in the moment */
    uint32_t turn_part; /* part of an angle */
};

/* `buttons` are those held at start (enum hal_button): they do nothing, except that one alone asks for the display's
 * test until it is released. */
void control_start(struct control *control, uint32_t buttons);

/* Buttons held now, or at some time since the last step, which was so long ago: a set of enum control_effect. */
unsigned control_step(struct control *control, uint32_t buttons, uint32_t elapsed_us);

#endif

/* SPDX-License-Identifier: MIT */
#include "view/controls.h"

#include <stddef.h>

const struct controls_help controls_help[] = {{"arrows, abxy", "the device's buttons"},
                                              {"m, shift m", "the next method, the one before"},
                                              {"page down, up", "the next scene, the one before"},
                                              {"+, -", "budget: more, less"},
                                              {"p", "the device's animation: stop, go on"},
                                              {"1 to 6", "size of a pixel"},
                                              {"r, shift r", "rotate by 90 degrees, back"},
                                              {"f, F11", "fullscreen"},
                                              {"space", "the picture: hold, go on"},
                                              {".", "the next picture"},
                                              {"o, shift o", "figures, more of them"},
                                              {"s", "save the picture: picture-NNNN.png"},
                                              {"w", "save the window: window-NNNN.png"},
                                              {"v", "record, end that: recording-NNNN.png"},
                                              {"h, F1", "this list"},
                                              {"q, escape", "end"},
                                              {NULL, NULL}};

void controls_print(FILE *out)
{
    for (const struct controls_help *line = controls_help; line->key; line++)
        fprintf(out, "      %-18s %s\n", line->key, line->does);
}

/* The device's button on a key, or 0. */
static uint32_t controls_button(int key)
{
    static const int keys[] = {CONTROLS_UP, CONTROLS_DOWN, CONTROLS_LEFT, CONTROLS_RIGHT, 'a', 'b', 'x', 'y'};
    for (unsigned i = 0; i < sizeof keys / sizeof *keys; i++)
        if (keys[i] == key)
            return 1u << i;
    return 0;
}

/* What is done once a press. */
static void controls_once(struct controls *c, int key, int step)
{
    switch (key) {
    case 'r':
        c->rotation = (c->rotation + (unsigned)step) & 3;
        break;
    case 'f':
    case CONTROLS_F11:
        c->fullscreen = !c->fullscreen;
        break;
    case ' ':
        c->paused = !c->paused;
        c->steps = 0;
        break;
    case 'o':
        c->details ^= step < 0;
        c->figures = step < 0 || !c->figures;
        break;
    case 'h':
    case CONTROLS_F1:
        c->help = !c->help;
        break;
    case 'm':
        c->method += step;
        break;
    case 'p':
        c->motion = !c->motion;
        break;
    case 's':
        c->picture = true;
        break;
    case 'w':
        c->window = true;
        break;
    case 'v':
        c->film = true;
        break;
    case CONTROLS_ESCAPE: /* out of fullscreen first */
        c->quit = !c->fullscreen;
        c->fullscreen = false;
        break;
    case 'q':
        c->quit = true;
        break;
    default:
        if (key >= '1' && key <= '6')
            c->scale = (unsigned)(key - '0');
    }
}

void controls_press(struct controls *c, int key, bool shift, bool again)
{
    c->buttons |= controls_button(key);
    c->taps |= controls_button(key);
    switch (key) {
    case '.':
        c->paused = true;
        c->steps++;
        break;
    case '+':
    case '=': /* where + is with shift */
        c->budget++;
        break;
    case '-':
        c->budget--;
        break;
    case CONTROLS_PAGE_DOWN:
        c->scene++;
        break;
    case CONTROLS_PAGE_UP:
        c->scene--;
        break;
    default:
        if (!again)
            controls_once(c, key, shift ? -1 : 1);
    }
}

void controls_release(struct controls *c, int key)
{
    c->buttons &= ~controls_button(key);
}

void controls_leave(struct controls *c)
{
    c->buttons = 0;
}

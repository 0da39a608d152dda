/* SPDX-License-Identifier: MIT */
#include "app/control.h"
#include "input.h"

#define CONTROL_ARROWS     (HAL_UP | HAL_DOWN | HAL_LEFT | HAL_RIGHT)
#define CONTROL_STEP_MS    100u
#define CONTROL_DELAY_US   500000u /* until a held arrow repeats in the menu ... */
#define CONTROL_REPEAT_US  150000u /* ... and then */
#define CONTROL_LONGEST_US 1000000u

static const uint8_t control_budgets[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};

/* 1 for the second button alone, -1 for the first, else 0. */
static int control_way(uint32_t held, uint32_t back, uint32_t forth)
{
    return (held & forth ? 1 : 0) - (held & back ? 1 : 0);
}

static uint16_t control_around(unsigned value, int way, unsigned count)
{
    return (uint16_t)((value + (way < 0 ? count - 1 : 1)) % count);
}

static uint8_t control_budget(unsigned budget, int way)
{
    const unsigned count = sizeof control_budgets;
    unsigned i = 0;
    while (i < count - 1 && control_budgets[i] < budget)
        i++;
    if (way > 0 && control_budgets[i] <= budget && i < count - 1)
        i++;
    else if (way < 0 && i > 0)
        i--;
    return control_budgets[i];
}

static void control_go(struct control *c, int way)
{
    if (way > 0)
        c->moment_ms += CONTROL_STEP_MS;
    else
        c->moment_ms -= c->moment_ms < CONTROL_STEP_MS ? c->moment_ms : CONTROL_STEP_MS;
    c->running = 0;
}

/* Left (-1) or right (1) on a line of the menu. */
static unsigned control_change(struct control *c, enum control_line line, int way)
{
    const unsigned shown = CONTROL_DRAW | CONTROL_REPORT;
    switch (line) {
    case CONTROL_LINE_SCENE:
        c->scene = control_around(c->scene, way, c->scenes);
        return shown | CONTROL_READY;
    case CONTROL_LINE_METHOD:
        c->method = control_around(c->method, way, c->methods);
        return shown | CONTROL_READY;
    case CONTROL_LINE_BUDGET:
        c->budget = control_budget(c->budget, way);
        return shown | CONTROL_READY;
    case CONTROL_LINE_MOTION:
        c->running = way > 0;
        return shown;
    case CONTROL_LINE_TIME:
        control_go(c, way);
        return shown;
    case CONTROL_LINE_TURN:
        c->yaw = c->pitch = 0;
        return shown;
    case CONTROL_LINE_INFO:
        c->figures = way > 0;
        return shown;
    default: /* CONTROL_LINE_SCREEN */
        if (way > 0)
            c->test = HAL_RIGHT;
        return shown | CONTROL_REPAINT;
    }
}

/* Buttons that act in the menu: the newly pressed, and arrows that have been held for long. */
static uint32_t control_repeated(struct control *c, uint32_t pressed, uint32_t elapsed_us)
{
    uint32_t arrows = c->held & CONTROL_ARROWS;
    if (pressed & CONTROL_ARROWS) {
        c->repeat_us = CONTROL_DELAY_US;
        return pressed;
    }
    c->repeat_us -= c->repeat_us < elapsed_us ? c->repeat_us : elapsed_us;
    if (!arrows || c->repeat_us)
        return pressed;
    c->repeat_us = CONTROL_REPEAT_US;
    return pressed | arrows;
}

static unsigned control_menu(struct control *c, uint32_t pressed)
{
    int line = control_way(pressed, HAL_UP, HAL_DOWN), way = control_way(pressed, HAL_LEFT, HAL_RIGHT);
    if (line) {
        c->line = (uint8_t)control_around(c->line, line, CONTROL_LINES);
        return CONTROL_DRAW | CONTROL_REPORT;
    }
    return way ? control_change(c, (enum control_line)c->line, way) : 0;
}

/* Turns by the arrows that were held during the last step; their release is told. */
static unsigned control_turn(struct control *c, uint32_t before, uint32_t elapsed_us)
{
    int right = control_way(before, HAL_LEFT, HAL_RIGHT), up = control_way(before, HAL_DOWN, HAL_UP);
    unsigned ended = (before & CONTROL_ARROWS) && !(c->held & CONTROL_ARROWS) ? CONTROL_DRAW | CONTROL_REPORT : 0;
    if (!right && !up) {
        c->turn_part = 0;
        return ended;
    }
    /* 16,384 a second: 256 in 15,625 us. Both below 2^28. */
    uint32_t way = (elapsed_us < CONTROL_LONGEST_US ? elapsed_us : CONTROL_LONGEST_US) * 256u + c->turn_part;
    c->turn_part = way % 15625u;
    c->yaw = (uint16_t)(c->yaw + right * (int)(way / 15625u));
    c->pitch = (uint16_t)(c->pitch + up * (int)(way / 15625u));
    return ended | CONTROL_DRAW;
}

static unsigned control_advance(struct control *c, uint32_t elapsed_us)
{
    if (!c->running)
        return 0;
    uint32_t us = c->moment_us + elapsed_us % 1000u;
    c->moment_ms += elapsed_us / 1000u + us / 1000u;
    c->moment_us = us % 1000u;
    return CONTROL_DRAW;
}

void control_start(struct control *c, uint32_t buttons)
{
    c->ignored = buttons;
    c->test = (uint8_t)(buttons & (buttons - 1) ? 0 : buttons);
}

unsigned control_step(struct control *c, uint32_t buttons, uint32_t elapsed_us)
{
    if (c->test) {
        c->test &= (uint8_t)buttons;
        c->ignored = buttons;
        c->held = 0;
        return c->test ? 0 : CONTROL_DRAW | CONTROL_REPORT;
    }
    c->ignored &= buttons;
    uint32_t before = c->held, pressed = buttons & ~c->ignored & ~before;
    c->held = buttons & ~c->ignored;
    unsigned effect = control_advance(c, elapsed_us);
    if (pressed & HAL_B) {
        c->running ^= 1;
        effect |= CONTROL_DRAW | CONTROL_REPORT;
    }
    if (pressed & HAL_X)
        effect |= control_change(c, CONTROL_LINE_METHOD, 1);
    if (pressed & HAL_Y)
        effect |= control_change(c, CONTROL_LINE_SCENE, 1);
    if (pressed & HAL_A) {
        c->menu ^= 1;
        return effect | CONTROL_DRAW | CONTROL_REPORT;
    }
    return effect |
           (c->menu ? control_menu(c, control_repeated(c, pressed, elapsed_us)) : control_turn(c, before, elapsed_us));
}

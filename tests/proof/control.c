/* SPDX-License-Identifier: MIT */
/*
 * Buttons of any bits, steps of any length, by themselves or told by the other end of the line, in any order.
 *
 *   proves: control_way control_around control_budget control_go control_change control_repeated control_menu
 *           control_turn control_advance control_start control_step
 *   options: -eva-precision 3
 */
#include "proof.h"

#include "firmware/app/control.c"

static void press(uint16_t scenes, uint16_t methods)
{
    struct control c = {.scenes = scenes, .methods = methods, .budget = (uint8_t)any_u32(1, 255)};
    c.moment_ms = ANY_U32;
    control_start(&c, ANY_U32);
    while (any_flag()) {
        unsigned effect = control_step(&c, ANY_U32, ANY_U32);
        //@ assert effect < 2 * CONTROL_REPAINT;
        //@ assert c.scene < scenes && c.method < methods && c.line < CONTROL_LINES && 1 <= c.budget;
        //@ assert c.menu <= 1 && c.running <= 1 && c.moment_us < 1000 && c.turn_part < 15625;
    }
}

void prove(void)
{
    press(1, 1);
    press(3, 20);
    press(65535, 65535);
}

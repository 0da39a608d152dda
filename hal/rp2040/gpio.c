/* SPDX-License-Identifier: MIT */
#include "input.h"
#include "rp2040/registers.h"
#include "rp2040/rp2040.h"

void rp2040_pin(unsigned pin, unsigned function, uint32_t pad)
{
    REG(PAD(pin)) = pad;
    REG(IO_CTRL(pin)) = function;
}

void rp2040_level(unsigned pin, int level)
{
    REG(level ? SIO_GPIO_OUT_SET : SIO_GPIO_OUT_CLR) = 1u << pin;
}

void rp2040_output(unsigned pin, int level)
{
    rp2040_level(pin, level);
    REG(SIO_GPIO_OE_SET) = 1u << pin;
    rp2040_pin(pin, PIN_SIO, PAD_INPUT | PAD_DRIVE_4MA);
}

void rp2040_buttons_start(void)
{
    for (unsigned i = 0; i < rp2040_board.button_count; i++)
        rp2040_pin(rp2040_board.buttons[i].pin, PIN_SIO, PAD_INPUT | PAD_PULL_UP | PAD_SCHMITT);
}

uint32_t input_buttons(void)
{
    uint32_t levels = REG(SIO_GPIO_IN), held = 0;
    for (unsigned i = 0; i < rp2040_board.button_count; i++)
        if (!(levels & 1u << rp2040_board.buttons[i].pin))
            held |= rp2040_board.buttons[i].button;
    return held;
}

/* SPDX-License-Identifier: MIT */
/* GPIO (data sheet 8) and the keys on it. */
#include "input.h"
#include "lm3s/lm3s.h"

#define PINS_DIRECTION 0x400u
#define PINS_ALTERNATE 0x420u
#define PINS_OPEN      0x50Cu /* open drain: high drives nothing */
#define PINS_PULL_UP   0x510u
#define PINS_DIGITAL   0x51Cu

void lm3s_pins_output(struct lm3s_pins pins, int high)
{
    LM3S_REGISTER(pins.port, PINS_DIRECTION) |= pins.mask;
    lm3s_pins_write(pins, high);
    LM3S_REGISTER(pins.port, PINS_DIGITAL) |= pins.mask;
}

/* High before they are inputs, without driving a pin that may be held low: an emulated pin keeps its last level until
 * something outside changes it, a real one is charged at once. */
void lm3s_pins_pulled_up(struct lm3s_pins pins)
{
    LM3S_REGISTER(pins.port, PINS_PULL_UP) |= pins.mask;
    LM3S_REGISTER(pins.port, PINS_OPEN) |= pins.mask;
    lm3s_pins_output(pins, 1);
    LM3S_REGISTER(pins.port, PINS_DIRECTION) &= ~pins.mask;
    LM3S_REGISTER(pins.port, PINS_OPEN) &= ~pins.mask;
}

void lm3s_pins_alternate(struct lm3s_pins pins)
{
    LM3S_REGISTER(pins.port, PINS_ALTERNATE) |= pins.mask;
    LM3S_REGISTER(pins.port, PINS_DIGITAL) |= pins.mask;
}

void lm3s_keys_start(void)
{
    for (const struct lm3s_key *key = lm3s_keys; key->pin.mask; key++)
        lm3s_pins_pulled_up(key->pin);
}

uint32_t input_buttons(void)
{
    uint32_t held = 0;
    for (const struct lm3s_key *key = lm3s_keys; key->pin.mask; key++)
        if (!lm3s_pins_read(key->pin))
            held |= key->button;
    return held;
}

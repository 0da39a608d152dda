/* SPDX-License-Identifier: MIT */
/*
 * Numbers, sizes and frequencies in options and board files: any text, here of up to 99 bytes, of which a number's
 * digits may be as many.
 *
 *   proves: numbers_digits numbers_whole numbers_size values_number values_short values_size values_hertz values_pin
 *   options: -eva-precision 3 -eva-split-return full
 */
#include "proof.h"

#include "boards/linux/values.c"
#include "hal/host/numbers.c"

void prove(void)
{
    char text[100];
    uint32_t value = 0;
    uint16_t width = 0, height = 0;
    struct wires_pin pin;
    any_bytes(text, sizeof text - 1);
    text[sizeof text - 1] = 0;
    if (values_number(text, 1, 255, &value)) {
        //@ assert 1 <= value <= 255;
    }
    values_number(text, any_u32(0, 1), ANY_U32, &value);
    values_short(text, 0, 65535, &width);
    if (values_size(text, &width, &height)) {
        //@ assert 1 <= width <= 320 && 1 <= height <= 320;
    }
    values_hertz(text, &value);
    if (text[0])
        values_pin(text, &pin);
}
